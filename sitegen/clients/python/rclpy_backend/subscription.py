"""Subscriptions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Never

from rclpy_backend import cdr, log
from rclpy_backend.endpoint import Endpoint, gid_bytes
from rclpy_backend.errors import RCLError, unsupported
from rclpy_backend.qos import rmw_qos_profile_t
from rclpy_backend.received import take

if TYPE_CHECKING:
    from rclpy_backend.node import Node

NO_FILTER = "content filtering is not supported in the browser"


class Subscription(Endpoint):
    """Receives messages of one type from a topic."""

    def __init__(
        self,
        node: Node,
        message_type: type,
        topic: str,
        profile: rmw_qos_profile_t,
        content_filter_options: object = None,
    ) -> None:
        if content_filter_options is not None:
            unsupported("a subscription with a content filter")
        super().__init__("subscription", node, message_type, topic, profile)
        self._received = 0

    def get_topic_name(self) -> str:
        """Return the full name of the topic."""
        return self._full_name

    def get_publisher_count(self) -> int:
        """Return the number of matched publishers."""
        return self.matched()

    def take_message(self, message_type: type, raw: bool) -> tuple[Any, dict[str, Any]] | None:
        """Return the oldest message, or its bytes if `raw`, with its metadata; or None."""
        sample = take(self.id)
        if sample is None:
            return None
        self._received += 1
        info = {
            "source_timestamp": sample.source_timestamp,
            "received_timestamp": sample.received_timestamp,
            "publication_sequence_number": sample.sequence,
            "reception_sequence_number": self._received,
            "publisher_gid": {
                "implementation_identifier": log.IDENTIFIER,
                "data": gid_bytes(sample.writer_gid),
            },
        }
        if raw:
            return sample.data, info
        try:
            return cdr.deserialize(sample.data, message_type), info
        except cdr.CdrError as error:
            log.report(f"dropped {len(sample.data)} bytes on '{self._full_name}': {error}")
            return None

    def is_cft_enabled(self) -> bool:
        """Return whether content filtering is enabled: never."""
        return False

    def set_content_filter(
        self, filter_expression: str, expression_parameters: Sequence[str]
    ) -> Never:
        """Report that content filtering is unsupported.

        Raises:
            RCLError: always.
        """
        raise RCLError(NO_FILTER)

    def get_content_filter(self) -> Never:
        """Report that content filtering is unsupported.

        Raises:
            RCLError: always.
        """
        raise RCLError(NO_FILTER)
