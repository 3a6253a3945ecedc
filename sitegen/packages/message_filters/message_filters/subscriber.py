"""The filter that receives the messages of a topic."""

from __future__ import annotations

from typing import Any

from message_filters.simple_filter import SimpleFilter


class Subscriber(SimpleFilter):
    """Takes a node and the arguments of its `create_subscription`, without the callback."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__()
        self.node, kind, self.topic, *others = args
        if not others:
            kwargs.setdefault("qos_profile", 10)
        self.sub = self.node.create_subscription(kind, self.topic, self.callback, *others, **kwargs)

    def callback(self, msg: Any) -> None:
        """Pass on a message."""
        self.signalMessage(msg)

    def getTopic(self) -> str:
        """Return the name of the topic."""
        return str(self.topic)

    def __getattr__(self, key: str) -> Any:
        return getattr(self.__dict__["sub"], key)
