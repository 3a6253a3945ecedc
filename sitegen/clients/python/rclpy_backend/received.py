"""Messages, requests and responses as they wait at an endpoint."""

from __future__ import annotations

from typing import NamedTuple

import ros_host

from rclpy_backend.clock import MILLISECOND


class Received(NamedTuple):
    """The bytes of a message; the name its writer has in the page; its number; times in ns."""

    data: bytes
    writer: int
    sequence: int
    source_timestamp: int
    received_timestamp: int


def take(endpoint: int) -> Received | None:
    """Remove the oldest message that waits at the endpoint with this id, and return it."""
    sample = ros_host.take(endpoint)
    if sample is None:
        return None
    return Received(
        sample.message.to_bytes(),
        int(sample.writer),
        sample.sequence,
        round(sample.timestamp * MILLISECOND),
        round(sample.received * MILLISECOND),
    )
