"""Clients of actions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy_backend.action import Action
from rclpy_backend.service import Client
from rclpy_backend.subscription import Subscription

if TYPE_CHECKING:
    from rclpy_backend.node import Node
    from rclpy_backend.qos import rmw_qos_profile_t


class ActionClient(Action):
    """Sends goals, and hears how they get on."""

    def __init__(
        self,
        node: Node,
        pyaction_type: Any,
        action_name: str,
        goal_service_qos: rmw_qos_profile_t,
        result_service_qos: rmw_qos_profile_t,
        cancel_service_qos: rmw_qos_profile_t,
        feedback_service_qos: rmw_qos_profile_t,
        status_topic_qos: rmw_qos_profile_t,
    ) -> None:
        super().__init__("client", node, action_name)
        prefix, types = self._prefix, pyaction_type.Impl
        self._goal = Client(node, types.SendGoalService, f"{prefix}/send_goal", goal_service_qos)
        self._cancel = Client(
            node, types.CancelGoalService, f"{prefix}/cancel_goal", cancel_service_qos
        )
        self._result = Client(
            node, types.GetResultService, f"{prefix}/get_result", result_service_qos
        )
        self._feedback = Subscription(
            node, types.FeedbackMessage, f"{prefix}/feedback", feedback_service_qos
        )
        self._status = Subscription(
            node, types.GoalStatusMessage, f"{prefix}/status", status_topic_qos
        )
        self._ends = [self._feedback, self._status, self._goal, self._cancel, self._result]
        self.waited = [*self._ends]
        self._parts = [*self._ends]

    def get_num_entities(self) -> tuple[int, int, int, int, int]:
        """Return how many subscriptions, guard conditions, timers, clients and services it has."""
        return 2, 0, 0, 3, 0

    def is_action_server_available(self) -> bool:
        """Return whether a server is there, with all that belongs to it."""
        self._node.context.check("Failed to check if action server is available")
        return all(end.matched() for end in self._ends)

    def send_goal_request(self, request: Any) -> int:
        """Ask for a goal; return the number of the request."""
        return self._goal.send_request(request)

    def send_cancel_request(self, request: Any) -> int:
        """Ask that goals end; return the number of the request."""
        return self._cancel.send_request(request)

    def send_result_request(self, request: Any) -> int:
        """Ask for a result; return the number of the request."""
        return self._result.send_request(request)

    def take_goal_response(self, response_type: type) -> tuple[int, Any] | tuple[None, None]:
        """Return whether a goal was accepted, after the number of its request."""
        return _numbered(self._goal, response_type)

    def take_cancel_response(self, response_type: type) -> tuple[int, Any] | tuple[None, None]:
        """Return which goals will end, after the number of the request."""
        return _numbered(self._cancel, response_type)

    def take_result_response(self, response_type: type) -> tuple[int, Any] | tuple[None, None]:
        """Return a result, after the number of its request."""
        return _numbered(self._result, response_type)

    def take_feedback(self, message_type: type) -> Any:
        """Return the oldest feedback, or None."""
        return _message(self._feedback, message_type)

    def take_status(self, message_type: type) -> Any:
        """Return the oldest list of the states of goals, or None."""
        return _message(self._status, message_type)


def _numbered(client: Client, response_type: type) -> tuple[int, Any] | tuple[None, None]:
    info, response = client.take_response(response_type)
    return (None, None) if info is None else (info.request_id.sequence_number, response)


def _message(subscription: Subscription, message_type: type) -> Any:
    taken = subscription.take_message(message_type, raw=False)
    return taken[0] if taken else None
