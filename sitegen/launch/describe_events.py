"""Processes of Python launch files, their events, and what is done then."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from types import SimpleNamespace
from typing import Any

from sitegen.launch import commandline, without
from sitegen.launch.describe_actions import (
    Described,
    Text,
    ending,
    inside_of,
    is_function,
    text,
    variables,
)

PROCESSES = ("ExecuteProcess", "ExecuteLocal")
TRANSITIONS = ("CREATE", "CONFIGURE", "CLEANUP", "ACTIVATE", "DEACTIVATE")
SHUTDOWNS = ("UNCONFIGURED_SHUTDOWN", "INACTIVE_SHUTDOWN", "ACTIVE_SHUTDOWN")
# The module in which launch files find the numbers of transitions.
LIFECYCLE = {
    "Transition": SimpleNamespace(
        **{f"TRANSITION_{name}": n for n, name in enumerate((*TRANSITIONS, *SHUTDOWNS))}
    )
}


def handler(event_handler: Any = None, *, condition: Any = None, **_: Any) -> Described:
    """Stand in for RegisterEventHandler."""
    if not isinstance(event_handler, Described) or event_handler.kind != "event_handler":
        return Described("event_handler", why=without.NO_EVENT, condition=condition)
    given = event_handler.attributes
    return Described("event_handler", event_handler.inside, condition=condition, **given)


def of_process(event: str, given: str) -> Callable[..., Described]:
    """Return a stand-in for a handler of an event of processes; `given` is its keyword."""

    def on(*, target_action: Any = None, handle_once: bool = False, **of: Any) -> Described:
        if set(of) != {given}:
            raise TypeError(f"expected the keyword arguments 'target_action' and '{given}'")
        return _handler(event, of[given], handle_once, target_action)

    return on


def of_state(
    *,
    entities: Any,
    target_lifecycle_node: Any = None,
    transition: Any = None,
    start_state: Any = None,
    goal_state: Any = None,
    matcher: Any = None,
    handle_once: bool = False,
) -> Described:
    """Stand in for OnStateTransition."""
    if matcher is not None:
        return Described("event_handler", why=without.FUNCTION)
    states = {"transition": transition, "start_state": start_state, "goal_state": goal_state}
    return _handler("state", entities, handle_once, target_lifecycle_node, **states)


def of_shutdown(*, on_shutdown: Any, handle_once: bool = False, **_: Any) -> Described:
    """Stand in for OnShutdown."""
    return _handler("shutdown", on_shutdown, handle_once)


def _handler(event: str, actions: Any, once: bool, target: Any = None, **states: Any) -> Described:
    if is_function(actions) or is_function(target):
        return Described("event_handler", why=without.FUNCTION)
    about = target.id if isinstance(target, Described) else None
    own = {"event": event, "once": once, "target": about, **states}
    return Described("event_handler", inside_of(actions), **own)


def emitted(*, event: Any, condition: Any = None, **_: Any) -> Described:
    """Stand in for EmitEvent."""
    if not isinstance(event, Described):
        return Described("event", condition=condition)
    return Described(event.kind, condition=condition, **event.attributes)


def change_state(*, lifecycle_node_matcher: Any, transition_id: Any) -> Described:
    """Stand in for the event ChangeState."""
    return Described("change_state", transition=transition_id, **_matched(lifecycle_node_matcher))


def end_process(*_: Any, process_matcher: Any, **__: Any) -> Described:
    """Stand in for the events ShutdownProcess and SignalProcess."""
    return Described("stop", **_matched(process_matcher))


def _matched(matcher: Any) -> dict[str, Any]:
    """Return which nodes an event is for."""
    is_known = isinstance(matcher, Described) and matcher.kind == "matcher"
    return dict(matcher.attributes) if is_known else {"why": without.FUNCTION}


def matches_action(action: Any) -> Described:
    """Stand in for the function of that name."""
    return Described("matcher", target=action.id)


def matches_node_name(node_name: Any) -> Described:
    """Stand in for the function of that name."""
    return Described("matcher", node=node_name)


def unmatched(*_: Any) -> Described:
    """Stand in for functions that match processes by what they do not have on a page."""
    return Described("matcher", why=without.NOT_MEANT)


def transitions(
    *,
    lifecycle_node_names: Iterable[Any],
    transition_ids: Iterable[Any],
    condition: Any = None,
    **_: Any,
) -> Described:
    """Stand in for LifecycleTransition."""
    names = [Described("lifecycle_node_name", value=name) for name in lifecycle_node_names]
    ids = [Described("transition_id", value=number) for number in transition_ids]
    return Described("lifecycle_transition", [*names, *ids], condition=condition)


def shutdown(*, reason: Any = "", condition: Any = None, **_: Any) -> Described:
    """Stand in for the action and the event Shutdown."""
    return Described("shutdown", reason=reason, condition=condition)


def timer(kind: str) -> Callable[..., Described]:
    """Return a stand-in for an action that does others later."""

    def of(*_: Any, period: Any, actions: Any, condition: Any = None, **__: Any) -> Described:
        return Described(kind, actions, period=period, condition=condition)

    return of


def process(
    *_: Any,
    cmd: Any = (),
    shell: bool = False,
    env: Mapping[Any, Any] | None = None,
    additional_env: Mapping[Any, Any] | None = None,
    condition: Any = None,
    on_exit: Any = None,
    respawn: Any = None,
    respawn_delay: Any = None,
    respawn_max_retries: Any = None,
    **__: Any,
) -> Described:
    """Describe a process by its command line."""
    words = [text(word) for word in cmd]
    return Described(
        "executable",
        [*variables(env, additional_env), *ending(on_exit)],
        cmd=" ".join(words) if shell else commandline.join(words),
        clean_env=None if env is None else True,
        condition=condition,
        respawn=respawn,
        respawn_delay=respawn_delay,
        respawn_max_retries=respawn_max_retries,
    )


def log(level: str) -> Callable[..., Described]:
    """Return a stand-in for an action that writes to the log of launch."""

    def of(*, msg: Any = "", level: Any = level, condition: Any = None, **_: Any) -> Described:
        try:
            return Described("log", message=msg, level=level, condition=condition)
        except TypeError:
            return Described("log", message="", level=level, condition=condition)

    return of


def local(expression: Any, *_: Any, **__: Any) -> Text:
    """Stand in for LocalSubstitution, which tells of an event."""
    return Text(text(expression).join(without.LOCAL))


def unsupported(kind: str) -> Callable[..., Described]:
    """Return a stand-in for a feature that a page does not have."""
    return lambda *_, **__: Described(kind, why=without.NO_EVENT)


MEMBERS: dict[str, Any] = {
    **dict.fromkeys(PROCESSES, process),
    "OnProcessStart": of_process("started", "on_start"),
    "OnProcessExit": of_process("exited", "on_exit"),
    "OnExecutionComplete": of_process("exited", "on_completion"),
    "OnStateTransition": of_state,
    "OnShutdown": of_shutdown,
    "OnProcessIO": lambda **_: Described("event_handler", why=without.FUNCTION),
    **dict.fromkeys(
        ("EventHandler", "OnIncludeLaunchDescription", "UnregisterEventHandler"),
        unsupported("event_handler"),
    ),
    "RegisterEventHandler": handler,
    "EmitEvent": emitted,
    "ChangeState": change_state,
    **dict.fromkeys(("ShutdownProcess", "SignalProcess"), end_process),
    **dict.fromkeys(("ProcessExited", "ProcessStarted"), unsupported("event")),
    "matches_action": matches_action,
    "matches_node_name": matches_node_name,
    **dict.fromkeys(("matches_executable", "matches_name", "matches_pid"), unmatched),
    "LifecycleTransition": transitions,
    "Shutdown": shutdown,
    "TimerAction": timer("timer"),
    **dict.fromkeys(("RosTimer", "ROSTimer"), timer("ros_timer")),
    **{f"Log{level.capitalize()}": log(level) for level in ("debug", "info", "warning", "error")},
    "Log": log("info"),
    "LocalSubstitution": local,
}
