"""Action servers."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from rclpy_backend.action import Action, ActionGoalHandle, goal_id
from rclpy_backend.publisher import Publisher
from rclpy_backend.service import Service, rmw_request_id_t
from rclpy_backend.timer import Timer

if TYPE_CHECKING:
    from rclpy_backend.clock import Clock
    from rclpy_backend.node import Node
    from rclpy_backend.qos import rmw_qos_profile_t

SECOND = 10**9
# Return codes of action_msgs/srv/CancelGoal.
UNKNOWN_GOAL_ID, GOAL_TERMINATED = 2, 3
NO_GOAL = bytes(16)


class ActionServer(Action):
    """A server: accepts goals, sends feedback, and keeps results for `result_timeout` seconds."""

    def __init__(
        self,
        node: Node,
        rclpy_clock: Clock,
        pyaction_type: Any,
        action_name: str,
        goal_service_qos: rmw_qos_profile_t,
        result_service_qos: rmw_qos_profile_t,
        cancel_service_qos: rmw_qos_profile_t,
        feedback_topic_qos: rmw_qos_profile_t,
        status_topic_qos: rmw_qos_profile_t,
        result_timeout: float,
    ) -> None:
        super().__init__("server", node, action_name)
        types = pyaction_type.Impl
        self._goal = self._part(Service, types.SendGoalService, "send_goal", goal_service_qos)
        self._cancel = self._part(
            Service, types.CancelGoalService, "cancel_goal", cancel_service_qos
        )
        self._result = self._part(Service, types.GetResultService, "get_result", result_service_qos)
        self._feedback = self._part(
            Publisher, types.FeedbackMessage, "feedback", feedback_topic_qos
        )
        self._status = self._part(Publisher, types.GoalStatusMessage, "status", status_topic_qos)
        self._clock = rclpy_clock
        # If negative, results never expire.
        self._keep = round(result_timeout * SECOND)
        self._expiry = Timer(rclpy_clock, node.context, max(self._keep, 0), autostart=False)
        self._goals: dict[bytes, ActionGoalHandle] = {}
        self.waited = [self._goal, self._cancel, self._result, self._expiry]
        self._parts.append(self._expiry)

    def get_num_entities(self) -> tuple[int, int, int, int, int]:
        """Return the numbers of subscriptions, guard conditions, timers, clients and services."""
        return 0, 0, 1, 0, 3

    def accept(self, goal: ActionGoalHandle) -> None:
        """Add a goal.

        Raises:
            RuntimeError: if there is a goal with this UUID.
        """
        name = goal_id(goal.info)
        if name in self._goals:
            raise RuntimeError("Failed to accept new goal: goal ID already exists")
        self._goals[name] = goal

    def goal_exists(self, goal_info: Any) -> bool:
        """Return whether there is a goal with this UUID."""
        return goal_id(goal_info) in self._goals

    def take_goal_request(
        self, request_type: type
    ) -> tuple[rmw_request_id_t, Any] | tuple[None, None]:
        """Return the id of the oldest goal request and the request, or two Nones."""
        return _asked(self._goal, request_type)

    def take_cancel_request(
        self, request_type: type
    ) -> tuple[rmw_request_id_t, Any] | tuple[None, None]:
        """Return the id of the oldest cancel request and the request, or two Nones."""
        return _asked(self._cancel, request_type)

    def take_result_request(
        self, request_type: type
    ) -> tuple[rmw_request_id_t, Any] | tuple[None, None]:
        """Return the id of the oldest result request and the request, or two Nones."""
        return _asked(self._result, request_type)

    def send_goal_response(self, header: rmw_request_id_t, response: Any) -> None:
        """Respond to a goal request."""
        self._goal.service_send_response(response, header)

    def send_cancel_response(self, header: rmw_request_id_t, response: Any) -> None:
        """Respond to a cancel request."""
        self._cancel.service_send_response(response, header)

    def send_result_response(self, header: rmw_request_id_t, response: Any) -> None:
        """Respond to a result request."""
        self._result.service_send_response(response, header)

    def publish_feedback(self, message: Any) -> None:
        """Publish feedback."""
        self._feedback.publish(message)

    def publish_status(self) -> None:
        """Publish the states of all goals."""
        from action_msgs.msg import GoalStatus, GoalStatusArray

        goals = self._goals.values()
        states = [GoalStatus(goal_info=goal.info, status=goal.status) for goal in goals]
        self._status.publish(GoalStatusArray(status_list=states))

    def process_cancel_request(self, request: Any, response_type: Any) -> Any:
        """Return the response to a cancel request, with the goals that can be canceled."""
        response = response_type()
        name, stamp = goal_id(request.goal_info), _nanoseconds(request.goal_info.stamp)
        if name != NO_GOAL and not stamp:
            goal = self._goals.get(name)
            if goal is None:
                response.return_code = UNKNOWN_GOAL_ID
            elif not goal.is_cancelable():
                response.return_code = GOAL_TERMINATED
        found = self._meant(name, stamp)
        response.goals_canceling = [goal.info for goal in found if goal.is_cancelable()]
        return response

    def _meant(self, name: bytes, stamp: int) -> Iterator[ActionGoalHandle]:
        """Yield the goals that a cancel request selects: one, those up to a time, or all."""
        for own, goal in self._goals.items():
            every = name == NO_GOAL and not stamp
            early = bool(stamp) and _nanoseconds(goal.info.stamp) <= stamp
            if every or early or own == name:
                yield goal

    def notify_goal_done(self) -> None:
        """Record the time at which goals ended, and schedule their expiry."""
        now = self._clock.now()
        for goal in self._goals.values():
            if not goal.is_active() and goal.done is None:
                goal.done = now
        self._expect_expiry()

    def expire_goals(self, max_num_goals: int) -> tuple[Any, ...]:
        """Remove up to `max_num_goals` goals whose results have expired, and return them."""
        end = self._clock.now() - self._keep
        old = [n for n, g in self._goals.items() if g.done is not None and g.done <= end]
        gone = tuple(self._goals.pop(name).info for name in old[:max_num_goals])
        self._expect_expiry()
        return gone

    def _expect_expiry(self) -> None:
        """Set the timer to the time at which the next result expires."""
        ends = [goal.done for goal in self._goals.values() if goal.done is not None]
        if not ends or self._keep < 0:
            self._expiry.cancel_timer()
            return
        self._expiry.change_timer_period(max(min(ends) + self._keep - self._clock.now(), 0))
        self._expiry.reset_timer()


def _asked(
    service: Service, request_type: type
) -> tuple[rmw_request_id_t, Any] | tuple[None, None]:
    request, info = service.service_take_request(request_type)
    return (None, None) if info is None else (info.request_id, request)


def _nanoseconds(stamp: Any) -> int:
    return int(stamp.sec) * SECOND + int(stamp.nanosec)
