"""The actions of a launch file that only set something for those after them."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace

from sitegen.launch.names import joined
from sitegen.launch.scope import Scope
from sitegen.launch.substitutions import LOG_FOLDER, SubstitutionError
from sitegen.launch.texts import Texts
from sitegen.launch.tree import Action
from sitegen.model import Argument

BOOLEANS = ("true", "false", "True", "False", "TRUE", "FALSE")


def argument(action: Action, scope: Scope, texts: Texts) -> None:
    """Declare an argument: the first default counts."""
    name = texts.needed(action, "name", scope)
    default = _told(action, "default", scope, texts)
    description = _told(action, "description", scope, texts) or ""
    choices = tuple(texts.needed(each, "value", scope) for each in action.of_kind("choice"))
    texts.declared.setdefault(name, Argument(name, default, description, choices))
    if name not in scope.variables:
        if "default" not in action.attributes:
            raise ValueError(f"'{name}' has no value; give one in 'launch_arguments' of the page")
        scope.variables[name] = texts.text(action, "default", scope)
    allowed = BOOLEANS if action.kind == "bool_arg" else choices
    if allowed and scope.variables[name] not in allowed:
        value, listed = scope.variables[name], ", ".join(allowed)
        raise ValueError(f"'{name}' is '{value}', but must be one of: {listed}")


def _told(action: Action, name: str, scope: Scope, texts: Texts) -> str | None:
    """Return an attribute that is only shown: as it is written, if it has no value here."""
    if name not in action.attributes:
        return None
    try:
        return texts.text(action, name, scope)
    except (ValueError, SubstitutionError):
        return str(action.attributes[name])


def let(action: Action, scope: Scope, texts: Texts) -> None:
    """Set an argument."""
    name = texts.needed(action, "name", scope)
    scope.variables[name] = texts.needed(action, "value", scope)


def _unset(action: Action, scope: Scope, texts: Texts) -> None:
    scope.variables.pop(texts.needed(action, "name", scope), None)


def _reset(action: Action, scope: Scope, texts: Texts) -> None:
    # The namespace and the rules are arguments, too.
    scope.restore(Scope(scope.file, texts.pairs(action, "keep", scope)))


def _push_configurations(_: Action, scope: Scope, __: Texts) -> None:
    scope.configurations.append(replace(scope, variables=dict(scope.variables)))


def _pop_configurations(_: Action, scope: Scope, __: Texts) -> None:
    if not scope.configurations:
        raise ValueError("nothing was pushed before")
    scope.restore(scope.configurations.pop())


def _push(action: Action, scope: Scope, texts: Texts) -> None:
    scope.namespace = joined(scope.namespace, texts.needed(action, "namespace", scope))


def _set_parameter(action: Action, scope: Scope, texts: Texts) -> None:
    is_clock = action.kind == "set_use_sim_time"
    name = "use_sim_time" if is_clock else texts.needed(action, "name", scope)
    scope.parameters.append((name, texts.parameters(scope).value(action)))


def _set_parameters_from_file(action: Action, scope: Scope, texts: Texts) -> None:
    scope.parameters.append(texts.file(texts.needed(action, "filename", scope)))


def _set_remap(action: Action, scope: Scope, texts: Texts) -> None:
    # Of two rules for one name, the first counts.
    old, new = texts.needed(action, "from", scope), texts.needed(action, "to", scope)
    scope.remaps.setdefault(old, new)


def _set_env(action: Action, scope: Scope, texts: Texts) -> None:
    name = texts.needed(action, "name", scope)
    scope.environment.changes[name] = texts.needed(action, "value", scope)


def _append_env(action: Action, scope: Scope, texts: Texts) -> None:
    name, value = (texts.needed(action, key, scope) for key in ("name", "value"))
    separator = texts.text(action, "separator", scope) if "separator" in action.attributes else ":"
    is_first = texts.is_true(action, "prepend", scope)
    scope.environment.append(name, value, separator, prepend=is_first)


def _unset_env(action: Action, scope: Scope, texts: Texts) -> None:
    scope.environment.changes[texts.needed(action, "name", scope)] = None


def _reset_env(_: Action, scope: Scope, __: Texts) -> None:
    scope.environment = scope.environment.fresh()


def _replace_env(action: Action, scope: Scope, texts: Texts) -> None:
    scope.environment.changes = {**texts.pairs(action, "env", scope)}


def _push_env(_: Action, scope: Scope, __: Texts) -> None:
    scope.environments.append(scope.environment.copy())


def _pop_env(_: Action, scope: Scope, __: Texts) -> None:
    if not scope.environments:
        raise ValueError("nothing was pushed before")
    scope.environment.changes = scope.environments.pop().changes


def _set_logs(action: Action, scope: Scope, texts: Texts) -> None:
    before = scope.environment.changes.get("ROS_LOG_DIR") or LOG_FOLDER
    given = texts.needed(action, "new_log_dir", scope)
    scope.environment.changes["ROS_LOG_DIR"] = os.path.join(before, given)  # noqa: PTH118


SETTINGS: dict[str, Callable[[Action, Scope, Texts], None]] = {
    "append_env": _append_env,
    "arg": argument,
    "bool_arg": argument,
    "let": let,
    "pop_env": _pop_env,
    "pop_launch_configurations": _pop_configurations,
    "push_env": _push_env,
    "push_launch_configurations": _push_configurations,
    "push_namespace": _push,
    "push_ros_namespace": _push,
    "rep_env": _replace_env,
    "reset": _reset,
    "reset_env": _reset_env,
    "set_env": _set_env,
    "set_parameter": _set_parameter,
    "set_parameters_from_file": _set_parameters_from_file,
    "set_remap": _set_remap,
    "set_ros_log_dir": _set_logs,
    "set_use_sim_time": _set_parameter,
    "unset_env": _unset_env,
    "unset_launch_configuration": _unset,
}
