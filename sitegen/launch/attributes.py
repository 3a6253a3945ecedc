"""The attributes of actions in XML and YAML launch files: those that launch and launch_ros read."""

from __future__ import annotations

from sitegen.errors import nearest
from sitegen.launch.tree import Action

# Every action has these.
CONDITIONS = ("if", "unless")
PROCESS = (
    *("cwd", "emulate_tty", "launch_prefix", "name", "on_exit", "output", "respawn"),
    *("respawn_delay", "respawn_max_retries", "shell", "sigkill_timeout", "sigterm_timeout"),
)
NODE = (*PROCESS, "args", "exec", "exec_name", "namespace", "node_name", "pkg", "ros_args")
PAIR = ("name", "value")
KNOWN = {
    "append_env": (*PAIR, "prepend", "separator"),
    "arg": ("name", "default", "description"),
    "bool_arg": ("name", "default", "description"),
    "executable": ("cmd", *PROCESS),
    "for": ("len", "name"),
    "for_each": ("values",),
    "group": ("scoped", "forwarding"),
    "include": ("file",),
    "let": PAIR,
    "lifecycle_node": (*NODE, "autostart"),
    "load_composable_node": ("target",),
    "log": ("message", "level"),
    **{f"log_{level}": ("message",) for level in ("debug", "error", "info", "warning")},
    "node": NODE,
    "node_container": NODE,
    "push_namespace": ("namespace",),
    "push_ros_namespace": ("namespace",),
    "rep_env": (),
    "reset": (),
    "reset_env": (),
    "set_env": PAIR,
    "set_parameter": PAIR,
    "set_parameters_from_file": ("filename",),
    "set_remap": ("from", "to"),
    "set_ros_log_dir": ("new_log_dir",),
    "set_use_sim_time": ("value",),
    "shutdown": ("reason",),
    "timer": ("period", "cancel_on_shutdown"),
    "ros_timer": ("period",),
    "unset_env": ("name",),
}
# Actions that only Python has.
OF_PYTHON = {
    *("change_state", "event", "event_handler", "function", "lifecycle_transition", "pop_env"),
    *("pop_launch_configurations", "push_env", "push_launch_configurations", "stop"),
    "unset_launch_configuration",
}
# Those of the parts of an action, by the name of the part.
PARTS = {
    "arg": PAIR,
    "choice": ("value",),
    "composable_node": ("name", "namespace", "pkg", "plugin", *CONDITIONS),
    "env": PAIR,
    "extra_arg": PAIR,
    "keep": PAIR,
    "let": PAIR,
    "param": (*PAIR, "allow_substs", "from", "type"),
    "remap": ("from", "to"),
}
# The parts that an action has; groups, loops and timers have actions besides.
OF = {
    "arg": ("choice",),
    "composable_node": ("extra_arg", "param", "remap"),
    "executable": ("env",),
    "include": ("arg", "let"),
    "lifecycle_node": ("env", "param", "remap"),
    "load_composable_node": ("composable_node",),
    "node": ("env", "param", "remap", "composable_node"),
    "node_container": ("composable_node", "env", "param", "remap"),
    "param": ("param",),
    "rep_env": ("env",),
    "reset": ("keep",),
}
WITH_ACTIONS = ("for", "for_each", "group", "timer", "ros_timer")


def check(action: Action) -> None:
    """Raise a ValueError about an attribute or a part that the action does not have."""
    if action.kind in OF_PYTHON:
        raise ValueError(f"only launch files in Python contain '{action.kind}'")
    if action.kind in KNOWN:
        _check(action, (*KNOWN[action.kind], *CONDITIONS))


def _check(action: Action, known: tuple[str, ...]) -> None:
    for name in action.attributes:
        # In XML, any attribute may be a list with a separator.
        if name not in known and name.removesuffix("_sep") not in known:
            raise ValueError(f"'{action.kind}' has no attribute '{name}'; {nearest(name, known)}")
    if action.kind in WITH_ACTIONS:
        return
    parts = OF.get(action.kind, ())
    for part in action.inside:
        if part.kind not in parts:
            advice = nearest(part.kind, parts) if parts else "remove it"
            raise ValueError(f"'{action.kind}' has no '{part.kind}' inside; {advice}")
        _check(part, PARTS[part.kind])
