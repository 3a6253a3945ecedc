"""Action clients."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy_backend.action import Action
from rclpy_backend.service import Client
from rclpy_backend.subscription import Subscription

if TYPE_CHECKING:
    from rclpy_backend.node import Node
    from rclpy_backend.qos import rmw_qos_profile_t


class ActionClient(Action):
    """A client: sends goals and receives feedback, states and results."""

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
        types = pyaction_type.Impl
        self._goal = self._part(Client, types.SendGoalService, "send_goal", goal_service_qos)
        self._cancel = self._part(
            Client, types.CancelGoalService, "cancel_goal", cancel_service_qos
        )
        self._result = self._part(Client, types.GetResultService, "get_result", result_service_qos)
        self._feedback = self._part(
            Subscription, types.FeedbackMessage, "feedback", feedback_service_qos
        )
        self._status = self._part(Subscription, types.GoalStatusMessage, "status", status_topic_qos)
        self._ends = [self._feedback, self._status, self._goal, self._cancel, self._result]
        self.waited = [*self._ends]

    def get_num_entities(self) -> tuple[int, int, int, int, int]:
        """Return the numbers of subscriptions, guard conditions, timers, clients and services."""
        return 2, 0, 0, 3, 0

    def is_action_server_available(self) -> bool:
        """Return whether all services and topics of a server are available.

        Raises:
            RCLError: if the context has been shut down.
        """
        self._node.context.check("Failed to check if action server is available")
        return all(end.matched() for end in self._ends)

    def send_goal_request(self, request: Any) -> int:
        """Send a goal; return the sequence number of the request."""
        return self._goal.send_request(request)

    def send_cancel_request(self, request: Any) -> int:
        """Request cancellation; return the sequence number of the request."""
        return self._cancel.send_request(request)

    def send_result_request(self, request: Any) -> int:
        """Request a result; return the sequence number of the request."""
        return self._result.send_request(request)

    def take_goal_response(self, response_type: type) -> tuple[int, Any] | tuple[None, None]:
        """Return the sequence number of a goal request and its response, or two Nones."""
        return _numbered(self._goal, response_type)

    def take_cancel_response(self, response_type: type) -> tuple[int, Any] | tuple[None, None]:
        """Return the sequence number of a cancel request and its response, or two Nones."""
        return _numbered(self._cancel, response_type)

    def take_result_response(self, response_type: type) -> tuple[int, Any] | tuple[None, None]:
        """Return the sequence number of a result request and its response, or two Nones."""
        return _numbered(self._result, response_type)

    def take_feedback(self, message_type: type) -> Any:
        """Return the oldest feedback message, or None."""
        return _message(self._feedback, message_type)

    def take_status(self, message_type: type) -> Any:
        """Return the oldest status message, or None."""
        return _message(self._status, message_type)


def _numbered(client: Client, response_type: type) -> tuple[int, Any] | tuple[None, None]:
    info, response = client.take_response(response_type)
    return (None, None) if info is None else (info.request_id.sequence_number, response)


def _message(subscription: Subscription, message_type: type) -> Any:
    taken = subscription.take_message(message_type, raw=False)
    return taken[0] if taken else None
