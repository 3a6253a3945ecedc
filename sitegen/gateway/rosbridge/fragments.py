"""Split long messages, and put together those that clients have split."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from typing import Any

from sitegen.gateway.rosbridge.operation import InvalidOperationError, text

# Messages of one client that are not complete yet, and the parts of one.
MOST, MOST_PARTS = 16, 10_000
SMALLEST = 16


def split(message: str, size: int, name: str) -> Iterator[str]:
    """Yield `message`, in fragments if it is longer than `size`."""
    size = max(size, SMALLEST)
    total = math.ceil(len(message) / size)
    if total <= 1:
        yield message
        return
    for number in range(total):
        part = message[number * size : (number + 1) * size]
        fragment = {"op": "fragment", "id": name, "data": part, "num": number, "total": total}
        yield json.dumps(fragment)


class Fragments:
    """The parts of messages that have come; together they are bounded by `largest` characters."""

    def __init__(self, largest: int) -> None:
        self._largest = largest
        self._parts: dict[str, dict[int, str]] = {}
        self._size = 0

    def add(self, message: dict[str, Any]) -> str | None:
        """Add a fragment; return the text of the message that it completes, if it does.

        Raises: InvalidOperationError for one that does not fit to the others.
        """
        name, data = str(message.get("id")), text(message, "data")
        number, total = message.get("num"), message.get("total")
        whole = all(isinstance(n, int) and not isinstance(n, bool) for n in (number, total))
        if "id" not in message or not whole or not 0 <= number < total <= MOST_PARTS:  # type: ignore[operator]
            raise InvalidOperationError("fragment: needs 'id', 'num' and 'total'")
        if name not in self._parts and len(self._parts) >= MOST:
            # The oldest will not be completed any more.
            self._remove(next(iter(self._parts)))
        parts = self._parts.setdefault(name, {})
        self._size -= len(parts.get(number, ""))  # type: ignore[arg-type]
        parts[number] = data  # type: ignore[index]
        self._size += len(data)
        if self._size > self._largest:
            self._size = 0
            self._parts.clear()
            raise InvalidOperationError("fragment: the message is too large")
        if len(parts) < total:  # type: ignore[operator]
            return None
        self._remove(name)
        return "".join(parts[i] for i in sorted(parts))

    def _remove(self, name: str) -> None:
        self._size -= sum(len(part) for part in self._parts.pop(name).values())
