"""Run a Python launch file with a `launch` package that only records what the file describes.

This runs as a separate program. It reads the folders of packages and the functions to call from the
standard input as JSON, and writes the description of the file given as argument, or the error, to
the standard output.
"""

from __future__ import annotations

import json
import os
import runpy
import sys
import tempfile
import traceback
import types
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from sitegen.launch import (
    describe_components,
    describe_events,
    describe_expressions,
    describe_functions,
    describe_missing,
    describe_settings,
)
from sitegen.launch.describe_actions import (
    RUN,
    Condition,
    Context,
    Described,
    Folder,
    PackageNotFoundError,
    Text,
    Valued,
    describe,
    managed,
    node,
    parameter,
    share,
    text,
)
from sitegen.launch.describe_scopes import (
    argument,
    boolean,
    command,
    configuration,
    environment,
    group,
    include,
    setting,
)
from sitegen.launch.substitutions import SubstitutionError

GENERATE = "generate_launch_description"

CORE: dict[str, Any] = {
    "LaunchDescription": describe,
    "DeclareBooleanLaunchArgument": boolean,
    "DeclareLaunchArgument": argument,
    "GroupAction": group,
    "IncludeLaunchDescription": include,
    "IfCondition": lambda predicate_expression: Condition("if", predicate_expression),
    "UnlessCondition": lambda predicate_expression: Condition("unless", predicate_expression),
    "LaunchConfiguration": configuration,
    "TextSubstitution": lambda *, text: Text(text),
    "PathSubstitution": lambda path: Text(text(path)),
    "LaunchLogDir": lambda: Text("$(log_dir)"),
    "EnvironmentVariable": environment,
    "ThisLaunchFileDir": lambda: Text("$(dirname)"),
    "ThisLaunchFile": lambda: Text("$(filename)"),
    "Command": command,
    "FileContent": lambda path: Text(f"$(file-content '{text(path)}')"),
    "FindExecutable": lambda name: Text(f"$(find-exec {text(name)})"),
    **{
        f"{kind}LaunchDescriptionSource": lambda launch_file_path, **_: launch_file_path
        for kind in ("Python", "XML", "YAML", "Any", "Frontend")
    },
    "SubstitutionFailure": SubstitutionError,
    **describe_events.MEMBERS,
    **describe_expressions.MEMBERS,
    **describe_functions.MEMBERS,
    **describe_settings.MEMBERS,
}
ROS: dict[str, Any] = {
    "Node": node,
    "LifecycleNode": managed,
    "FindPackageShare": lambda package: Folder(f"$(find-pkg-share {text(package)})"),
    "FindPackagePrefix": lambda package: Folder(f"$(find-pkg-prefix {text(package)})"),
    "FindPackage": lambda package: Folder(f"$(find-pkg-prefix {text(package)})"),
    "ExecutableInPackage": lambda executable, package, **_: Text(
        f"$(exec-in-pkg {text(executable)} {text(package)})"
    ),
    "Parameter": parameter,
    "ParameterFile": lambda param_file, *, allow_substs=False: Described(
        "param", allow_substs=allow_substs, **{"from": param_file}
    ),
    "ParameterValue": Valued,
    **describe_components.ROS,
    **describe_settings.ROS,
}
INDEX = {
    "PackageNotFoundError": PackageNotFoundError,
    "get_package_share_directory": share,
    "get_package_share_path": lambda package: Path(share(package)),
    "get_package_prefix": share,
    "get_packages_with_prefixes": lambda: {name: str(path) for name, path in RUN.folders.items()},
}
# Of two things with this name, the one that is a substitution.
SUBSTITUTIONS = {"Parameter": setting}
# Every name is available in each of these modules, which is more than upstream has and does no
# harm.
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
        *("launch_context", "utilities"),
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
    """Make the modules of ROS that launch files import available."""
    for name, members in MODULES.items():
        for known, member in members.items():
            if isinstance(member, types.FunctionType):
                # Errors about its arguments name it as the launch file does.
                member.__qualname__ = known
        top = types.ModuleType(name)
        vars(top).update(members, __path__=[])
        sys.modules[name] = top
        for part in BELOW[name]:
            module = types.ModuleType(f"{name}.{part}")
            others = SUBSTITUTIONS if part == "substitutions" else {}
            vars(module).update({**members, **others}, __path__=[])
            above, _, own = module.__name__.rpartition(".")
            setattr(sys.modules[above], own, module)
            sys.modules[module.__name__] = module
    describe_missing.install([name for name in sys.modules if name.partition(".")[0] in MODULES])


def _told(error: BaseException, frames: Sequence[traceback.FrameSummary]) -> str:
    """Return what an error says to the author of the launch file."""
    asked = frames and frames[-1].filename in (os.__file__, "<frozen os>")
    if asked and isinstance(error, KeyError):
        return f"environment variable {error} is not set; set it in 'environment' of the page"
    return f"{type(error).__name__}: {error}"


def _lacking(error: BaseException) -> Mapping[str, str]:
    """Return the package and the module that an error is about, "" for others."""
    return {
        "absent": error.package if isinstance(error, PackageNotFoundError) else "",
        "module": (error.name or "") if isinstance(error, ModuleNotFoundError) else "",
    }


def _answer(calls: Sequence[Sequence[Any]], performed: Sequence[Any] | None) -> Mapping[str, Any]:
    """Return what the launch file, or the last of `calls`, describes, or a substitution's value."""
    members = runpy.run_path(RUN.file)
    if GENERATE not in members:
        raise LookupError(f"no function {GENERATE}() found")
    found = members[GENERATE]()
    for call in calls:
        reading, *of = call
        RUN.reading, RUN.made = reading, 0
        found = describe_functions.called(*of)
    if performed is None:
        described: Mapping[str, Any] = found.plain()
        return described
    number, variables, environment = performed
    try:
        return {"text": Context(variables, environment).performed(number)}
    except SubstitutionError as error:
        return {"substitution": str(error)}


def main() -> None:
    """Write what the launch file describes, or the value of one of its own substitutions."""
    RUN.file = sys.argv[1]
    given = json.load(sys.stdin)
    RUN.folders, RUN.roots = given["folders"], given["roots"]
    RUN.absent, RUN.reading = given["absent"], given["reading"]
    for name, value in given["environment"].items():
        if value is None:
            os.environ.pop(name, None)
        else:
            os.environ[name] = value
    # Launch files import modules of packages of the workspace.
    sys.path += given["roots"]
    install()
    if "xacro" in Path(RUN.file).read_text(encoding="utf-8-sig", errors="replace"):
        import xacro

        from sitegen.launch.describe_robot import described

        xacro.process_file = described
    output, sys.stdout = sys.stdout, sys.stderr
    # In a page, this runs in the interpreter of what asks for it.
    outer, tempfile.tempdir = tempfile.tempdir, given["made"]
    try:
        answer = _answer(given["calls"], given["performed"])
    except BaseException as error:
        frames = traceback.extract_tb(error.__traceback__)
        lines = [frame.lineno for frame in frames if frame.filename == RUN.file]
        line = getattr(error, "lineno", None) or (lines[-1] if lines else RUN.line)
        answer = {"error": _told(error, frames), "line": line, **_lacking(error)}
    finally:
        tempfile.tempdir = outer
    json.dump(answer, output)


if __name__ == "__main__":
    main()
