"""Graphs of many nodes, many topics and every shape, in one page."""

from __future__ import annotations

import shutil
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml
from browser import Serve
from memory import held, resident
from panel import expect_nothing_left
from paths import SITES
from playwright.sync_api import Browser, Page, expect

from sitegen.commands.build import build
from sitegen.report import Report

SITE = SITES / "many"
# How many nodes and how many topics each publishes, in the page that is large.
NODES, TOPICS = 50, 10

# The programs of each graph: name, and the arguments of many.cpp.
Programs = dict[str, list[str]]

SHAPES: dict[str, tuple[Programs, dict[str, str]]] = {
    "fan in": (
        {
            **{f"from{n}": [f"n:from{n}", "p:/in"] for n in range(20)},
            "to": ["n:to", "s:/in"],
        },
        {"to": "heard 20 publishers on 1 topics"},
    ),
    "fan out": (
        {
            "from": ["n:from", "p:/out"],
            **{f"to{n}": [f"n:to{n}", "s:/out"] for n in range(20)},
        },
        {f"to{n}": "heard 1 publishers on 1 topics" for n in range(20)},
    ),
    "several publishers of one node": (
        {"from": ["n:from", *["p:/t"] * 5], "to": ["n:to", "s:/t", "s:/t"]},
        {"to": "heard 10 publishers on 2 topics"},
    ),
    "several nodes in one process": (
        {
            "one": ["n:a", "p:/inside", "s:/back", "n:b", "s:/inside", "p:/across"],
            "other": ["n:c", "s:/across", "s:/inside", "p:/back"],
        },
        {"one": "heard 1 publishers on 1 topics", "other": "heard 2 publishers on 2 topics"},
    ),
    "loop": (
        {
            "a": ["n:a", "p:/ab", "s:/ca", "p:/self", "s:/self"],
            "b": ["n:b", "p:/bc", "s:/ab"],
            "c": ["n:c", "p:/ca", "s:/bc"],
        },
        {
            "a": "heard 2 publishers on 2 topics",
            "b": "heard 1 publishers on 1 topics",
            "c": "heard 1 publishers on 1 topics",
        },
    ),
}


def ring() -> Programs:
    """Each node hears one topic of each of those before it, so that all parts hold together.

    They are many and not fast: that is what `bench many` is for.
    """
    return {
        f"node{n}": [
            "e:1000",
            f"n:node{n}",
            *(f"p:/node{n}/topic{k}" for k in range(TOPICS)),
            *(f"s:/node{(n - k - 1) % NODES}/topic{k}" for k in range(TOPICS)),
        ]
        for n in range(NODES)
    }


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A site with a page for each shape."""
    folder = tmp_path_factory.mktemp("many")
    shutil.copytree(SITE, folder, dirs_exist_ok=True)
    graphs = {name: programs for name, (programs, _) in SHAPES.items()} | {"ring": ring()}
    pages = [
        {
            "path": f"{name.replace(' ', '-')}/",
            "title": name,
            "nodes": {
                program: {"package": "many", "executable": "many", "arguments": arguments}
                for program, arguments in programs.items()
            },
            "content": [
                {"topics": None},
                {"nodes": None},
                *({kind: program} for program in programs for kind in ("buttons", "console")),
            ],
        }
        for name, programs in graphs.items()
    ]
    site = {"site": {"title": "Many", "asyncify": False}, "workspace": ".", "pages": pages}
    (folder / "site.yaml").write_text(yaml.safe_dump(site))
    build(folder, output=folder / "dist", report=Report())
    return folder / "dist"


@pytest.fixture
def run(tab: Page, serve: Serve, folder: Path) -> Iterator[Callable[[str], None]]:
    """A function that opens the page of a graph and starts all its programs."""

    def start(name: str) -> None:
        tab.goto(serve(folder) + name.replace(" ", "-") + "/")
        tab.evaluate(
            """async () => {
              const { ros } = await import(document.querySelector("script[type=module]").src);
              window.ros = ros;
              window.lines = {};
              for (const [name, node] of ros.nodes) {
                lines[name] = [];
                node.addEventListener("lines", (event) => lines[name].push(...event.detail));
                node.start();
              }
            }"""
        )

    yield start
    tab.evaluate("for (const node of ros.nodes.values()) node.stop()")
    # A program that runs ends in its own time, at most a second after Ctrl-C.
    tab.wait_for_function("() => [...ros.nodes.values()].every(({ state }) => state === 'stopped')")
    expect_nothing_left(tab)


def told(tab: Page) -> dict[str, list[str]]:
    """What each program logged, without the log's head."""
    found: dict[str, list[str]] = tab.evaluate(
        """Object.fromEntries(Object.entries(lines).map(
          ([name, all]) => [name, all.map(({ text }) => text.replace(/^.*]: /, ""))]))"""
    )
    return found


def wait_until_heard(tab: Page, programs: dict[str, str]) -> None:
    """Wait until each of these has told what it heard."""
    deadline = time.monotonic() + 120
    while True:
        lines = told(tab)
        silent = [name for name, line in programs.items() if line not in lines[name]]
        if not silent:
            return
        assert time.monotonic() < deadline, (silent, {name: lines[name] for name in silent})
        tab.wait_for_timeout(100)


@pytest.mark.parametrize("shape", SHAPES)
def test_a_graph_of_any_shape(tab: Page, run: Any, shape: str) -> None:
    programs, heard = SHAPES[shape]
    run(shape)
    wait_until_heard(tab, heard)
    assert {
        name for name, lines in told(tab).items() if any(" after " in x for x in lines)
    } == set()
    assert set(heard) <= set(programs)


def test_fifty_nodes_and_five_hundred_topics(browser: Browser, tab: Page, run: Any) -> None:
    before = resident(browser)
    run("ring")
    all_of_it = f"heard {TOPICS} publishers on {TOPICS} topics"
    wait_until_heard(tab, {f"node{n}": all_of_it for n in range(NODES)})
    expect(tab.locator(".ros-topics tbody tr")).to_have_count(NODES * TOPICS)
    topics = tab.evaluate("ros.graph.topics().filter(({ name }) => name.startsWith('/node'))")
    assert len(topics) == NODES * TOPICS
    assert all(len(topic["publishers"]) == 1 for topic in topics)
    assert not any(topic["mismatches"] for topic in topics)
    # A worker of the browser alone takes a dozen megabytes.
    assert resident(browser) - before < NODES * 50e6


def restart(tab: Page, node: str, times: int) -> None:
    """Start and stop a node so often; the others go on."""
    tab.evaluate(
        """async ([name, times]) => {
          const node = ros.nodes.get(name);
          const become = async (state) => {
            while (node.state !== state) {
              await new Promise((look) => node.addEventListener("state", look, { once: true }));
            }
          };
          for (let n = 0; n < times; n++) {
            node.stop();
            await become("stopped");
            node.start();
            await become("running");
          }
          for (const each of ros.nodes.values()) each.clear();
          for (const name in lines) lines[name] = [];
        }""",
        [node, times],
    )


def test_a_node_that_starts_and_stops_leaves_nothing(browser: Browser, tab: Page, run: Any) -> None:
    """A hundred times; what is held does not grow with it."""
    run("loop")
    wait_until_heard(tab, SHAPES["loop"][1])
    restart(tab, "a", 20)
    before, memory = held(tab), resident(browser)
    restart(tab, "a", 100)
    wait_until_heard(tab, {"a": SHAPES["loop"][1]["a"]})
    bounds = {"heap": 1e6, "elements": 100, "listeners": 20}
    deadline = time.monotonic() + 60
    while any((after := held(tab))[what] > before[what] + more for what, more in bounds.items()):
        assert time.monotonic() < deadline, (before, after)
    assert resident(browser) < memory + 100e6
    assert len(tab.workers) == 3
    assert len(tab.evaluate("ros.graph.nodes()")) == 3
