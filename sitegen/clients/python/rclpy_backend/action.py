"""Actions: what client and server have in common, and the life of a goal."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy_backend import names
from rclpy_backend.enums import GoalEvent
from rclpy_backend.errors import RCLError
from rclpy_backend.handles import Destroyable
from rclpy_backend.service import ServiceEndpoint

if TYPE_CHECKING:
    from rclpy_backend.action_server import ActionServer
    from rclpy_backend.clock import Clock
    from rclpy_backend.endpoint import Endpoint
    from rclpy_backend.node import Node
    from rclpy_backend.qos import rmw_qos_profile_t
    from rclpy_backend.timer import Timer
    from rclpy_backend.wait_set import WaitSet

# The states of a goal, as action_msgs/msg/GoalStatus has them.
STATES = ("UNKNOWN", "ACCEPTED", "EXECUTING", "CANCELING", "SUCCEEDED", "CANCELED", "ABORTED")
ACCEPTED, EXECUTING, CANCELING, SUCCEEDED, CANCELED, ABORTED = range(1, 7)
# What an event makes of a state; no other event may happen in it.
NEXT = {
    (ACCEPTED, GoalEvent.EXECUTE): EXECUTING,
    (ACCEPTED, GoalEvent.CANCEL_GOAL): CANCELING,
    (EXECUTING, GoalEvent.CANCEL_GOAL): CANCELING,
    (EXECUTING, GoalEvent.SUCCEED): SUCCEEDED,
    (EXECUTING, GoalEvent.ABORT): ABORTED,
    (CANCELING, GoalEvent.SUCCEED): SUCCEEDED,
    (CANCELING, GoalEvent.ABORT): ABORTED,
    (CANCELING, GoalEvent.CANCELED): CANCELED,
}


class Action(Destroyable):
    """One side of an action: services and topics with its name; raises a ValueError if it is none.

    `waited` are those that a wait set waits for, in the order in which rclpy asks for them.
    """

    def __init__(self, side: str, node: Node, name: str) -> None:
        super().__init__()
        try:
            names.rclpy_resolve_name(node, name, False, True)
        except RCLError as error:
            reason = str(error).rpartition(" is invalid: ")[2]
            invalid = f"due to invalid topic name '{name}' : {reason}"
            raise ValueError(f"Failed to create action {side} {invalid}") from None
        try:
            node.context.check(f"Failed to create action {side}")
        except RCLError as error:
            raise ValueError(str(error)) from None
        self._node = node
        self._prefix = f"{name}/_action"
        self.waited: list[Endpoint | Timer] = []
        self._parts: list[Endpoint | Timer] = []

    def add_to_waitset(self, wait_set: WaitSet) -> None:
        """Let `wait_set` wait for this side."""
        for entity in self.waited:
            wait_set.add(entity)

    def is_ready(self, wait_set: WaitSet) -> tuple[bool, ...]:
        """Return which of its parts the last wait found ready."""
        return tuple(wait_set.found(entity) for entity in self.waited)

    def configure_introspection(
        self,
        clock: Clock,
        pyqos_service_event_pub: rmw_qos_profile_t,
        introspection_state: int,
    ) -> None:
        """Publish from now on what its three services are asked, or that they are, or nothing."""
        for part in self._parts:
            if isinstance(part, ServiceEndpoint):
                part.configure_introspection(clock, pyqos_service_event_pub, introspection_state)

    def _destroy(self) -> None:
        for part in self._parts:
            part.destroy_when_not_in_use()


def goal_id(info: Any) -> bytes:
    """Return the 16 bytes that name the goal of a GoalInfo."""
    return bytes(bytearray(info.goal_id.uuid))


class ActionGoalHandle(Destroyable):
    """A goal that a server has accepted; raises a RuntimeError if it already has."""

    def __init__(self, action_server: ActionServer, pygoal_info_msg: Any) -> None:
        super().__init__()
        self.info = pygoal_info_msg
        self.status = ACCEPTED
        # When it came to its end, in ns of the server's clock.
        self.done: int | None = None
        action_server.accept(self)

    def get_status(self) -> int:
        """Return its state, a number of GoalStatus."""
        return self.status

    def is_active(self) -> bool:
        """Return whether it has not come to its end."""
        return self.status < SUCCEEDED

    def is_cancelable(self) -> bool:
        """Return whether it can still be asked to end."""
        return (self.status, GoalEvent.CANCEL_GOAL) in NEXT

    def update_goal_state(self, event: GoalEvent) -> None:
        """Let an event happen; raises an RCLError if it cannot now."""
        status = NEXT.get((self.status, event))
        if status is None:
            how = f"from state {STATES[self.status]} with event {event.name}"
            invalid = f"goal_handle attempted invalid transition {how}"
            raise RCLError(f"Failed to update goal state: {invalid}")
        self.status = status
