"""A chain of filters as one filter."""

from __future__ import annotations

from typing import Any

from message_filters.simple_filter import SimpleFilter


class Chain(SimpleFilter):
    """A chain of filters with `add` and `registerCallback`."""

    def __init__(self, message_filter: Any = None) -> None:
        super().__init__()
        self._filters: list[Any] = []
        self._output = -1
        if message_filter is not None:
            self.connectInput(message_filter)

    def connectInput(self, message_filter: Any) -> None:
        """Connect the input to another filter."""
        self.incoming_connection = message_filter.registerCallback(self.add)

    def add(self, message: Any) -> None:
        """Add a message."""
        if self._filters:
            self._filters[0].add(message)
        else:
            self.signalMessage(message)

    def addFilter(self, message_filter: Any) -> int:
        """Append a filter and return its index."""
        if self._filters:
            last = self._filters[-1]
            del last.callbacks[self._output]
            last.registerCallback(message_filter.add)
        self._output = message_filter.registerCallback(self.signalMessage)
        self._filters.append(message_filter)
        return len(self._filters) - 1

    def getFilter(self, index: int) -> Any:
        """Return one of the filters."""
        return self._filters[index]
