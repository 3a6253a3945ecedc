"""The classes of `jupyros.ros2`, as its notebooks use them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from jupyros.panels import *  # noqa: F403
from jupyros.panels import Panel, echo, publish


class Publisher(Panel):
    """A form that publishes messages to a topic."""

    def __init__(self, node: Any, msg_type: type, topic: str) -> None:
        super().__init__("publish", **publish(topic, msg_type).options)
        self.node, self.msg_type, self.topic = node, msg_type, topic


class Subscriber(Panel):
    """The messages of a topic as they arrive; `callback` has each, too."""

    def __init__(
        self, node: Any, msg_type: type, topic: str, callback: Callable[[Any], object] | None = None
    ) -> None:
        super().__init__("topics", **echo(topic).options)
        self.node, self.msg_type, self.topic = node, msg_type, topic
        if callback:
            self.subscription = node.create_subscription(msg_type, topic, callback, 10)
