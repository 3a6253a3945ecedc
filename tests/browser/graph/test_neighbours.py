"""What a hostile worker sends to others through its ports, and how little of it they take."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from browser import Scripted, Serve
from scenario import play_peers

pytestmark = [pytest.mark.firefox, pytest.mark.webkit]

# A worker of which the test holds the port; `victim` subscribes to what it publishes on /open.
FOREIGN = """
      const { Participant } = await import("./runtime/participant/participant.js");
      const { DEFAULT_QOS: qos, HEAD_SIZE, writeHead } = await import("./runtime/protocol.js");
      const { BUDGETS, WINDOW } = await import("./runtime/budgets.js");
      const join = (name, largest) => {
        let participant;
        const id = graph.join((message) => participant.receive(message), name,
          (text) => complaints.push(text));
        participant = new Participant(id, (message) => graph.receive(id, message), false, largest);
        return participant;
      };
      const type = "test/msg/Numbers";
      const victim = join("victim", BUDGETS.frame);
      const open = victim.create("subscription", "/v", "/open", type, { ...qos, keepAll: true });
      let port;
      const foreign = graph.join((message) => {
        if (message.op === "link") port = message.port;
      }, "foreign", (text) => complaints.push(text));
      const announce = (id, kind, name) => graph.receive(foreign, { op: "create",
        endpoint: { id, kind, node: "/f", name, type, qos } });
      announce(1, "publisher", "/open");
      const forge = (reader, sequence, size = 4, writer = 1) => {
        const frame = new ArrayBuffer(HEAD_SIZE + size);
        writeHead(new Uint8Array(frame), 0, { reader, writer, sequence, timestamp: 0 }, size);
        port.postMessage(frame, [frame]);
      };
      const taken = (id) => {
        let count = 0;
        while (victim.take(id)) count += 1;
        return count;
      };
"""


@pytest.fixture
def play(any_tab: Scripted, serve: Serve, tmp_path: Path) -> Any:
    """A function that plays a scene of participants."""
    return play_peers(any_tab, serve, tmp_path)


def test_a_publisher_without_credits_is_not_heard(play: Any) -> None:
    """KEEP_ALL of a reader that sleeps is no memory without bound."""
    found = play(f"""{FOREIGN}
      for (let sequence = 1; sequence <= 3000; sequence += 1) forge(open, sequence);
      await until(() => graph.refused(foreign) === 3000 - WINDOW.records);
      const kept = taken(open);
      for (let sequence = 3001; sequence <= 3100; sequence += 1) forge(open, sequence, 1024 * 1024);
      await until(() => graph.refused(foreign) >= 3000 - WINDOW.records + 68);
      return [kept, taken(open), complaints];
    """)
    said = "victim refused what it sent: more messages than it had credits for"
    assert found == [1024, 32, [said]]


def test_messages_that_match_nothing_wait_within_a_budget(play: Any) -> None:
    """They might be early; all endpoints of a worker share what they may hold of another one."""
    found = play(f"""{FOREIGN}
      const secret = [1, 2, 3].map((n) =>
        victim.create("subscription", "/v", `/secret${{n}}`, type, qos));
      for (const id of secret) for (let n = 0; n < 3000; n += 1) forge(id, n + 1);
      await until(() => graph.refused(foreign) >= 9000);
      forge(4711, 1);
      await until(() => graph.refused(foreign) === 9001);
      return [secret.map(taken), complaints];
    """)
    said = "victim refused what it sent: messages to an endpoint that does not match"
    assert found == [[0, 0, 0], [said]]


def test_large_messages_that_match_nothing_wait_within_a_budget(play: Any) -> None:
    found = play(f"""{FOREIGN}
      const secret = victim.create("subscription", "/v", "/secret", type, qos);
      for (let n = 1; n <= 9; n += 1) forge(secret, n, 8 * 1024 * 1024);
      await until(() => graph.refused(foreign) === 1);
      await until(() => graph.refused(foreign) === 9);
      return taken(secret);
    """)
    assert found == 0


def test_credits_are_taken_only_from_readers(play: Any) -> None:
    found = play(f"""{FOREIGN}
      const own = victim.create("publisher", "/v", "/own", type, qos);
      port.postMessage({{ op: "credit", writer: own, reader: 1, records: 1e6, bytes: 1e9 }});
      await until(() => complaints.length);
      return complaints;
    """)
    said = (
        "victim refused what it sent: credits or a sign of life of an endpoint that does not match"
    )
    assert found == [said]


def test_a_frame_has_a_size(play: Any) -> None:
    """Millions of small records in one frame would keep its receiver for seconds."""
    found = play(f"""{FOREIGN}
      const many = new ArrayBuffer(128 * 1024);
      for (let at = 0; at < many.byteLength; at += HEAD_SIZE + 8) {{
        writeHead(new Uint8Array(many), Math.min(at, many.byteLength - HEAD_SIZE),
          {{ reader: open, writer: 1, sequence: at + 1, timestamp: 0 }}, 8);
      }}
      port.postMessage(many);
      await until(() => complaints.length === 1);
      forge(open, 1, BUDGETS.frame);
      await until(() => complaints.length === 2);
      forge(open, 1, 1024 * 1024);
      await until(() => victim.has(open));
      return [taken(open), complaints];
    """)
    assert found == [
        1,
        [
            "victim refused what it sent: a frame that is not valid",
            "victim refused what it sent: a frame that is too large",
        ],
    ]


def test_a_worker_that_goes_on_is_heard_no_more(play: Any) -> None:
    found = play(f"""{FOREIGN}
      for (let turn = 0; turn < BUDGETS.refused; turn += 1) forge(4711, 1);
      await until(() => victim.matched(open) === 0);
      forge(open, 1);
      await until(() => graph.refused(foreign) >= BUDGETS.refused);
      announce(2, "publisher", "/open");
      return [victim.matched(open), victim.has(open)];
    """)
    assert found == [0, False]


def test_requests_wait_at_their_client_while_the_server_sleeps(play: Any) -> None:
    """All of them arrive, none before the server has room, and their number has an end."""
    found = play(f"""{FOREIGN}
      const other = join("other");
      const client = other.create("client", "/o", "/add", type, qos);
      const service = victim.create("service", "/v", "/add", type, qos);
      await until(() => other.matched(client));
      let asked = 0;
      let error = "";
      try {{
        for (;;) {{
          other.request(client, new Uint8Array(8));
          asked += 1;
        }}
      }} catch (caught) {{
        error = caught.message;
      }}
      other.flush();
      await until(() => victim.has(service));
      await new Promise((resolve) => setTimeout(resolve, 100));
      const sequences = [];
      let most = 0;
      await until(() => {{
        let waiting = 0;
        for (let one; (one = victim.take(service)); waiting += 1) sequences.push(one.sequence);
        most = Math.max(most, waiting);
        victim.flush();
        return sequences.length === asked;
      }});
      const ordered = sequences.every((sequence, at) => sequence === at + 1);
      return [asked, most <= WINDOW.records, ordered, error, complaints];
    """)
    end = "5000 requests wait for /add, which takes no more"
    assert found == [6024, True, True, end, []]


def test_requests_of_many_bytes_wait_within_a_budget(play: Any) -> None:
    found = play(f"""{FOREIGN}
      const other = join("other");
      const client = other.create("client", "/o", "/add", type, qos);
      const service = victim.create("service", "/v", "/add", type, qos);
      await until(() => other.matched(client));
      let asked = 0;
      try {{
        for (;; asked += 1) other.request(client, new Uint8Array(8 * 1024 * 1024));
      }} catch {{
        other.flush();
      }}
      let came = 0;
      await until(() => {{
        came += taken(service);
        victim.flush();
        return came === asked;
      }});
      return [asked, complaints];
    """)
    assert found == [4 + 8, []]


def test_a_client_that_does_not_keep_to_its_credits_is_refused(play: Any) -> None:
    found = play(f"""{FOREIGN}
      const service = victim.create("service", "/v", "/add", type, qos);
      announce(2, "client", "/add");
      for (let sequence = 1; sequence <= 3000; sequence += 1) forge(service, sequence, 4, 2);
      await until(() => graph.refused(foreign) === 3000 - WINDOW.records);
      return [taken(service), complaints];
    """)
    assert found == [1024, ["victim refused what it sent: more messages than it had credits for"]]


def test_responses_wait_within_a_budget(play: Any) -> None:
    found = play(f"""{FOREIGN}
      announce(2, "service", "/add");
      const client = victim.create("client", "/v", "/add", type, qos);
      await until(() => victim.matched(client));
      const size = 40 * 1024 * 1024;
      for (let n = 0; n < 9; n += 1) {{
        const sequence = victim.request(client, new Uint8Array(4));
        forge(client, sequence, size, 2);
      }}
      await until(() => graph.refused(foreign) === 2);
      return [taken(client), complaints];
    """)
    assert found == [7, ["victim refused what it sent: more messages than it had credits for"]]
