"""Managed nodes: the lifecycle state machine and its services."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rclpy_backend import log
from rclpy_backend.enums import RCUTILS_LOG_SEVERITY
from rclpy_backend.errors import RCLError
from rclpy_backend.handles import Destroyable
from rclpy_backend.publisher import Publisher
from rclpy_backend.qos import rmw_qos_profile_t
from rclpy_backend.service import Service

if TYPE_CHECKING:
    from rclpy_backend.node import Node

State = tuple[int, str]
# ID and label of the transition, of its start state and of its goal state.
Transition = tuple[int, str, int, str, int, str]

STATES = {
    **{0: "unknown", 1: "unconfigured", 2: "inactive", 3: "active", 4: "finalized"},
    **{10: "configuring", 11: "cleaningup", 12: "shuttingdown", 13: "activating"},
    **{14: "deactivating", 15: "errorprocessing"},
}
UNCONFIGURED, ERROR_PROCESSING = 1, 15
# For each transition state: the transitions into it, by ID, label and start state; then the ID of
# the first transition out of it, and the goal states for success, failure and error.
STEPS = [
    (10, [(1, "configure", 1)], 10, (2, 1, ERROR_PROCESSING)),
    (11, [(2, "cleanup", 2)], 20, (1, 2, ERROR_PROCESSING)),
    (13, [(3, "activate", 2)], 30, (3, 2, ERROR_PROCESSING)),
    (14, [(4, "deactivate", 3)], 40, (2, 3, ERROR_PROCESSING)),
    (12, [(n + 4, "shutdown", n) for n in (1, 2, 3)], 50, (4, 4, ERROR_PROCESSING)),
    (ERROR_PROCESSING, [], 60, (UNCONFIGURED, 4, 4)),
]
OUTCOMES = ("transition_success", "transition_failure", "transition_error")


def _transitions() -> list[Transition]:
    found = []
    for state, into, first, ends in STEPS:
        found += [(n, name, start, state) for n, name, start in into]
        found += [(first + i, OUTCOMES[i], state, end) for i, end in enumerate(ends)]
    return [(n, name, a, STATES[a], b, STATES[b]) for n, name, a, b in found]


TRANSITIONS = _transitions()


class LifecycleStateMachine(Destroyable):
    """The state machine of a node, with services if `enable_com_interface`."""

    def __init__(self, node: Node, enable_com_interface: bool) -> None:
        super().__init__()
        self._state = UNCONFIGURED
        self._services: dict[str, Service] = {}
        self._publisher: Publisher | None = None
        if enable_com_interface:
            self._open(node)

    def _open(self, node: Node) -> None:
        from lifecycle_msgs import msg, srv

        profile = rmw_qos_profile_t.predefined("qos_profile_services_default")
        types = {
            "change_state": srv.ChangeState,
            "get_state": srv.GetState,
            "get_available_states": srv.GetAvailableStates,
            "get_available_transitions": srv.GetAvailableTransitions,
            "get_transition_graph": srv.GetAvailableTransitions,
        }
        for name, service_type in types.items():
            self._services[name] = Service(node, service_type, f"~/{name}", profile)
        default = rmw_qos_profile_t.predefined("qos_profile_default")
        self._publisher = Publisher(node, msg.TransitionEvent, "~/transition_event", default)

    def _destroy(self) -> None:
        for endpoint in (*self._services.values(), self._publisher):
            if endpoint:
                endpoint.destroy_when_not_in_use()

    @property
    def initialized(self) -> bool:
        """Whether the state machine is initialized: always True."""
        return True

    @property
    def current_state(self) -> State:
        """ID and label of the current state."""
        return self._state, STATES[self._state]

    @property
    def available_states(self) -> list[State]:
        """All states."""
        return list(STATES.items())

    @property
    def available_transitions(self) -> list[Transition]:
        """The transitions from the current state."""
        return [transition for transition in TRANSITIONS if transition[2] == self._state]

    @property
    def transition_graph(self) -> list[Transition]:
        """All transitions."""
        return list(TRANSITIONS)

    def get_transition_by_label(self, label: str) -> int:
        """Return the ID of a transition from the current state.

        Raises:
            RCLError: if there is no such transition.
        """
        transition = self._find(1, label)
        if transition is None:
            raise RCLError("Failed to get transition from label: error not set")
        return transition[0]

    def trigger_transition_by_id(self, transition_id: int, publish_update: bool) -> None:
        """Start a transition from the current state.

        Raises:
            RCLError: if the transition is not valid in this state.
        """
        self._trigger(0, transition_id, publish_update=publish_update)

    def trigger_transition_by_label(self, label: str, publish_update: bool) -> None:
        """Start a transition from the current state.

        Raises:
            RCLError: if the transition is not valid in this state.
        """
        self._trigger(1, label, publish_update=publish_update)

    def _trigger(self, column: int, wanted: int | str, *, publish_update: bool) -> None:
        transition = self._find(column, wanted)
        if transition is None:
            reason = "Transition is not registered."
            raise RCLError(f"Failed to trigger lifecycle state machine transition: {reason}")
        self._state = transition[4]
        if publish_update and self._publisher:
            self._publish(transition)

    def _find(self, column: int, wanted: int | str) -> Transition | None:
        for transition in self.available_transitions:
            if transition[column] == wanted:
                return transition
        now = f"for current state {STATES[self._state]}"
        _warn(f"No transition matching {wanted} found {now}")
        return None

    def _publish(self, transition: Transition) -> None:
        from lifecycle_msgs.msg import State, TransitionEvent

        _, _, start, start_name, goal, goal_name = transition
        # As natively, the event has neither a timestamp nor a transition.
        event = TransitionEvent(
            start_state=State(id=start, label=start_name),
            goal_state=State(id=goal, label=goal_name),
        )
        if self._publisher:
            self._publisher.publish(event)

    @property
    def service_change_state(self) -> Service | None:
        """The service that changes the state."""
        return self._services.get("change_state")

    @property
    def service_get_state(self) -> Service | None:
        """The service that returns the state."""
        return self._services.get("get_state")

    @property
    def service_get_available_states(self) -> Service | None:
        """The service that returns all states."""
        return self._services.get("get_available_states")

    @property
    def service_get_available_transitions(self) -> Service | None:
        """The service that returns the transitions from the current state."""
        return self._services.get("get_available_transitions")

    @property
    def service_get_transition_graph(self) -> Service | None:
        """The service that returns all transitions."""
        return self._services.get("get_transition_graph")


def _warn(text: str) -> None:
    severity = RCUTILS_LOG_SEVERITY.RCUTILS_LOG_SEVERITY_WARN
    log.rclpy_logging_rcutils_log(severity, "rcl_lifecycle", text, "", "", 0)
