"""Received messages, requests and responses."""

from __future__ import annotations

from typing import NamedTuple

import ros_host

from rclpy_backend.clock import MILLISECOND


class Received(NamedTuple):
    """A received message, with the gid of its writer, sequence number and timestamps (ns)."""

    data: bytes
    writer_gid: int
    sequence: int
    source_timestamp: int
    received_timestamp: int


def take(endpoint: int) -> Received | None:
    """Take the oldest message of the endpoint with this id, or None."""
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
