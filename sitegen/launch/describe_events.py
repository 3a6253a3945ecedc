"""Processes and events of Python launch files.

A page has no events: what these describe is skipped, and reported by its name in XML launch files.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import SimpleNamespace
from typing import Any

from sitegen.launch import commandline
from sitegen.launch.describe_actions import Described, text, variables

PROCESSES = ("ExecuteProcess", "ExecuteLocal")
HANDLERS = (
    *("EventHandler", "OnExecutionComplete", "OnIncludeLaunchDescription", "OnProcessExit"),
    *("OnProcessIO", "OnShutdown", "OnStateTransition"),
)
EVENTS = (
    *("ChangeState", "ProcessExited", "ProcessStarted", "ShutdownProcess", "SignalProcess"),
    *("matches_action", "matches_executable", "matches_name", "matches_node_name", "matches_pid"),
)
TRANSITIONS = ("CREATE", "CONFIGURE", "CLEANUP", "ACTIVATE", "DEACTIVATE")
SHUTDOWNS = ("UNCONFIGURED_SHUTDOWN", "INACTIVE_SHUTDOWN", "ACTIVE_SHUTDOWN")
# The module in which launch files find the numbers of transitions.
LIFECYCLE = {
    "Transition": SimpleNamespace(
        **{f"TRANSITION_{name}": n for n, name in enumerate((*TRANSITIONS, *SHUTDOWNS))}
    )
}


def handler(event_handler: Any = None, **_: Any) -> Any:
    """Stand in for RegisterEventHandler."""
    started_with = getattr(event_handler, "kind", "") == "group"
    return event_handler if started_with else Described("event_handler")


def started(*_: Any, on_start: Any = (), **__: Any) -> Described:
    """Stand in for OnProcessStart: all nodes of a page start together."""
    actions = on_start if isinstance(on_start, (list, tuple)) else [on_start]
    return Described("group", [each for each in actions if not callable(each)], scoped=False)


def timer(*_: Any, period: Any, actions: Any, condition: Any = None, **__: Any) -> Described:
    """Stand in for TimerAction."""
    return Described("timer", actions, period=period, condition=condition)


def process(
    *_: Any,
    cmd: Any = (),
    shell: bool = False,
    env: Mapping[Any, Any] | None = None,
    additional_env: Mapping[Any, Any] | None = None,
    condition: Any = None,
    **__: Any,
) -> Described:
    """Describe a process by its command line."""
    words = [text(word) for word in cmd]
    line = " ".join(words) if shell else commandline.join(words)
    alone = None if env is None else True
    inside = variables(env, additional_env)
    return Described("executable", inside, cmd=line, clean_env=alone, condition=condition)


def nothing(*_: Any, **__: Any) -> None:
    """Stand in for features that are only useful with events."""


MEMBERS: dict[str, Any] = {
    **dict.fromkeys(PROCESSES, process),
    **dict.fromkeys((*HANDLERS, *EVENTS), nothing),
    "RegisterEventHandler": handler,
    "UnregisterEventHandler": lambda *_, **__: Described("event_handler"),
    "OnProcessStart": started,
    "EmitEvent": lambda *_, **__: Described("event"),
    "LifecycleTransition": lambda *_, **__: Described("lifecycle_transition"),
    "Shutdown": lambda *_, **__: Described("shutdown"),
    "TimerAction": timer,
    **dict.fromkeys(("RosTimer", "ROSTimer"), timer),
    "LocalSubstitution": lambda *_, **__: "",  # tells of an event
}
