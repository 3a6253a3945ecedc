"""Participants in real workers: flow control, floods and chance. See peers/."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from browser import Scripted, Serve
from memory import resident
from playwright.sync_api import Browser
from scenario import play_peers

pytestmark = [pytest.mark.firefox, pytest.mark.webkit]


@pytest.fixture
def play(any_tab: Scripted, serve: Serve, tmp_path: Path) -> Any:
    """A function that plays a scene with workers and returns what it returns."""
    return play_peers(any_tab, serve, tmp_path)


def test_a_reader_that_is_blocked_gets_the_newest_and_little_else(play: Any) -> None:
    """A window is under way when it stops, and the depth of the publisher waits for it."""
    assert play("""
      const [a, b] = [start(), start()];
      const p = await a.ask("create", { kind: "publisher", topic: "/t", qos: { depth: 5 } });
      const s = await b.ask("create", { kind: "subscription", topic: "/t", qos: { depth: 5000 } });
      await until(() => a.ask("matched", { id: p }));
      const blocked = b.ask("block", { duration: 1000 });
      await a.ask("publish", { id: p, count: 10000 });
      await blocked;
      await until(async () => (await b.ask("heard", { id: s })).last[0] === 10000);
      const lost = await b.ask("event", { id: s, kind: "lost" });
      await until(() => graph.topics()[0].missed > 0);
      const { count } = await b.ask("heard", { id: s });
      return [count, lost.total, graph.topics()[0].missed, await b.ask("faults")];
    """) == [1024 + 5, 10_000 - 1029, 10_000 - 1029, []]


def test_who_keeps_all_waits_for_who_wants_all(play: Any) -> None:
    assert play("""
      const [a, b, c] = [start(), start(), start()];
      const all = { keepAll: true };
      const p = await a.ask("create", { kind: "publisher", topic: "/t", qos: all });
      const s = await b.ask("create", { kind: "subscription", topic: "/t", qos: all });
      const some = { ...all, reliable: false };
      const t = await c.ask("create", { kind: "subscription", topic: "/t", qos: some });
      await until(async () => (await a.ask("matched", { id: p })) === 2);
      b.ask("eat", { count: 0 });
      await a.ask("publish", { id: p, count: 20000 });
      // The one that may lose messages does not wait for the one that may not.
      await until(async () => (await c.ask("heard", { id: t })).count === 1024 + 5000);
      const published = await a.ask("published", { id: p });
      b.ask("eat", { count: Infinity });
      await until(async () => (await b.ask("heard", { id: s })).count === 20000);
      return [published, await b.ask("faults"), await a.ask("waiting")];
    """) == [1024 + 5000, [], False]


def test_messages_of_nothing_and_of_a_quarter_of_a_gigabyte(play: Any) -> None:
    assert play("""
      const [a, b, qos] = [start(), start(), { keepAll: true }];
      const p = await a.ask("create", { kind: "publisher", topic: "/t", qos });
      const s = await b.ask("create", { kind: "subscription", topic: "/t", qos });
      await until(() => a.ask("matched", { id: p }));
      for (const size of [4, 256 * 1024 * 1024, 4, 256 * 1024 * 1024, 4]) {
        await a.ask("publish", { id: p, count: 1, size });
      }
      await until(async () => (await b.ask("heard", { id: s })).count === 5);
      return [await b.ask("faults"), complaints];
    """) == [[], []]


# Once, Chromium did not come back from ending a worker that floods, and the run stood still.
@pytest.mark.exhaustive
def test_a_peer_that_is_killed_leaves_no_trace(play: Any) -> None:
    """Its peers are in the middle of publishing to it and hearing from it, again and again."""
    assert play("""
      const [a, b] = [start(), start()];
      const topics = { kind: "publisher", topic: "/to", qos: { keepAll: true } };
      const p = await a.ask("create", topics);
      const s = await b.ask("create", { kind: "subscription", topic: "/from" });
      let flooding = true;
      const flood = (async () => {
        while (flooding) await a.ask("publish", { id: p, count: 500 });
      })();
      for (let turn = 0; turn < 50; turn++) {
        const c = start();
        await c.ask("create", { kind: "subscription", topic: "/to", qos: { keepAll: true } });
        const q = await c.ask("create", { kind: "publisher", topic: "/from" });
        const before = (await b.ask("heard", { id: s })).count;
        c.ask("flood", { id: q, size: 1000, count: 1e9 });
        await until(async () => (await b.ask("heard", { id: s })).count > before);
        c.kill();
      }
      flooding = false;
      await flood;
      await until(async () => (await a.ask("matched", { id: p })) === 0);
      await until(async () => (await b.ask("matched", { id: s })) === 0);
      await until(async () => !(await a.ask("waiting")));
      return [graph.endpoints().length, await b.ask("faults"), complaints];
    """) == [2, [], []]


def test_foreign_nonsense_is_dropped_and_told(play: Any) -> None:
    assert play("""
      const [a, b] = [start(), start()];
      const p = await a.ask("create", { kind: "publisher", topic: "/t" });
      const s = await b.ask("create", { kind: "subscription", topic: "/t" });
      await until(() => a.ask("matched", { id: p }));
      // A worker of which we hold the port.
      let port;
      const sent = [];
      const foreign = graph.join((message) => {
        if (message.op === "link") port ??= message.port;
        if (message.op === "match") sent.push(message.remote);
      }, "foreign", (text) => complaints.push(text));
      const never = { deadline: Infinity, lifespan: Infinity, lease: Infinity };
      const qos = { depth: 1, reliable: true, ...never };
      for (const endpoint of [undefined, 7, {}, { id: 1 }, { id: -1, kind: "publisher" },
        { id: 1, kind: "monster", node: "/f", name: "/t", type: "T", qos },
        { id: 1, kind: "publisher", node: "/f", name: {}, type: "T", qos },
        { id: 1, kind: "publisher", node: "/f", name: "/t", type: "T", qos: null }]) {
        graph.receive(foreign, { op: "create", endpoint });
      }
      const refused = complaints.length;
      const endpoint = { kind: "publisher", node: "/f", name: "/t", type: "test/msg/Numbers", qos };
      graph.receive(foreign, { op: "create", endpoint: { id: 1, ...endpoint } });
      await until(() => port);
      const big = new ArrayBuffer(100);
      new DataView(big).setUint32(12, 0xffffffff, true);
      for (const nonsense of [null, "hello", 5, {}, { op: "credit" }, { op: "alive", writer: "x" },
        { op: "credit", writer: 1, reader: -1, records: 1e99, bytes: NaN }, big, new ArrayBuffer(7),
        { op: "credit", writer: p, reader: 1, records: 9e9, bytes: 9e9 }, [], new Map()]) {
        port.postMessage(nonsense);
      }
      // To a reader that is not there, and to one that is.
      const frame = new ArrayBuffer(32);
      const view = new DataView(frame);
      view.setUint32(0, 4711, true);
      view.setUint32(12, 4, true);
      port.postMessage(frame.slice(0));
      await until(() => complaints.length === refused + 2);
      await a.ask("publish", { id: p, count: 3 });
      await until(async () => (await b.ask("heard", { id: s })).count === 3);
      graph.leave(foreign);
      return [refused, complaints.slice(refused), await b.ask("faults"), graph.endpoints().length];
    """) == [
        1,
        [
            "peer refused what it sent: a frame that is not valid",
            "peer refused what it sent: messages to an endpoint that does not match",
        ],
        [],
        2,
    ]


def test_a_worker_reaches_only_what_matches_its_endpoints(play: Any) -> None:
    """A link reaches all endpoints of a worker; a forged answer, request or message does not."""
    found = play("""
      const { Participant } = await import("./runtime/participant/participant.js");
      const { DEFAULT_QOS: qos, gidOf, HEAD_SIZE, writeHead } =
        await import("./runtime/protocol.js");
      const join = (name) => {
        let participant;
        const complain = (text) => complaints.push(text);
        const id = graph.join((message) => participant.receive(message), name, complain);
        participant = new Participant(id, (message) => graph.receive(id, message));
        return participant;
      };
      const [victim, other] = [join("victim"), join("other")];
      const type = "test/msg/Numbers";
      const open = victim.create("subscription", "/v", "/open", type, qos);
      const secret = victim.create("subscription", "/v", "/secret", type, qos);
      const client = victim.create("client", "/v", "/add", type, qos);
      const service = victim.create("service", "/v", "/reset", type, qos);
      const adds = other.create("service", "/o", "/add", type, qos);
      // A worker that may publish to /open only, and has the port to its subscriber.
      let port;
      const foreign = graph.join((message) => {
        if (message.op === "link") port = message.port;
      }, "foreign", (text) => complaints.push(text));
      const forge = (reader, writer, sequence) => {
        const frame = new ArrayBuffer(HEAD_SIZE + 8);
        writeHead(new Uint8Array(frame), 0, { reader, writer, sequence, timestamp: 0 }, 4);
        port.postMessage(frame);
      };
      graph.receive(foreign, { op: "create",
        endpoint: { id: 1, kind: "publisher", node: "/f", name: "/open", type, qos } });
      const asked = victim.request(client, new Uint8Array(4));
      victim.flush();
      forge(client, 1, asked); // the answer of a server that it is not
      forge(client, 1, asked + 1); // an answer that nobody asked for
      forge(secret, 1, 1);
      forge(service, 1, 1);
      forge(service, 77, 1); // in the name of an endpoint that it does not have
      port.postMessage({ op: "alive", writer: 1, reader: secret });
      forge(open, 1, 1);
      await until(() => victim.has(open));
      await until(() => other.has(adds));
      const request = other.take(adds);
      const before = victim.filled();
      other.respond(adds, request.writer, request.sequence, new Uint8Array(4));
      other.flush();
      await until(() => victim.has(client));
      const answer = victim.take(client);
      const right = answer.writer === gidOf(2, adds) && answer.sequence === asked;
      return [before, right, victim.filled(), complaints];
    """)
    said = "victim refused what it sent: a response to a request that it did not get"
    assert found == [[1], True, [1], [said]]


def test_messages_that_arrive_before_the_news_of_their_match_wait_for_it(play: Any) -> None:
    found = play("""
      const { Participant } = await import("./runtime/participant/participant.js");
      const { HEAD_SIZE, writeHead, DEFAULT_QOS: qos } = await import("./runtime/protocol.js");
      const said = [];
      const participant = new Participant(1, (message) => said.push(message.op));
      const id = participant.create("subscription", "/v", "/t", "T", qos);
      const { port1, port2 } = new MessageChannel();
      participant.receive({ op: "link", peer: 2, port: port1 });
      for (let sequence = 1; sequence <= 3; sequence += 1) {
        const frame = new ArrayBuffer(HEAD_SIZE + 8);
        writeHead(new Uint8Array(frame), 0, { reader: id, writer: 5, sequence, timestamp: 0 }, 4);
        port2.postMessage(frame);
      }
      await new Promise((resolve) => setTimeout(resolve, 300));
      const early = participant.has(id);
      participant.receive({ op: "match", local: id, peer: 2, remote: 5, qos });
      const sequences = [];
      for (let sample; (sample = participant.take(id));) sequences.push(sample.sequence);
      return [early, sequences, said.includes("complain")];
    """)
    assert found == [False, [1, 2, 3], False]


# What publisher and subscription have, and how many messages are taken at each look, every 5 ms.
FLOODS = {
    "keep last": ({"depth": 10}, 1),
    "best effort": ({"depth": 10, "reliable": False}, 1),
    "keep all": ({"keepAll": True}, 100),
}


@pytest.mark.chromium
@pytest.mark.parametrize("kind", FLOODS)
def test_a_flood_does_not_fill_memory(browser: Browser, play: Any, kind: str) -> None:
    """Two gigabytes for a reader that is slower: what waits has a bound."""
    qos, appetite = FLOODS[kind]
    before = resident(browser)
    heard, last, faults = play(f"""
      const [a, b, qos] = [start(), start(), {json.dumps(qos)}];
      const p = await a.ask("create", {{ kind: "publisher", topic: "/t", qos }});
      const s = await b.ask("create", {{ kind: "subscription", topic: "/t", qos }});
      await until(() => a.ask("matched", {{ id: p }}));
      b.ask("eat", {{ count: {appetite} }});
      await a.ask("flood", {{ id: p, size: 100000, count: 20000 }});
      b.ask("eat", {{ count: Infinity }});
      await until(async () => (await b.ask("heard", {{ id: s }})).last[0] === 20000);
      const {{ count, last }} = await b.ask("heard", {{ id: s }});
      return [count, last[0], await b.ask("faults")];
    """)
    assert last == 20_000
    assert faults == []
    assert heard == 20_000 if kind == "keep all" else heard < 20_000
    assert resident(browser) - before < 1e9


def test_what_was_published_last_arrives_though_its_node_is_gone(play: Any) -> None:
    """As a native one that ends hands its messages to the network before."""
    assert (
        play("""
      const [b, qos] = [start(), { keepAll: true }];
      const s = await b.ask("create", { kind: "subscription", topic: "/t", qos });
      for (let turn = 0; turn < 20; turn++) {
        const a = start();
        const p = await a.ask("create", { kind: "publisher", topic: "/t", qos });
        await until(() => a.ask("matched", { id: p }));
        // What it has sent comes while its listener does something else.
        b.ask("block", { duration: 50 });
        await a.ask("publish", { id: p, count: 500 });
        await a.ask("destroyAll");
        // Firefox throws away what a worker posted in the very moment before it is terminated.
        await new Promise((resolve) => setTimeout(resolve, 100));
        a.kill();
      }
      await until(async () => (await b.ask("heard", { id: s })).count === 20 * 500);
      return b.ask("faults");
    """)
        == []
    )
