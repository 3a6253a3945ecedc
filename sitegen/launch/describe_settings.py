"""Actions of Python launch files that set something for those after them."""

from __future__ import annotations

from typing import Any

from sitegen.launch.describe_actions import Described, mapped, pairs, variables


def pair(kind: str) -> Any:
    """Return a stand-in for an action that has a name and a value."""
    return lambda name, value, *, condition=None: Described(
        kind, name=name, value=value, condition=condition
    )


def named(kind: str) -> Any:
    """Return a stand-in for an action that has a name."""
    return lambda name, *, condition=None: Described(kind, name=name, condition=condition)


def plain(kind: str) -> Any:
    """Return a stand-in for an action without arguments."""
    return lambda *, condition=None: Described(kind, condition=condition)


def append(
    name: Any, value: Any, prepend: Any = False, separator: Any = ":", *, condition: Any = None
) -> Described:
    """Stand in for AppendEnvironmentVariable."""
    own = {"name": name, "value": value, "prepend": prepend, "separator": separator}
    return Described("append_env", condition=condition, **own)


MEMBERS: dict[str, Any] = {
    "AppendEnvironmentVariable": append,
    "PopEnvironment": plain("pop_env"),
    "PopLaunchConfigurations": plain("pop_launch_configurations"),
    "PushEnvironment": plain("push_env"),
    "PushLaunchConfigurations": plain("push_launch_configurations"),
    "ReplaceEnvironmentVariables": lambda environment=None, *, condition=None: Described(
        "rep_env", variables(environment), condition=condition
    ),
    "ResetEnvironment": plain("reset_env"),
    "ResetLaunchConfigurations": lambda launch_configurations=None, *, condition=None: Described(
        "reset", pairs("keep", (launch_configurations or {}).items()), condition=condition
    ),
    "SetEnvironmentVariable": pair("set_env"),
    "SetLaunchConfiguration": pair("let"),
    "UnsetEnvironmentVariable": named("unset_env"),
    "UnsetLaunchConfiguration": named("unset_launch_configuration"),
}
ROS: dict[str, Any] = {
    "PushRosNamespace": lambda namespace, *, condition=None: Described(
        "push_ros_namespace", namespace=namespace, condition=condition
    ),
    "SetParameter": lambda name, value, *, condition=None: Described(
        "set_parameter", name=name, given=mapped(value), condition=condition
    ),
    "SetParametersFromFile": lambda filename, *, condition=None: Described(
        "set_parameters_from_file", filename=filename, condition=condition
    ),
    "SetROSLogDir": lambda new_log_dir, *, condition=None: Described(
        "set_ros_log_dir", new_log_dir=new_log_dir, condition=condition
    ),
    "SetRemap": lambda src, dst, *, condition=None: Described(
        "set_remap", condition=condition, **{"from": src, "to": dst}
    ),
    "SetUseSimTime": lambda value, *, condition=None: Described(
        "set_parameter", name="use_sim_time", given=mapped(value), condition=condition
    ),
}
ROS["PushROSNamespace"] = ROS["PushRosNamespace"]
