"""What rclpy asks of its extension and this release does not do: each says so when it is used.

tests/test_rclpy.py holds the list of these, with the reasons.
"""

from __future__ import annotations

from typing import Any, Never

from rclpy_backend.errors import NotImplementedError

_GRAPH = "asking the graph who is in it"


def refuse(what: str) -> Never:
    """Raise the error that says that `what` is not there."""
    raise NotImplementedError(f"{what} does not work in a page yet")


class GraphQueries:
    """The questions of a node about the whole graph."""

    def get_count_publishers(self, topic_name: str) -> int:
        """Refuse to count publishers."""
        refuse(_GRAPH)

    def get_count_subscribers(self, topic_name: str) -> int:
        """Refuse to count subscriptions."""
        refuse(_GRAPH)

    def get_count_clients(self, service_name: str) -> int:
        """Refuse to count clients."""
        refuse(_GRAPH)

    def get_count_services(self, service_name: str) -> int:
        """Refuse to count servers."""
        refuse(_GRAPH)

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        """Refuse to name the nodes."""
        refuse(_GRAPH)

    def get_node_names_and_namespaces_with_enclaves(self) -> list[tuple[str, str, str]]:
        """Refuse to name the nodes."""
        refuse(_GRAPH)

    def get_action_client_names_and_types_by_node(self, *_: str) -> list[tuple[str, list[str]]]:
        """Refuse to name actions."""
        refuse(_GRAPH)

    def get_action_server_names_and_types_by_node(self, *_: str) -> list[tuple[str, list[str]]]:
        """Refuse to name actions."""
        refuse(_GRAPH)

    def get_action_names_and_types(self) -> list[tuple[str, list[str]]]:
        """Refuse to name actions."""
        refuse(_GRAPH)


def rclpy_get_topic_names_and_types(*_: Any) -> Never:
    """Refuse to name topics."""
    refuse(_GRAPH)


def rclpy_get_publisher_names_and_types_by_node(*_: Any) -> Never:
    """Refuse to name topics."""
    refuse(_GRAPH)


def rclpy_get_subscriber_names_and_types_by_node(*_: Any) -> Never:
    """Refuse to name topics."""
    refuse(_GRAPH)


def rclpy_get_publishers_info_by_topic(*_: Any) -> Never:
    """Refuse to describe publishers."""
    refuse(_GRAPH)


def rclpy_get_subscriptions_info_by_topic(*_: Any) -> Never:
    """Refuse to describe subscriptions."""
    refuse(_GRAPH)


def rclpy_get_service_names_and_types(*_: Any) -> Never:
    """Refuse to name services."""
    refuse(_GRAPH)


def rclpy_get_service_names_and_types_by_node(*_: Any) -> Never:
    """Refuse to name services."""
    refuse(_GRAPH)


def rclpy_get_client_names_and_types_by_node(*_: Any) -> Never:
    """Refuse to name services."""
    refuse(_GRAPH)


class ActionClient:
    """Refuses to be made."""

    def __init__(self, *_: Any) -> None:
        refuse("an action client of rclpy")


class ActionServer:
    """Refuses to be made."""

    def __init__(self, *_: Any) -> None:
        refuse("an action server of rclpy")


class ActionGoalHandle:
    """Refuses to be made."""

    def __init__(self, *_: Any) -> None:
        refuse("a goal of an action of rclpy")


class LifecycleStateMachine:
    """Refuses to be made."""

    def __init__(self, *_: Any) -> None:
        refuse("a lifecycle node of rclpy")


class EventsExecutor:
    """Refuses to be made."""

    def __init__(self, *_: Any) -> None:
        refuse("the experimental EventsExecutor")
