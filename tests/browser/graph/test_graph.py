"""The graph of the page and its participants, in a browser, without programs around them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from browser import Scripted, Serve
from scenario import player

pytestmark = [pytest.mark.firefox(always=True), pytest.mark.webkit(always=True)]

# A participant of each name, joined to one graph, with what a scenario needs to be short.
SETTING = """
const { Graph } = await import("./page/graph.js");
const { Participant } = await import("./participant/participant.js");
const { DEFAULT_QOS: QOS } = await import("./protocol.js");
const graph = new Graph();
const complaints = [];
function join() {
  let participant;
  const receive = (message) => participant.receive(message);
  const id = graph.join(receive, "", (text) => complaints.push(text));
  participant = new Participant(id, (message) => graph.receive(id, message));
  return { participant, leave: () => graph.leave(id) };
}
const publisher = (of, qos, topic = "/a", type = "T") =>
  of.participant.create("publisher", "/ns/talker", topic, type, { ...QOS, ...qos });
const subscription = (of, qos, topic = "/a", type = "T") =>
  of.participant.create("subscription", "/listener", topic, type, { ...QOS, ...qos });
const publish = (of, id, ...values) => {
  for (const value of values) of.participant.publish(id, new Uint8Array([value]));
};
const settle = async (...participants) => {
  for (const { participant } of participants) await participant.wait(0);
  await arrived();
};
const heard = (of, id) => {
  const values = [];
  for (let sample; (sample = of.participant.take(id)); ) values.push(sample.message[0]);
  return values;
};
"""


@pytest.fixture
def play(any_tab: Scripted, serve: Serve, tmp_path: Path) -> Any:
    """A function that runs a scenario and returns what it returns."""
    return player(any_tab, serve, tmp_path, SETTING)


def test_messages_arrive_in_order_with_what_is_known_of_them(play: Any) -> None:
    assert play("""
      const [a, b] = [join(), join()];
      const p = publisher(a), s = subscription(b);
      publish(a, p, 1, 2, 3, 4, 5, 6, 7);
      await settle(a, b);
      const samples = [];
      for (let x; (x = b.participant.take(s)); ) samples.push(x);
      const lag = samples.map((x) => x.received - x.timestamp);
      return { values: samples.map((x) => x.message[0]), sequence: samples.map((x) => x.sequence),
        publishers: new Set(samples.map((x) => x.writer)).size,
        sane: lag.every((x) => x >= 0 && x < 60e3) };
    """) == {
        "values": [1, 2, 3, 4, 5, 6, 7],
        "sequence": [1, 2, 3, 4, 5, 6, 7],
        "publishers": 1,
        "sane": True,
    }


def test_large_and_small_messages_keep_their_order(play: Any) -> None:
    assert play("""
      const [a, b] = [join(), join()];
      const p = publisher(a, { keepAll: true }), s = subscription(b, { keepAll: true });
      const sizes = [1, 70000, 3, 0, 65536, 65512, 65513, 8, 1000000];
      sizes.push(5, 5, 5, 5, 5, 20000, 50000, 7);
      for (const size of sizes) a.participant.publish(p, new Uint8Array(size).fill(size & 255));
      await settle(a, b);
      const got = [];
      for (let x; (x = b.participant.take(s)); ) {
        const size = x.message.length;
        got.push(x.message.every((byte) => byte === (size & 255)) ? size : -1);
      }
      return String(got) === String(sizes);
    """)


def test_a_subscription_keeps_the_newest_of_its_depth(play: Any) -> None:
    assert play("""
      const [a, b] = [join(), join()];
      const p = publisher(a), s = subscription(b, { depth: 3 });
      const all = subscription(b, { keepAll: true });
      publish(a, p, 1, 2, 3, 4, 5, 6, 7, 8);
      await settle(a, b);
      return [heard(b, s), heard(b, all)];
    """) == [[6, 7, 8], [1, 2, 3, 4, 5, 6, 7, 8]]


def test_one_worker_hears_itself(play: Any) -> None:
    assert play("""
      const a = join();
      const p = publisher(a), s = subscription(a);
      publish(a, p, 1, 2);
      return [heard(a, s), a.participant.matched(p), a.participant.matched(s)];
    """) == [[1, 2], 1, 1]


def test_late_comers_get_what_is_kept_for_them_and_no_more(play: Any) -> None:
    assert play("""
      const [a, b] = [join(), join()];
      const p = publisher(a, { transientLocal: true, depth: 2 });
      publish(a, p, 1, 2, 3);
      const late = subscription(b, { transientLocal: true }), plain = subscription(b);
      publish(a, p, 4);
      await settle(a, b);
      return [heard(b, late), heard(b, plain)];
    """) == [[2, 3, 4], [4]]


def test_what_does_not_suit_does_not_match_and_is_told(play: Any) -> None:
    assert play("""
      const [a, b] = [join(), join()];
      const p = publisher(a, { reliable: false });
      const reliable = subscription(b), best = subscription(b, { reliable: false });
      const durable = subscription(b, { reliable: false, transientLocal: true });
      const other = subscription(b, {}, "/a", "U");
      publish(a, p, 1);
      await settle(a, b);
      const event = (of, id, kind) => {
        const { total, policy } = of.participant.takeEvent(id, kind) ?? {};
        return [total, policy];
      };
      return {
        heard: [reliable, best, durable, other].map((s) => heard(b, s)),
        events: [event(b, reliable, "incompatible"), event(b, best, "incompatible"),
          event(b, durable, "incompatible"), event(b, other, "type"), event(a, p, "incompatible"),
          event(a, p, "type"), event(a, p, "matched"), event(a, p, "matched")],
        mismatches: graph.topics()[0].mismatches.map(({ policy }) => policy),
      };
    """) == {
        "heard": [[], [1], [], []],
        "events": [
            [1, "RELIABILITY"],
            [None, None],
            [1, "DURABILITY"],
            [1, "TYPE"],
            [2, "DURABILITY"],
            [1, "TYPE"],
            [1, ""],
            [None, None],
        ],
        "mismatches": ["RELIABILITY", "DURABILITY", "TYPE"],
    }


def test_who_leaves_is_forgotten_and_the_others_go_on(play: Any) -> None:
    assert play("""
      const [a, b, c] = [join(), join(), join()];
      const p = publisher(a), s = subscription(b), t = subscription(c);
      b.leave();
      publish(a, p, 1);
      await settle(a, c);
      const then = [heard(c, t), a.participant.matched(p), graph.topics()];
      c.participant.destroy(t);
      publish(a, p, 2);
      const alone = a.participant.matched(p);
      a.leave();
      c.leave();
      return [...then, alone, graph.topics(), graph.nodes()];
    """) == [
        [1],
        1,
        [
            {
                "name": "/a",
                "types": ["T"],
                "publishers": ["/ns/talker"],
                "subscriptions": ["/listener"],
                "missed": 0,
                "mismatches": [],
            }
        ],
        0,
        [],
        [],
    ]


def test_a_wait_ends_by_a_message_a_time_or_a_signal(play: Any) -> None:
    assert play("""
      const [a, b] = [join(), join()];
      const p = publisher(a), s = subscription(b);
      const woken = b.participant.wait(-1);
      publish(a, p, 1);
      const begin = performance.now();
      const signals = [await woken, await b.participant.wait(2), await b.participant.wait(30)];
      const waited = performance.now() - begin;
      const stopped = b.participant.wait(-1);
      b.participant.receive({ op: "stop" });
      return [...signals, await stopped, heard(b, s), waited >= 31];
    """) == [0, 0, 0, 2, [1], True]


def test_each_client_gets_its_own_answers(play: Any) -> None:
    assert play("""
      const [a, b, c] = [join(), join(), join()];
      const service = (of) => of.participant.create("service", "/server", "/add", "S", QOS);
      const client = (of) => of.participant.create("client", "/client", "/add", "S", QOS);
      const ask = (of, id, value) => of.participant.request(id, new Uint8Array([value]));
      const answers = (of, id) => {
        const got = [];
        for (let x; (x = of.participant.take(id)); ) got.push([x.sequence, x.message[0]]);
        return got;
      };
      const early = client(a);
      const lost = ask(a, early, 9);
      const s = service(b), own = client(b), other = client(c);
      await settle(a, b, c);
      const asked = [ask(a, early, 1), ask(a, early, 2), ask(c, other, 3), ask(b, own, 4)];
      await settle(a, b, c);
      const requests = [];
      for (let x; (x = b.participant.take(s)); ) requests.unshift(x);  // answered in another order
      for (const { writer, sequence, message } of requests) {
        b.participant.respond(s, writer, sequence, message.map((value) => value * 10));
      }
      await settle(b);
      const before = graph.services();
      b.leave();
      return { lost, asked, a: answers(a, early), c: answers(c, other), b: answers(b, own), before,
        ready: a.participant.matched(early), after: graph.services() };
    """) == {
        "lost": 1,
        "asked": [2, 3, 1, 1],
        "a": [[3, 20], [2, 10]],
        "b": [[1, 40]],
        "c": [[1, 30]],
        "ready": 0,
        "before": [
            {
                "name": "/add",
                "types": ["S"],
                "servers": ["/server"],
                "clients": ["/client", "/client", "/client"],
            }
        ],
        "after": [
            {"name": "/add", "types": ["S"], "servers": [], "clients": ["/client", "/client"]}
        ],
    }


def test_a_request_comes_after_what_was_announced_before_it(play: Any) -> None:
    """A service that publishes, as those of parameters do, knows of a new subscription."""
    assert play("""
      // The page is slower than the port between the two.
      let slow = () => new Promise((done) => setTimeout(done, 20));
      const late = () => {
        let participant, told = Promise.resolve();
        const receive = (message) => participant.receive(message);
        const id = graph.join(receive, "", (text) => complaints.push(text));
        participant = new Participant(id, (message) => {
          told = told.then(slow).then(() => graph.receive(id, message));
        });
        return { participant };
      };
      const [server, client] = [join(), late()];
      const service = server.participant.create("service", "/server", "/set", "S", QOS);
      const events = publisher(server, {}, "/events");
      const asking = client.participant.create("client", "/client", "/set", "S", QOS);
      await slow(); await slow(); await settle(server, client);
      const heardOf = [];
      for (let i = 1; i <= 3; i += 1) {
        const s = subscription(client, {}, "/events");
        client.participant.request(asking, new Uint8Array([i]));
        client.participant.flush();
        let request;
        while (!(request = server.participant.take(service))) await arrived();
        publish(server, events, request.message[0]);
        await settle(server, client);
        heardOf.push(heard(client, s));
      }
      // Nothing is new: it goes at once, and what is held when a program ends goes then.
      client.participant.request(asking, new Uint8Array([7]));
      await settle(client, server);
      const direct = server.participant.take(service)?.message[0];
      subscription(client, {}, "/events");
      client.participant.request(asking, new Uint8Array([8]));
      client.participant.finish();
      await arrived();
      return { heardOf, direct, last: server.participant.take(service)?.message[0], complaints };
    """) == {"heardOf": [[1], [2], [3]], "direct": 7, "last": 8, "complaints": []}


def test_a_request_of_a_server_that_left_is_answered_by_nobody(play: Any) -> None:
    assert play("""
      const [a, b, c] = [join(), join(), join()];
      const service = (of) => of.participant.create("service", "/server", "/add", "S", QOS);
      const id = a.participant.create("client", "/client", "/add", "S", QOS);
      const s = service(b);
      await settle(a, b);
      a.participant.request(id, new Uint8Array([1]));
      await settle(a);
      const { writer, sequence } = b.participant.take(s);
      b.leave();
      const t = service(c);
      await settle(a, c);
      const asked = a.participant.take(id) ?? c.participant.take(t) ?? "nothing";
      a.participant.request(id, new Uint8Array([2]));
      await settle(a);
      const request = c.participant.take(t);
      c.participant.respond(t, request.writer, request.sequence, request.message);
      await settle(c);
      const answer = a.participant.take(id);
      return [asked, sequence, answer.sequence, answer.message[0]];
    """) == ["nothing", 1, 2, 2]


def test_who_could_not_look_for_a_while_counts_each_period(play: Any) -> None:
    """A program that computes, a page that was frozen."""
    assert play("""
      const [a, b] = [join(), join()];
      const p = publisher(a, { deadline: 10 }), s = subscription(b, { deadline: 10 });
      publish(a, p, 1);
      await settle(a, b);
      const end = performance.now() + 300;
      while (performance.now() < end);
      // Both timers are due by now, and come before this one.
      await new Promise((resolve) => setTimeout(resolve, 50));
      const missed = (of, id) => of.participant.takeEvent(id, "deadline").total;
      return [missed(a, p) >= 29, missed(b, s) >= 29];
    """) == [True, True]


def test_who_looks_is_told_who_is_there_and_who_comes_and_goes(play: Any) -> None:
    assert play("""
      const [a, b, c] = [join(), join(), join()];
      const names = () =>
        a.participant.look().map(({ gid, endpoint }) => [gid % 2 ** 32, endpoint.name]);
      const own = publisher(a, {}, "/own");
      const first = publisher(b, {}, "/first");
      const before = names();
      const { changes } = a.participant;
      const second = subscription(c, {}, "/second");
      const late = publisher(b, {}, "/first");
      b.participant.destroy(first);
      const after = names();
      c.leave();
      a.participant.destroy(own);
      return [before, after, names(), a.participant.changes - changes];
    """) == [
        [[1, "/own"], [1, "/first"]],
        [[1, "/own"], [1, "/second"], [2, "/first"]],
        [[2, "/first"]],
        5,
    ]
