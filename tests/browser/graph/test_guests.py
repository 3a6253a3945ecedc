"""What a hostile program cannot do to its page: to names, consoles, time, and the others."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from browser import Scripted, Serve
from scenario import player

pytestmark = [pytest.mark.firefox, pytest.mark.webkit]

# In place of the worker of ROS2WASM nodes: it runs what the scene says.
HOSTILE = """
const never = { deadline: Infinity, lifespan: Infinity, lease: Infinity };
const qos = { depth: 1, reliable: true, ...never };
const report = (op, rest) => postMessage({ op, ...rest });
const create = (id, kind, node, name = "", type = "T") =>
  report("create", { endpoint: { id, kind, node, name, type, qos } });
const say = (text) => report("lines", { lines: [{ severity: "info", text }] });
const sleep = (time) => new Promise((resolve) => setTimeout(resolve, time));
onmessage = ({ data }) => {
  if (data.op === "adopt") eval(`(async () => { ${data.program.code} })()`);
};
"""
# `start(name, code)` starts a node that runs `code`. What its console shows is in `lines`, unless
# it is too much, and what the page says there in `told`.
SETTING = """
const uncaught = [];
addEventListener("error", (event) => uncaught.push(event.message));
addEventListener("unhandledrejection", (event) => uncaught.push(String(event.reason)));
const { Graph } = await import("./page/graph.js");
const { NodeProcess } = await import("./page/nodeProcess.js");
const { WorkerGroups } = await import("./page/workerGroup.js");
const graph = new Graph();
const now = Promise.resolve();
const start = (name, code, script = name) => {
  const entry = { package: name, executable: "e", arguments: [], autostart: false,
    ros2wasm: { script: `${script}.js`, topics: {}, types: {}, code } };
  const node = new NodeProcess(name, entry, location.href, graph, { ready: now, mounted: now },
    new WorkerGroups());
  Object.assign(node, { lines: [], told: [] });
  node.addEventListener("lines", ({ detail }) => {
    const texts = detail.map(({ text }) => text);
    if (node.lines.length < 1000) node.lines.push(...texts.slice(0, 1000));
    node.told.push(...texts.filter((text) => text.startsWith(`${name}: `)));
  });
  node.start();
  return node;
};
const until = async (condition) => {
  const end = performance.now() + 60_000;
  while (!condition()) {
    if (performance.now() > end) throw new Error(`never: ${condition}`);
    await new Promise((resolve) => setTimeout(resolve, 5));
  }
};
"""


@pytest.fixture
def play(any_tab: Scripted, serve: Serve, tmp_path: Path) -> Any:
    """A function that runs a scene in a page whose ROS2WASM workers do as they like."""
    play = player(any_tab, serve, tmp_path, SETTING)
    (tmp_path / "workers" / "ros2wasm" / "ros2wasmNode.js").write_text(HOSTILE)
    return play


def test_a_name_is_ones_own(play: Any) -> None:
    """Endpoints belong to announced nodes; the page's name and those of running nodes are taken."""
    found = play("""
      const other = start("talker", `create(1, "node", "/talker"); say("done");`);
      await until(() => other.lines.includes("done"));
      const evil = start("evil", `
        create(1, "publisher", "/evil", "/t");
        create(2, "node", "/_page");
        create(3, "node", "/_page/below");
        create(4, "node", "/talker");
        create(5, "publisher", "/talker", "/t");
        create(6, "node", "no name");
        create(7, "node", "/evil");
        create(8, "publisher", "/evil", "/t");
        report("destroy", { id: 7 });
        create(9, "publisher", "/evil", "/u");
        say("done");`);
      await until(() => evil.lines.includes("done"));
      const known = graph.endpoints().map(({ kind, node, name }) => [kind, node, name]);
      other.stop();
      await until(() => other.state === "stopped");
      const late = start("late", `create(1, "node", "/talker"); say("done");`);
      await until(() => late.lines.includes("done"));
      return [evil.lines, known, other.lines, late.lines, uncaught];
    """)
    unannounced = "evil: announced a publisher of a node that it has not announced; it was dropped"
    assert found == [
        [
            unannounced,
            "evil: announced a node with the name of the page; it was dropped",
            "evil: announced a node with the name of another node, /talker; it was dropped",
            "evil: announced a node with an invalid name; it was dropped",
            "done",
        ],
        [["node", "/talker", ""], ["publisher", "/evil", "/t"]],
        ["done"],
        ["done"],
        [],
    ]


def test_two_programs_of_one_executable_may_have_the_same_name(play: Any) -> None:
    found = play("""
      const code = `create(1, "node", "/one"); say("done");`;
      const nodes = ["one", "two"].map((name) => start(name, code, "same"));
      await until(() => nodes.every(({ lines }) => lines.includes("done")));
      return [graph.nodes(), nodes.map(({ lines }) => lines)];
    """)
    assert found == [["/one", "/one"], [["done"], ["done"]]]


def test_nobody_writes_in_the_console_of_another(play: Any) -> None:
    """What a node says about another is a choice of the page's sentences, once."""
    found = play("""
      const victim = start("victim", `create(1, "node", "/victim");
        create(2, "subscription", "/victim", "/t"); say("done");`);
      await until(() => victim.lines.includes("done"));
      const evil = start("evil", `create(1, "node", "/evil"); create(2, "publisher", "/evil", "/t");
        for (const text of ["send money", "now"]) {
          for (let peer = 0; peer < 5; peer += 1) {
            report("complain", { peer, text });
            report("complain", { peer, what: text, count: 1 });
            report("complain", { peer, what: "frame", count: 1, text });
          }
        }
        say("done");`);
      await until(() => evil.lines.includes("done"));
      return [victim.lines, evil.lines];
    """)
    assert found == [
        ["done", "victim: evil refused what it sent: a frame that is not valid"],
        ["evil: sent an invalid report: complain", "done"],
    ]


@pytest.mark.chromium
def test_endpoints_have_a_budget_and_stop_is_answered_at_once(play: Any) -> None:
    """A hundred thousand announced publishers, and operations without end, beside others."""
    found = play("""
      const good = start("good", `create(1, "node", "/good"); create(2, "publisher", "/good", "/g");
        report("running"); for (;;) { say("still here"); await sleep(100); }`);
      const all = start("all", `create(1, "node", "/all"); report("running");
        for (let id = 2; id < 100_002; id += 1) {
          create(id, "publisher", "/all", "/t" + id);
          if (id % 500 === 0) await sleep(50);
        }`);
      const same = start("same", `create(1, "node", "/same"); report("running");
        for (let id = 2; id < 1002; id += 1) create(id, "subscription", "/same", "/g");
        for (;;) { create(2000, "publisher", "/same", "/x"); report("destroy", { id: 2000 });
          for (let n = 0; n < 78; n += 1) report("memory", { bytes: n }); await sleep(10); }`);
      await until(() => all.lines.length && same.lines.length && good.lines.length > 10);
      const counts = ["all", "same"].map((name) =>
        graph.endpoints().filter(({ program }) => program === name).length);
      const worst = [];
      for (const node of [same, all, good]) {
        const begun = performance.now();
        await new Promise((resolve) => setTimeout(resolve)); // a click is a task, too
        const state = new Promise((resolve) => {
          node.addEventListener("state", resolve, { once: true });
        });
        node.stop();
        await state;
        worst.push(performance.now() - begun);
      }
      await until(() => [same, all, good].every(({ state }) => state === "stopped"));
      const left = graph.endpoints();
      return [counts, worst, all.lines, same.lines[0], good.lines.at(-1), left, uncaught];
    """)
    counts, worst, every, same, good, left, uncaught = found
    assert counts[0] == 4096
    assert 257 <= counts[1] <= 258
    assert max(worst) < 100
    assert every[0] == "all: announced more than 4096 endpoints; further ones were dropped"
    assert same == (
        "same: announced more than 256 endpoints of one kind and name; further ones were dropped"
    )
    assert good == "good: did not end within a second and was terminated"
    assert left == []
    assert uncaught == []


def test_changes_leave_most_of_the_time_to_the_page(play: Any) -> None:
    """Panels that take long to draw a large graph draw it more rarely."""
    share = play("""
      start("evil", `create(1, "node", "/evil"); for (let id = 2; ; id += 1) {
        create(id, "publisher", "/evil", "/t"); report("destroy", { id }); await sleep(1); }`);
      await until(() => graph.nodes().length);
      let spent = 0;
      graph.addEventListener("change", () => {
        const end = performance.now() + 40;
        while (performance.now() < end);
        spent += 40;
      });
      const begun = performance.now();
      await until(() => spent >= 400);
      return spent / (performance.now() - begun);
    """)
    assert share < 0.35


@pytest.mark.parametrize(
    ("code", "reason"),
    [
        (
            'for (;;) { for (let n = 0; n < 1000; n += 1) report("memory", { bytes: n }); '
            "await sleep(1); }",
            "reported to the page more than 10000 times a second and was stopped",
        ),
        (
            'for (;;) { for (let n = 0; n < 100; n += 1) report("nonsense"); await sleep(1); }',
            "reported to the page more than 10000 times a second and was stopped",
        ),
        (
            "const line = { severity: 'info', text: 'x' };"
            "const lines = Array.from({ length: 10_000 }, () => line);"
            'for (;;) { report("lines", { lines }); await sleep(1); }',
            "went on printing more than 20000 lines a second and was stopped",
        ),
    ],
)
def test_who_reports_without_end_is_told_and_stopped(play: Any, code: str, reason: str) -> None:
    found = play(f"""
      console.error = () => {{}}; // it says there, too, why a node failed
      const good = start("good", `report("running");
        for (let n = 0; n < 20; n += 1) {{ say("good " + n); await sleep(10); }} say("done");`);
      const evil = start("evil", {json.dumps('report("running"); ' + code)});
      await until(() => evil.state === "failed" && good.lines.includes("done"));
      return [evil.told, good.lines, uncaught];
    """)
    told, good, uncaught = found
    assert f"evil: {reason}" in told
    assert len(told) <= 3  # once each, and how many there were in all
    assert good == [*(f"good {number}" for number in range(20)), "done"]
    assert uncaught == []


def test_a_burst_of_reports_is_taken(play: Any) -> None:
    found = play("""
      const node = start("node", `report("running");
        for (let n = 0; n < 39_000; n += 1) report("memory", { bytes: n });
        say("done");`);
      await until(() => node.lines.includes("done"));
      return [node.lines, node.state];
    """)
    assert found == [["done"], "running"]


def test_a_burst_of_lines_is_shown(play: Any) -> None:
    """Long lines count as several."""
    found = play("""
      const send = (count, text) => `report("lines", { lines: Array.from({ length: ${count} },
        () => ({ severity: "info", text: ${text} })) });`;
      const short = start("short", `${send(100_000, '"x"')} ${send(99_000, '"x"')} say("done");`);
      const long = start("long", `${send(4_000, '"x".repeat(60_000)')} report("running");`);
      let count = 0;
      short.addEventListener("lines", ({ detail }) => { count += detail.length; });
      await until(() => count === 199_001 && long.state === "running");
      return [short.told, long.told];
    """)
    assert found == [[], ["long: prints more than 20000 lines a second; some are dropped"]]


def test_lines_are_cut(play: Any) -> None:
    found = play("""
      const say = (letter, count) => `say("${letter}".repeat(${count}));`;
      const code = say("x", 4_194_304) + say("y", 5_000_000) + `say("done");`;
      const node = start("evil", code);
      await until(() => node.lines.includes("done"));
      return node.lines.map((text) => [text.length, text.slice(-9)]);
    """)
    assert found == [
        [4_194_304, "x" * 9],
        [44, "haracters"],
        [4_194_305, "y" * 8 + "…"],
        [4, "done"],
    ]


def test_a_report_does_not_undo_stop(play: Any) -> None:
    found = play("""
      const states = [];
      const node = start("evil", `onmessage = () => { report("running"); report("running"); };
        report("running"); say("done");`);
      await until(() => node.lines.includes("done"));
      node.addEventListener("state", () => states.push(node.state));
      node.stop();
      node.stop();
      await until(() => node.state === "stopped");
      return states;
    """)
    assert found == ["stopping", "stopped"]


MUTATED = """
      const { NodeStateView } = await import("./ui/nodeState.js");
      const good = start("good", `report("running");`);
      const evil = (seed) => start("evil", `
        let state = ${seed};
        const random = (below) => {
          state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
          return Math.floor((state / 2 ** 32) * below);
        };
        const of = (list) => list[random(list.length)];
        const odd = [undefined, null, 0, -0, -1, 1, 1.5, NaN, Infinity, -Infinity, 2 ** 31,
          2 ** 53, 1e308, 5n, "", "x", "__proto__", "x".repeat(5000), [], {}, [[]], true, false,
          new Date(NaN), new Map(), { toString: 1 }, new Uint8Array(3), /x/, new Error("x")];
        const seeds = [
          { op: "look" }, { op: "settle" },
          ...["node", "client"].map((kind, id) => ({ op: "create",
            endpoint: { id: id + 1, kind, node: "/evil", name: "/t", type: "T", qos } })),
          { op: "destroy", id: 1 }, { op: "missed", id: 2, count: 3 },
          { op: "complain", peer: 1, what: "frame", count: 1 },
          { op: "lines", lines: [{ severity: "info", text: "x" }] },
          ...[0, 0, 0, 1, 9].map((total) => ({ op: "progress", loaded: 1, total })),
          { op: "memory", bytes: 1 }, { op: "reading", keyboard: "keys" },
          { op: "ready", more: true },
          { op: "answer", text: "{}" }, { op: "words", text: "a", words: ["b"] },
          { op: "checked", text: "a", line: 1, error: "b" }, { op: "tell", message: 1 },
        ];
        const numbers = [0, -1, -5, 1.5, NaN, Infinity, -Infinity, 2 ** 53, 5n];
        const mutate = (value) => {
          if (typeof value === "number" && random(2)) return of(numbers);
          if (random(4) === 0 || typeof value !== "object" || value === null) return of(odd);
          const copy = Array.isArray(value) ? [...value] : { ...value };
          const key = of([...Object.keys(copy), "length", "__proto__", "op"]);
          Object.defineProperty(copy, key, { value: mutate(copy[key]), enumerable: true,
            configurable: true, writable: true });
          return copy;
        };
        for (let turn = 1; turn <= 250; turn += 1) {
          const seed = of(seeds);
          try {
            let changed = seed;
            for (let more = random(3); more >= 0; more -= 1) {
              changed = { ...mutate(changed), ...(random(3) && { op: seed.op }) };
            }
            postMessage(random(10) ? changed : seed);
          } catch {
            // What cannot be sent harms nobody.
          }
          if (turn % 40 === 0) await sleep(20);
        }
        report("running");
        say("done");`);
      const nodes = Array.from({ length: 12 }, (_, seed) => evil(seed + 1));
      const view = new AbortController();
      for (const node of nodes) document.body.append(new NodeStateView(node, view.signal).meter);
      await until(() => nodes.every(({ lines }) => lines.includes("done")));
      const states = nodes.map(({ state }) => state);
      for (const node of nodes) node.stop();
      await until(() => nodes.every(({ state }) => state === "stopped"));
      const told = nodes.flatMap((node) => node.told);
      return [told, states, good.state, uncaught];
"""


def test_mutated_reports_are_counted_and_harm_nobody(play: Any) -> None:
    """Three thousand, each changed somewhere: none is an exception of the page."""
    told, states, good, uncaught = play(MUTATED)
    assert uncaught == []
    assert (states, good) == (["running"] * 12, "running")
    kinds = {line for line in told if line.startswith("evil: sent an invalid report: ")}
    assert {
        "evil: sent an invalid report: create",
        "evil: sent an invalid report: progress",
    } <= kinds
    assert any(line.startswith("evil: invalid reports: ") for line in told)


def test_progress_of_nothing_is_no_error(play: Any) -> None:
    found = play("""
      const { NodeStateView } = await import("./ui/nodeState.js");
      const node = start("evil", `
        const pairs = [[0, 0], [5, 0], [0, 5], [9, 5], [-5, 0], [-1, 5], [1e308, 1], [1, 1e-320]];
        for (const [loaded, total] of pairs) report("progress", { loaded, total });
        say("done");`);
      const { meter, label } = new NodeStateView(node, new AbortController().signal);
      document.body.append(meter, label);
      await until(() => node.lines.includes("done"));
      return [node.lines, uncaught];
    """)
    assert found == [["evil: sent an invalid report: progress", "done"], []]
