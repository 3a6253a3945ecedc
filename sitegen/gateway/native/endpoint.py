"""The data that the event loop and the thread of ROS exchange."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

Kind = Literal["node", "publisher", "subscription", "service", "client"]


class NativeError(Exception):
    """ROS refuses something; the text is one plain line."""


class UnknownTypeError(NativeError):
    """The type of a topic or service is not installed beside the gateway."""


class MalformedMessageError(NativeError):
    """Bytes are no message of the type that they claim to be."""


@dataclass(frozen=True)
class Qos:
    """A quality of service with the fields of pages; times in ms, infinite without a limit."""

    depth: int = 10
    reliable: bool = True
    transient_local: bool = False
    keep_all: bool = False
    deadline: float = math.inf
    lifespan: float = math.inf
    manual: bool = False
    lease: float = math.inf

    def accepts(self, offered: Qos) -> bool:
        """Return whether a subscription with this profile matches a publisher with `offered`."""
        return (
            self.reliable <= offered.reliable
            and self.transient_local <= offered.transient_local
            and self.manual <= offered.manual
            and self.deadline >= offered.deadline
            and self.lease >= offered.lease
        )


@dataclass(frozen=True)
class Endpoint:
    """An endpoint of the graph.

    `key` is unique as long as the endpoint exists. Nodes, services and clients have no `gid`,
    because the graph of ROS 2 tells none, and no `hash` either. `owner` is the party of this
    gateway that it belongs to; it is None for those of other processes. The depth of others is
    unknown: 10 stands for it.
    """

    key: str
    kind: Kind
    node: str
    name: str
    type: str
    hash: str
    qos: Qos
    gid: bytes | None = None
    owner: str | None = None


@dataclass(frozen=True)
class Sample:
    """A message that was received.

    `gid` is that of the publisher, `owner` the party that it belongs to, if any. `sequence` counts
    the messages of this publisher, and is None where the middleware does not tell; `time` is that
    of sending (ns since 1970). `latched` says that it was sent before the subscription existed.
    """

    data: bytes
    gid: bytes
    owner: str | None
    sequence: int | None
    time: int
    latched: bool
