"""Put the requests of a client about nodes in order, without waiting for nodes that are silent."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Coroutine, Iterable
from typing import Any, TypeVar

Answer = TypeVar("Answer")
Start = Callable[[Coroutine[Any, Any, None]], "asyncio.Task[None]"]
# How long a node may take to answer what all nodes are asked (s).
BRIEF = 1.0


class NoAnswerError(Exception):
    """A node does not answer."""


class Asking:
    """What one client asks: requests about a node are answered in their order."""

    def __init__(self) -> None:
        # The last request about each node; that of "" is about all nodes.
        self._last: dict[str, asyncio.Future[None]] = {}
        # The nodes that have not answered in time, until they do.
        self._silent: set[str] = set()
        self._asked: set[str] = set()

    async def in_turn(self, node: str, work: Callable[[], Awaitable[Answer]]) -> Answer:
        """Do `work` about a node, or with "" about all nodes, after what was asked before."""
        own = asyncio.get_running_loop().create_future()
        before = [self._last[name] for name in {node, ""} & self._last.keys()]
        others = [last for name, last in self._last.items() if name and name not in self._silent]
        self._last[node] = own
        try:
            if before:
                await asyncio.wait(before)
            if others and not node:
                await asyncio.wait(others, timeout=BRIEF)
            return await work()
        finally:
            own.set_result(None)
            if self._last.get(node) is own:
                del self._last[node]

    async def all(
        self, nodes: Iterable[str], ask: Callable[[str], Awaitable[Answer]], start: Start
    ) -> dict[str, Answer]:
        """Return the answers of all nodes that answer soon; `ask` may raise a NoAnswerError."""
        found: dict[str, Answer] = {}

        async def one(node: str) -> None:
            self._asked.add(node)
            try:
                found[node] = await ask(node)
                self._silent.discard(node)
            except NoAnswerError:
                return
            finally:
                self._asked.discard(node)

        tasks = {node: start(one(node)) for node in nodes if node not in self._asked}
        awaited = [task for node, task in tasks.items() if node not in self._silent]
        if awaited:
            await asyncio.wait(awaited, timeout=BRIEF)
        self._silent.update(node for node, task in tasks.items() if not task.done())
        return {node: found[node] for node in tasks if node in found}
