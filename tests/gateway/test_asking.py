"""The order of requests about nodes, one of which does not answer."""

from __future__ import annotations

import asyncio
from functools import partial

import pytest
from gateways import run

from sitegen.gateway import asking
from sitegen.gateway.asking import Asking


def test_a_silent_node_delays_only_those_who_ask_for_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(asking, "BRIEF", 0.05)

    async def work() -> None:
        one, told = Asking(), asyncio.Event()
        done: list[str] = []

        async def ask(node: str) -> str:
            if node == "/silent":
                await told.wait()
            return node

        async def named(node: str) -> None:
            done.append(await one.in_turn(node, lambda: ask(node)))

        async def alone() -> dict[str, str]:
            nodes = ("/robot", "/silent")
            return await one.in_turn("", lambda: one.all(nodes, ask, asyncio.create_task))

        silent = asyncio.create_task(named("/silent"))
        # Begins before the others.
        await asyncio.sleep(0)
        await named("/robot")
        assert done == ["/robot"]
        assert await alone() == {"/robot": "/robot"}
        # From now on, nobody waits for it.
        monkeypatch.setattr(asking, "BRIEF", 1000)
        assert await alone() == {"/robot": "/robot"}
        told.set()
        await silent
        assert await alone() == {"/robot": "/robot", "/silent": "/silent"}

    run(work())


def test_requests_about_a_node_and_about_all_are_in_order() -> None:
    async def work() -> None:
        one = Asking()
        done: list[str] = []

        async def later(name: str) -> None:
            for _ in range(3 if name == "first" else 1):
                await asyncio.sleep(0)
            done.append(name)

        asked = [("/robot", "first"), ("", "second"), ("/robot", "third"), ("/other", "fourth")]
        async with asyncio.TaskGroup() as group:
            for node, name in asked:
                group.create_task(one.in_turn(node, partial(later, name)))
        assert done == ["first", "second", "third", "fourth"]

    run(work())
