"""What a hostile worker reports to the page, while others go on working."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from browser import Scripted, Serve
from scenario import player

pytestmark = [pytest.mark.firefox, pytest.mark.webkit]

# In place of the worker of ROS2WASM nodes. It has the id of the victim as its only argument.
HOSTILE = """
const never = { deadline: Infinity, lifespan: Infinity, lease: Infinity };
const qos = { depth: 1, reliable: true, ...never };
const endpoint = { id: 1, kind: "publisher", node: "/evil", name: "/chatter", type: "T", qos };
const long = "x".repeat(5000);
const odd = { toString: 1 };
const of = (op, ...rests) => rests.map((rest) => ({ op, ...rest }));
const wrong = [
  null, undefined, 7, "create", [], {}, { op: "toString" }, { op: odd }, { op: 5n },
  ...of("create", {}, { endpoint: null }, { endpoint: 7 },
    ...["id", "kind", "node", "name", "type", "qos"].flatMap((key) =>
      [null, 5n, odd, -1, [], NaN].map((value) => ({ endpoint: { ...endpoint, [key]: value } }))),
    ...["node", "name", "type"].map((key) => ({ endpoint: { ...endpoint, [key]: long } })),
    ...["depth", "deadline", "lifespan", "lease"].flatMap((key) =>
      [5n, [], [5], "5", "", null, NaN, -1, odd, true, undefined].map((value) =>
        ({ endpoint: { ...endpoint, qos: { ...qos, [key]: value } } }))),
    ...["reliable", "transientLocal", "keepAll", "manual"].map((key) =>
      ({ endpoint: { ...endpoint, qos: { ...qos, [key]: odd } } }))),
  ...of("destroy", {}, { id: null }, { id: odd }, { id: 1n }),
  ...of("missed", { id: 1 }, { id: 2, count: odd }, { id: 2, count: 5n }, { id: 2, count: "5" }),
  ...of("complain", {}, { peer: odd, what: "frame", count: 1 }, { peer: 1, what: odd, count: 1 },
    { peer: 1, what: "toString", count: 1 }, { peer: 1, what: "frame", count: -1 }),
  ...of("lines", {}, { lines: null }, { lines: "text" }, { lines: [null] }, { lines: [{}] },
    { lines: [{ severity: "info", text: odd }] }, { lines: [{ severity: odd, text: "x" }] }),
  ...of("progress", {}, { loaded: odd, total: 1 }, { loaded: 1n, total: 1 }),
  ...of("memory", {}, { bytes: odd }, { bytes: 5n }, { bytes: NaN }),
  ...of("reading", {}, { keyboard: odd }, { keyboard: "piano" }),
  ...of("ready", {}, { more: odd }),
  ...of("words", {}, { text: "x", words: null }, { text: "x", words: [odd] }),
  ...of("checked", {}, { text: "x", line: odd, error: "" }, { text: null, line: 1, error: "" }),
  ...of("exit", {}, { code: 0, error: odd }, { code: 0, error: null }, { code: odd, error: "" }),
];
onmessage = ({ data }) => {
  if (data.op !== "adopt") return;
  postMessage({ op: "running" });
  // Not yet linked to the victim.
  const { victim: peer } = data.program;
  postMessage({ op: "complain", peer, what: "frame", count: 1 });
  for (const message of [...wrong, ...wrong]) postMessage(message);
  postMessage({ op: "create", endpoint: { ...endpoint, kind: "node", name: "", id: 8 } });
  postMessage({ op: "create", endpoint: { ...endpoint, id: 9 } });
  for (let turn = 0; turn < 2; turn += 1) {
    postMessage({ op: "complain", peer, what: "frame", count: 2, text: "is a liar" });
  }
  postMessage({ op: "lines", lines: [{ severity: "info", text: "done" }] });
};
"""

SCENE = """
const uncaught = [];
addEventListener("error", (event) => uncaught.push(event.message));
addEventListener("unhandledrejection", (event) => uncaught.push(String(event.reason)));
const { Graph } = await import("./page/graph.js");
const { NodeProcess } = await import("./page/nodeProcess.js");
const { WorkerGroups } = await import("./page/workerGroup.js");
const { Participant } = await import("./participant/participant.js");
const { DEFAULT_QOS } = await import("./protocol.js");
const graph = new Graph();
const complaints = [];
const join = (name) => {
  let participant;
  const id = graph.join((message) => participant.receive(message), name,
    (text) => complaints.push(text));
  participant = new Participant(id, (message) => graph.receive(id, message));
  return { id, participant };
};
const qos = { ...DEFAULT_QOS, keepAll: true };
const [talker, listener] = [join("talker"), join("listener")];
const p = talker.participant.create("publisher", "/talker", "/chatter", "T", qos);
const s = listener.participant.create("subscription", "/listener", "/chatter", "T", qos);
const heard = [];
const hear = () => {
  for (let sample; (sample = listener.participant.take(s)); ) heard.push(sample.message[0]);
};
const entry = { package: "p", executable: "e", arguments: [], autostart: false,
  ros2wasm: { script: "none.js", topics: {}, types: {}, victim: listener.id } };
const now = Promise.resolve();
const evil = new NodeProcess("evil", entry, location.href, graph, { ready: now, mounted: now },
  new WorkerGroups());
const lines = [];
let sent = 0;
const done = new Promise((resolve) => {
  evil.addEventListener("state", () => {
    if (evil.state !== "starting" && evil.state !== "running") resolve();
  });
  evil.addEventListener("lines", ({ detail }) => {
    for (const { text } of detail) {
      lines.push(text);
      if (text === "done") resolve();
    }
    talker.participant.publish(p, new Uint8Array([++sent]));
    hear();
  });
});
evil.start();
await done;
await arrived();
talker.participant.publish(p, new Uint8Array([++sent]));
await arrived();
hear();
const known = graph.endpoints().map((endpoint) => endpoint.node);
const state = evil.state;
evil.stop();
const refused = graph.refused(listener.id);
return { uncaught, lines, complaints, known, state, refused, missing: sent - heard.length };
"""

OPS = (
    "of an unknown kind",
    "create",
    "destroy",
    "missed",
    "complain",
    "lines",
    "progress",
    "memory",
    "reading",
    "ready",
    "words",
    "checked",
    "exit",
)


@pytest.fixture
def play(any_tab: Scripted, serve: Serve, tmp_path: Path) -> Any:
    """A function that runs a scene in a page whose ROS2WASM worker is hostile."""
    play = player(any_tab, serve, tmp_path, "")
    (tmp_path / "workers" / "ros2wasm" / "ros2wasmNode.js").write_text(HOSTILE)
    return play


def test_wrong_reports_are_dropped_and_told_once(play: Any) -> None:
    end = play(SCENE)
    assert end["uncaught"] == []
    assert end["lines"] == [*(f"evil: sent an invalid report: {op}" for op in OPS), "done"]
    assert (end["state"], end["missing"]) == ("running", 0)
    assert end["known"] == ["/talker", "/listener", "/evil", "/evil"]
    # Only after they are linked, once, by name, and in words of the page.
    assert end["complaints"] == ["evil refused what it sent: a frame that is not valid"]
    assert end["refused"] == 4
