"""Run a launch file in Python with a `launch` that only notes what is described.

A program of its own: it reads the folders of packages from the standard input, as JSON, and writes
what the file given as argument describes, or why that cannot be had, to the standard output.
"""

from __future__ import annotations

import json
import runpy
import shlex
import sys
import traceback
import types
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from sitegen.launch import describe_events, describe_expressions

FILE = ""
FOLDERS: dict[str, str] = {}


class Text:
    """A substitution, by what launch files in XML have for it."""

    def __init__(self, text: str) -> None:
        self.text = text

    def __truediv__(self, part: Any) -> Text:
        return Text(f"{self.text}/{text(part)}")


class Folder(Text):
    """The folder of a package; some files ask for it while they are run."""

    def find(self, package: str) -> str:
        """Return the folder of a package of the workspace."""
        return share(package)


class Typed(Text):
    """The value of a parameter that is a text, whatever it looks like."""


class Described:
    """An action as sitegen/launch/tree.py has it."""

    def __init__(self, kind: str, inside: Iterable[Any] = (), **attributes: Any) -> None:
        self.kind = kind
        self.inside = list(inside)
        condition = attributes.pop("condition", None)
        given = {name: value for name, value in attributes.items() if value is not None}
        self.attributes = {name: text(value) for name, value in given.items()}
        if isinstance(condition, Condition):
            self.attributes[condition.name] = text(condition.value)
        elif condition is not None:
            self.kind = f"condition {type(condition).__name__}"
        frames = traceback.extract_stack()
        self.line = next((f.lineno for f in reversed(frames) if f.filename == FILE), 1)

    def add_action(self, action: Any) -> None:
        """Describe one more."""
        self.inside.append(action)

    add_entity = add_action

    def plain(self) -> dict[str, Any]:
        """Return it as JSON has it."""
        inside = [
            each.plain() if isinstance(each, Described) else unknown(each) for each in self.inside
        ]
        return {
            "kind": self.kind,
            "attributes": self.attributes,
            "line": self.line,
            "inside": inside,
        }


class Condition:
    """What has to be true, or false, of a text."""

    def __init__(self, name: str, value: Any) -> None:
        self.name, self.value = name, value


def unknown(action: Any) -> Described:
    """Return what does not work, under its name."""
    return Described(type(action).__name__)


def text(value: Any) -> str:
    """Return a text of launch files: from one, a substitution, or a list of both."""
    if isinstance(value, Text):
        return value.text
    if isinstance(value, (list, tuple)):
        return "".join(text(part) for part in value)
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (str, int, float, Path)):
        return str(value)
    raise TypeError(f"{type(value).__name__} does not work on a page")


def written(value: Any) -> str:
    """Return the value of a parameter as YAML has it."""
    if isinstance(value, str):
        return "'" + value.replace("'", "''") + "'"
    if isinstance(value, (list, tuple)) and not any(isinstance(part, Text) for part in value):
        return f"[{', '.join(written(part) for part in value)}]"
    return text(value)


def share(package: str, *_: Any) -> str:
    """Return the folder of a package of the workspace."""
    if package not in FOLDERS:
        raise LookupError(f"no package '{package}' in the workspace")
    return FOLDERS[package]


def parameters(given: Iterable[Any]) -> list[Described]:
    """Return the parameters of a node: values by name, or files."""
    found: list[Described] = []
    for each in given:
        if isinstance(each, Mapping):
            found += values("", each)
        elif isinstance(each, Described):
            found.append(each)
        else:
            found.append(Described("param", **{"from": each}))
    return found


def values(above: str, given: Mapping[Any, Any]) -> Iterable[Described]:
    """Yield a parameter for each value, those of a nested mapping with dots."""
    for name, value in given.items():
        if isinstance(value, Mapping):
            yield from values(f"{above}{text(name)}.", value)
        elif isinstance(value, Typed):
            yield Described("param", name=f"{above}{text(name)}", value=value, type="str")
        else:
            yield Described("param", name=f"{above}{text(name)}", value=written(value))


def node(
    *_: Any,
    package: Any = None,
    executable: Any = None,
    node_executable: Any = None,
    name: Any = None,
    node_name: Any = None,
    namespace: Any = None,
    node_namespace: Any = None,
    parameters: Iterable[Any] | None = None,
    remappings: Iterable[tuple[Any, Any]] | None = None,
    arguments: Iterable[Any] | None = None,
    ros_arguments: Iterable[Any] | None = None,
    condition: Any = None,
    **_others: Any,
) -> Described:
    """Describe a node; what says how its process is watched and shown is left out."""
    inside = _parameters(parameters or ())
    for old, new in remappings or ():
        inside.append(Described("remap", **{"from": old, "to": new}))
    words = {"args": arguments, "ros_args": ros_arguments}
    lines = {
        key: " ".join(shlex.quote(text(w)) for w in given) for key, given in words.items() if given
    }
    return Described(
        "node",
        inside,
        pkg=package,
        exec=executable if executable is not None else node_executable,
        name=name if name is not None else node_name,
        namespace=namespace if namespace is not None else node_namespace,
        condition=condition,
        **lines,
    )


_parameters = parameters


def composable(
    *,
    package: Any,
    plugin: Any,
    name: Any = None,
    namespace: Any = None,
    parameters: Iterable[Any] | None = None,
    remappings: Iterable[tuple[Any, Any]] | None = None,
    condition: Any = None,
    **_: Any,
) -> Described:
    """Describe a component."""
    inside = _parameters(parameters or ())
    inside += (Described("remap", **{"from": old, "to": new}) for old, new in remappings or ())
    return Described(
        "composable_node",
        inside,
        pkg=package,
        plugin=plugin,
        name=name,
        namespace=namespace,
        condition=condition,
    )


def container(*, composable_node_descriptions: Iterable[Any] | None = None, **of: Any) -> Described:
    """Describe a component container, a node with components."""
    described = node(**of)
    described.kind = "node_container"
    described.inside += composable_node_descriptions or ()
    return described


def load(
    *, composable_node_descriptions: Iterable[Any], target_container: Any, condition: Any = None
) -> Described:
    """Describe components of a container that is described elsewhere, by its name or itself."""
    if isinstance(target_container, Described):
        named = target_container.attributes
        parts = (named.get("namespace", ""), named.get("name", ""))
        target_container = "/".join(part.rstrip("/") for part in parts if part)
    return Described(
        "load_composable_node",
        composable_node_descriptions,
        target=target_container,
        condition=condition,
    )


def include(
    source: Any, *, launch_arguments: Any = (), condition: Any = None, **_: Any
) -> Described:
    """Describe an include; its arguments are pairs, or by name."""
    pairs = launch_arguments.items() if isinstance(launch_arguments, Mapping) else launch_arguments
    inside = [Described("arg", name=name, value=value) for name, value in pairs or ()]
    return Described("include", inside, file=source, condition=condition)


def describe(entities: Iterable[Any] | None = None, *_: Any, **__: Any) -> Described:
    """Stand for LaunchDescription."""
    return Described("launch", entities or ())


def environment(name: Any, *, default_value: Any = None) -> Text:
    """Stand for EnvironmentVariable."""
    default = "" if default_value is None else f" '{text(default_value)}'"
    return Text(f"$(env {text(name)}{default})")


def configuration(name: Any, default: Any = None, **_: Any) -> Text:
    """Stand for LaunchConfiguration."""
    return Text(f"$(var {text(name)}{'' if default is None else f' {shlex.quote(text(default))}'})")


def command(words: Any, **_: Any) -> Text:
    """Stand for Command, which is one text or several that make one."""
    line = text(words)
    quote = '"' if "'" in line else "'"
    return Text(f"$(command {quote}{line}{quote})")


CORE: dict[str, Any] = {
    "LaunchDescription": describe,
    "DeclareLaunchArgument": lambda name, *, default_value=None, condition=None, **_: Described(
        "arg", name=name, default=default_value, condition=condition
    ),
    "SetLaunchConfiguration": lambda name, value, condition=None: Described(
        "let", name=name, value=value, condition=condition
    ),
    "GroupAction": lambda actions, *, scoped=True, condition=None, **_: Described(
        "group", actions, scoped=scoped, condition=condition
    ),
    "IncludeLaunchDescription": include,
    "LogInfo": lambda **_: Described("log"),
    "SetEnvironmentVariable": lambda *_, **__: Described("set_env"),
    "IfCondition": lambda value: Condition("if", value),
    "UnlessCondition": lambda value: Condition("unless", value),
    "LaunchConfiguration": configuration,
    "TextSubstitution": lambda *, text: Text(text),
    "PathSubstitution": lambda path: Text(text(path)),
    "PathJoinSubstitution": lambda parts: Text("/".join(text(part) for part in parts)),
    "EnvironmentVariable": environment,
    "ThisLaunchFileDir": lambda: Text("$(dirname)"),
    "ThisLaunchFile": lambda: Text("$(filename)"),
    "Command": command,
    "FileContent": lambda path: Text(f"$(file-content '{text(path)}')"),
    "FindExecutable": lambda name: Text(f"$(find-exec {text(name)})"),
    **{
        f"{kind}LaunchDescriptionSource": lambda file, **_: file
        for kind in ("Python", "XML", "YAML", "Any", "Frontend")
    },
    "AppendEnvironmentVariable": lambda *_, **__: Described("set_env"),
    "UnsetEnvironmentVariable": lambda *_, **__: Described("unset_env"),
    **describe_events.members(Described),
    **describe_expressions.members(Text, Condition),
}
ROS: dict[str, Any] = {
    "Node": node,
    "LifecycleNode": node,
    "PushRosNamespace": lambda namespace, condition=None: Described(
        "push_ros_namespace", namespace=namespace, condition=condition
    ),
    "SetParameter": lambda name, value, condition=None: Described(
        "set_parameter", name=name, value=written(value), condition=condition
    ),
    "SetRemap": lambda src, dst, condition=None: Described(
        "set_remap", condition=condition, **{"from": src, "to": dst}
    ),
    "FindPackageShare": lambda package: Folder(f"$(find-pkg-share {text(package)})"),
    "FindPackagePrefix": lambda package: Folder(f"$(find-pkg-prefix {text(package)})"),
    "FindPackage": lambda package: Folder(f"$(find-pkg-prefix {text(package)})"),
    "ParameterFile": lambda file, **_: Described("param", **{"from": file}),
    "ParameterValue": lambda value, *, value_type=None: (
        value if value_type is None else (Typed if value_type is str else Text)(text(value))
    ),
    "ComposableNode": composable,
    "ComposableNodeContainer": container,
    "LoadComposableNodes": load,
    "SetUseSimTime": lambda value, condition=None: Described(
        "set_parameter", name="use_sim_time", value=value, condition=condition
    ),
}
ROS["PushROSNamespace"] = ROS["PushRosNamespace"]
INDEX = {
    "get_package_share_directory": share,
    "get_package_share_path": lambda package: Path(share(package)),
    "get_package_prefix": share,
}
# Names are where upstream has them; that they are elsewhere, too, hurts nobody.
MODULES = {
    "launch": CORE,
    "launch_ros": CORE | ROS,
    "lifecycle_msgs": describe_events.LIFECYCLE,
    "launch_xml": CORE,
    "launch_yaml": CORE,
    "ament_index_python": INDEX,
}
BELOW = {
    "launch": (
        *("actions", "conditions", "substitutions", "launch_description_sources", "event_handlers"),
        *("events", "events.lifecycle", "events.process", "launch_description"),
    ),
    "launch_ros": (
        *("actions", "descriptions", "parameter_descriptions", "substitutions"),
        *("events", "events.lifecycle", "event_handlers"),
    ),
    "lifecycle_msgs": ("msg",),
    "launch_xml": ("launch_description_sources",),
    "launch_yaml": ("launch_description_sources",),
    "ament_index_python": ("packages",),
}


def install() -> None:
    """Let launch files import what they import from ROS."""
    for name, members in MODULES.items():
        top = types.ModuleType(name)
        vars(top).update(members, __path__=[])
        sys.modules[name] = top
        for part in BELOW[name]:
            module = types.ModuleType(f"{name}.{part}")
            vars(module).update(members, __path__=[])
            above, _, own = module.__name__.rpartition(".")
            setattr(sys.modules[above], own, module)
            sys.modules[module.__name__] = module


def main() -> None:
    """Write what the launch file describes."""
    global FILE
    FILE = sys.argv[1]
    FOLDERS.update(json.load(sys.stdin))
    install()
    if "xacro" in Path(FILE).read_text(encoding="utf-8", errors="replace"):
        import xacro

        from sitegen.launch.describe_robot import described

        xacro.process_file = described
    output, sys.stdout = sys.stdout, sys.stderr
    try:
        found = runpy.run_path(FILE)["generate_launch_description"]()
        answer = found.plain()
    except BaseException as error:
        frames = traceback.extract_tb(error.__traceback__)
        lines = [frame.lineno for frame in frames if frame.filename == FILE]
        line = getattr(error, "lineno", None) or (lines[-1] if lines else 1)
        answer = {"error": f"{type(error).__name__}: {error}", "line": line}
    json.dump(answer, output)


if __name__ == "__main__":
    main()
