"""Actions: the common part of client and server, and the state machine of a goal."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

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

E = TypeVar("E", bound="Endpoint")

# The states of a goal, as in action_msgs/msg/GoalStatus.
STATES = ("UNKNOWN", "ACCEPTED", "EXECUTING", "CANCELING", "SUCCEEDED", "CANCELED", "ABORTED")
ACCEPTED, EXECUTING, CANCELING, SUCCEEDED, CANCELED, ABORTED = range(1, 7)
# The next state by state and event; all other transitions are invalid.
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
    """One side of an action: its services and topics.

    `waited` lists the entities of its wait set, in the order in which rclpy expects them.

    Raises:
        ValueError: if the name is invalid or the context has been shut down.
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

    def _part(
        self,
        create: Callable[[Node, Any, str, rmw_qos_profile_t], E],
        interface: Any,
        name: str,
        profile: rmw_qos_profile_t,
    ) -> E:
        """Create one of its services or topics."""
        part = create(self._node, interface, f"{self._prefix}/{name}", profile)
        self._parts.append(part)
        return part

    def add_to_waitset(self, wait_set: WaitSet) -> None:
        """Add this side to `wait_set`."""
        for entity in self.waited:
            wait_set.add(entity)

    def is_ready(self, wait_set: WaitSet) -> tuple[bool, ...]:
        """Return for each entity whether the last wait found it ready."""
        return tuple(wait_set.found(entity) for entity in self.waited)

    def configure_introspection(
        self,
        clock: Clock,
        pyqos_service_event_pub: rmw_qos_profile_t,
        introspection_state: int,
    ) -> None:
        """Set what its three services publish about their calls: contents, metadata or nothing."""
        for part in self._parts:
            if isinstance(part, ServiceEndpoint):
                part.configure_introspection(clock, pyqos_service_event_pub, introspection_state)

    def _destroy(self) -> None:
        for part in self._parts:
            part.destroy_when_not_in_use()


def goal_id(info: Any) -> bytes:
    """Return the UUID of the goal of a GoalInfo, 16 bytes."""
    return bytes(bytearray(info.goal_id.uuid))


class ActionGoalHandle(Destroyable):
    """A goal that a server has accepted.

    Raises:
        RuntimeError: if the server has a goal with this UUID.
    """

    def __init__(self, action_server: ActionServer, pygoal_info_msg: Any) -> None:
        super().__init__()
        self.info = pygoal_info_msg
        self.status = ACCEPTED
        # When the goal ended, by the server's clock (ns).
        self.done: int | None = None
        action_server.accept(self)

    def get_status(self) -> int:
        """Return the state, as in GoalStatus."""
        return self.status

    def is_active(self) -> bool:
        """Return whether the goal has not ended."""
        return self.status < SUCCEEDED

    def is_cancelable(self) -> bool:
        """Return whether the goal can be canceled."""
        return (self.status, GoalEvent.CANCEL_GOAL) in NEXT

    def update_goal_state(self, event: GoalEvent) -> None:
        """Change the state.

        Raises:
            RCLError: if the event is not valid in this state.
        """
        status = NEXT.get((self.status, event))
        if status is None:
            how = f"from state {STATES[self.status]} with event {event.name}"
            invalid = f"goal_handle attempted invalid transition {how}"
            raise RCLError(f"Failed to update goal state: {invalid}")
        self.status = status
