"""Who is at the gateway, as far as other clients may see it."""

from __future__ import annotations

import asyncio
import json
import posixpath
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

# The pages that are listed; others are only counted.
MOST = 200
# Changes within this time are told together (s).
PAUSE = 0.3


@dataclass(frozen=True)
class Visitor:
    """A page that has joined; `number` is the smallest that no other one has."""

    number: int
    # Whose key it has given; "" if that is unknown.
    name: str
    # When it joined (s since 1970).
    since: float
    # Returns the names of its nodes in the native graph.
    nodes: Callable[[], Iterable[str]]


class People:
    """The clients of a gateway; pages are told of each other."""

    def __init__(self, shown: bool = True) -> None:
        """With `shown` False, nobody is told of anybody."""
        self.shown = shown
        # The last message to pages, and who is called when there is another one.
        self.message = ""
        self.watchers: set[Callable[[], None]] = set()
        self._pages: dict[object, Visitor] = {}
        self._others: set[object] = set()
        self._timer: asyncio.TimerHandle | None = None
        # Whether a page has joined that was told nothing yet.
        self._fresh = False

    def enter(self, client: object) -> None:
        """Count a client that is no page."""
        self._others.add(client)
        self.changed()

    def join(
        self,
        page: object,
        name: str,
        nodes: Callable[[], Iterable[str]],
        before: Visitor | None = None,
    ) -> Visitor:
        """Add a page; `before` is who it was before it lost its connection, and has left."""
        taken = {visitor.number for visitor in self._pages.values()}
        free = next(number for number in range(1, len(taken) + 2) if number not in taken)
        number, since = (before.number, before.since) if before else (free, time.time())
        self._fresh = True
        self._pages[page] = visitor = Visitor(number, name, since, nodes)
        self.changed()
        return visitor

    def leave(self, client: object) -> None:
        """Remove a client, if it is there."""
        self._pages.pop(client, None)
        self._others.discard(client)
        self.changed()

    def changed(self) -> None:
        """Tell the pages soon, if something has changed that they see."""
        if self.shown and self._timer is None:
            self._timer = asyncio.get_running_loop().call_later(PAUSE, self._tell)

    def _tell(self) -> None:
        self._timer = None
        pages = [_described(visitor) for visitor in list(self._pages.values())[:MOST]]
        more = len(self._pages) - len(pages)
        said = {"op": "people", "pages": pages, "more": more, "others": len(self._others)}
        message = json.dumps(said, separators=(",", ":"))
        if message != self.message or self._fresh:
            self.message, self._fresh = message, False
            for watcher in list(self.watchers):
                watcher()


def _described(visitor: Visitor) -> dict[str, Any]:
    nodes = [node for node in visitor.nodes() if "/_" not in node]
    # That of all of them, such as "/student3".
    namespace = posixpath.commonpath([posixpath.dirname(node) for node in nodes]) if nodes else ""
    return {
        "id": visitor.number,
        "name": visitor.name,
        "namespace": namespace,
        "nodes": len(nodes),
        "since": round(visitor.since * 1000),
    }
