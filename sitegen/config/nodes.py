"""Read the nodes of site.yaml and find them in the workspace."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from typing import NamedTuple

from sitegen.config import parameters, prebuilt, ros2wasm
from sitegen.config.document import Value
from sitegen.config.files import locate
from sitegen.config.nodekeys import COMPILED, NODE, ROS2WASM
from sitegen.config.schema import Key
from sitegen.config.section import Section, check
from sitegen.errors import Location, Problems, nearest
from sitegen.launch import published_description
from sitegen.model import Container, Cpp, Fault, Node, Package, Python
from sitegen.rclyaml import written
from sitegen.workspace import containers

BUILD_TYPES = ("ament_cmake", "ament_python")
TOKEN = r"[A-Za-z_][A-Za-z0-9_]*"
NAME = re.compile(TOKEN)
NAMESPACE = re.compile(rf"/|(/{TOKEN})+")
GROUP = re.compile(r"[A-Za-z0-9_-]+")
REMAP = re.compile(
    rf"({TOKEN}:)?(rostopic://|rosservice://)?(~/|/)?[\w{{}}]+(/[\w{{}}]+)*", re.ASCII
)


class Declared(NamedTuple):
    """A node and the section that declares it; None for a node of a launch file."""

    node: Node
    section: Section | None

    def where(self, name: str) -> tuple[Location, str]:
        """Return the location of `name`, and its label in messages."""
        if self.section is None:
            return self.node.location, "node"
        return self.section.location(name), self.section.label(name)


def declare(value: Value, taken: Mapping[str, Declared], problems: Problems) -> dict[str, Declared]:
    """Return the nodes by name, and report names that are invalid in ROS or already `taken`."""
    declared: dict[str, Declared] = {}
    for name, entry in value.entries(problems).items():
        if not NAME.fullmatch(name):
            message = (
                f"'{name}' is not a valid node name; "
                "use letters, digits and '_', not starting with a digit"
            )
            problems.add(entry.location, entry.key, message)
        if name in taken:
            where = problems.where(taken[name].node.location)
            message = f"'{name}' is already defined ({where}); use that node or choose another name"
            problems.add(entry.location, entry.key, message)
        section = check(entry, _keys(entry), problems)
        if section.keys is ROS2WASM:
            script = ros2wasm.read(section, problems)
            node = Node(name, "", "", entry.location, kind=script or Cpp())
        else:
            _check_names(section, problems)
            node = _node(name, section, problems)
        if section.keys is COMPILED:
            archive = prebuilt.read(section, problems)
            node = replace(node, package="", executable="", kind=archive or Cpp())
        declared[name] = Declared(node, section)
    known = {**taken, **declared}
    return {name: _with_needs(each, known, problems) for name, each in declared.items()}


def present(given: Value | None, nodes: Mapping[str, Node], problems: Problems) -> tuple[str, ...]:
    """Return the names in a list, noting those that are not of `nodes`, which a page has."""
    names = given.items() if given else []
    for name in names:
        if name.text not in nodes:
            message = f"no node '{name.text}' on this page; {nearest(name.text, nodes)}"
            problems.add(name.location, name.key, message)
    return tuple(name.text for name in names)


def _with_needs(declared: Declared, known: Mapping[str, Declared], problems: Problems) -> Declared:
    """Return the node with the nodes that it needs, noting those that are not `known`."""
    node, section = declared
    given = section.get("needs") if section else None
    needs = given.items() if given else ()
    for need in needs:
        if need.text == node.name:
            message = f"'{node.name}' cannot need itself; remove it"
            problems.add(need.location, need.key, message)
        elif need.text not in known:
            message = f"no node '{need.text}'; {nearest(need.text, known)}"
            problems.add(need.location, need.key, message)
    return Declared(replace(node, needs=tuple(need.text for need in needs)), section)


def _keys(entry: Value) -> tuple[Key, ...]:
    if entry.has("ros2wasm"):
        return ROS2WASM
    return COMPILED if entry.has("compiled") else NODE


def check_package(declared: Declared, packages: Mapping[str, Package], problems: Problems) -> None:
    """Report a node whose package, executable or types are not in the workspace."""
    node, section = declared
    if section and section.keys is ROS2WASM:
        ros2wasm.check_types(section, packages, problems)
    components = node.kind.components if isinstance(node.kind, Container) else ()
    for component in components:
        if component.package not in packages:
            advice = nearest(component.package, packages)
            message = f"no package '{component.package}' in the workspace; {advice}"
            problems.add(component.location, "composable_node", message)
    if not node.package or components:
        return
    package = packages.get(node.package)
    if package is None and node.package == containers.PACKAGE:
        advice = "add 'composable_node' there"
        message = (
            f"'{node.executable}' must list its components in the page's launch file; {advice}"
        )
        problems.add(*declared.where("package"), message)
    elif package is None:
        message = f"no package '{node.package}' in the workspace; {nearest(node.package, packages)}"
        problems.add(*declared.where("package"), message)
    elif package.build_type == "catkin":
        message = f"package '{package.name}' is for ROS 1 (catkin); use its version for ROS 2"
        problems.add(*declared.where("package"), message)
    elif package.build_type not in BUILD_TYPES:
        message = (
            f"package '{package.name}' is of build type '{package.build_type}'; "
            f"this release supports {' and '.join(BUILD_TYPES)}"
        )
        problems.add(*declared.where("package"), message)
    elif faults := _setup_faults(package, node.executable):
        for fault in faults:
            problems.add(fault.location, fault.key, fault.message)
    elif package.build_type == "ament_python" and not package.executables:
        message = f"package '{package.name}' has no entry points; declare them in its setup.py"
        advice = "entry_points={'console_scripts': ['talker = my_package.talker:main']}"
        problems.add(*declared.where("package"), f"{message}: {advice}")
    elif not _has_executable(package, node.executable):
        hint = nearest(node.executable, package.executables or ())
        message = f"package '{package.name}' has no executable '{node.executable}'; {hint}"
        problems.add(*declared.where("executable"), message)
    elif node.group and not (package.setup and node.executable in package.setup.scripts):
        message = (
            "only Python nodes can share an interpreter, and this is a C++ node; remove the key"
        )
        problems.add(*declared.where("group"), message)


def with_kind(node: Node, packages: Mapping[str, Package]) -> Node:
    """Return `node` with its kind: the workspace knows which executables are Python programs."""
    package = packages.get(node.package)
    setup = package.setup if package else None
    if isinstance(node.kind, Cpp) and setup and node.executable in setup.scripts:
        return replace(node, kind=Python(setup))
    return node


def with_description(node: Node, packages: Mapping[str, Package], problems: Problems) -> Node:
    """Return `node` with the robot description in its `urdf` file as a parameter."""
    if not node.urdf:
        return node
    try:
        text = published_description(node.urdf, packages)
    except ValueError as error:
        problems.add(node.location, "urdf", str(error))
        return node
    return replace(node, parameters={**node.parameters, "robot_description": written(text)})


def _setup_faults(package: Package, executable: str) -> tuple[Fault, ...]:
    """Return the faults in build files that matter to a program: it is Python, or not found."""
    setup = package.setup
    if setup is None or executable in setup.scripts:
        return setup.faults if setup else ()
    if package.executables is None:
        # CMake knows the C++ programs.
        hidden = executable.endswith(".py")
    else:
        hidden = executable not in package.executables
    return tuple(fault for fault in setup.faults if fault.hides) if hidden else ()


def _has_executable(package: Package, executable: str) -> bool:
    # A missing name was reported before; a name that only CMake knows is checked by CMake.
    return not executable or package.executables is None or executable in package.executables


def _node(name: str, section: Section, problems: Problems) -> Node:
    remap, arguments = section.get("remap"), section.get("arguments")
    given = section.get("parameters")
    urdf = section.get("urdf") if section.keys is NODE else None
    environment = section.get("environment")
    return Node(
        name=name,
        package=section.text("package"),
        executable=section.text("executable"),
        location=section.value.location,
        namespace=section.text("namespace"),
        remap=remap.texts(problems) if remap else {},
        parameters=parameters.read(given, problems) if given else {},
        arguments=parameters.arguments(arguments, problems) if arguments else (),
        environment=environment.texts(problems) if environment else {},
        group=section.text("group") if section.keys is NODE else "",
        urdf=locate(urdf, problems) if urdf else None,
    )


def _check_names(section: Section, problems: Problems) -> None:
    group = section.text("group") if section.keys is NODE else ""
    if group and not GROUP.fullmatch(group):
        message = f"'{group}' is not a valid group name; use letters, digits, '_' and '-'"
        problems.add(section.location("group"), section.label("group"), message)
    namespace = section.text("namespace")
    if namespace and not NAMESPACE.fullmatch(namespace):
        message = f"'{namespace}' is not a valid namespace; write it like '/demo' or '/demo/left'"
        problems.add(section.location("namespace"), section.label("namespace"), message)
    remap = section.get("remap")
    for old, new in remap.entries(problems).items() if remap else ():
        if old in ("__ns", "__node", "__name"):
            message = f"'{old}' cannot be remapped here; write 'namespace: /demo' next to 'remap'"
            problems.add(new.location, new.key, message)
            continue
        for name in (old, new.text):
            if not REMAP.fullmatch(name):
                message = (
                    f"'{name}' is not a valid ROS name; write it like 'chatter' or '/demo/chatter'"
                )
                problems.add(new.location, new.key, message)
