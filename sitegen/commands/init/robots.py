"""Find the robots of a workspace that no launch file shows, by their descriptions."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from xml.etree import ElementTree

import yaml

from sitegen.commands.init.members import Member, member
from sitegen.commands.wiring.endpoint import PUBLISHER
from sitegen.errors import Location, relative
from sitegen.launch import published_description
from sitegen.model import Node, Package

# Where packages have descriptions: at their root, and in the folders that are usual.
FOLDERS = ("", "description/**/", "robots/**/", "urdf/**/", "xacro/**/")
PATTERNS = tuple(f"{folder}*.{kind}" for folder in FOLDERS for kind in ("urdf", "xacro"))
ADVICE = "a launch file can give it what it needs"
STATE_PUBLISHER = "robot_state_publisher"
JOINTS = "/joint_states"
# A page for each of many files would hide the other pages; comments list them all.
MOST = 6
_INCLUDED = re.compile(r"<xacro:include\b[^>]*\bfilename\s*=\s*[\"']([^\"']+)")
# Of a joint that follows another one, and of one of six degrees of freedom, a slider moves nothing.
_MOVING = ("continuous", "prismatic", "revolute")


@dataclass(frozen=True)
class Robot:
    """A robot: its name, the file that describes it, and whether it has joints that move.

    `member` is the node that publishes its links.
    """

    package: Package
    file: Path
    name: str
    moves: bool
    member: Member


def name_of(node: Node) -> str:
    """Return the name of the robot that a node is given the description of, "" if there is none."""
    text = node.parameters.get("robot_description", "")
    try:
        found = ElementTree.fromstring(str(yaml.safe_load(text)).strip()) if text else None
    except (ElementTree.ParseError, yaml.YAMLError):
        return ""
    return "" if found is None else found.get("name", "")


def robots(
    root: Path,
    own: Mapping[str, Package],
    there: Mapping[str, Package],
    started: Collection[str],
) -> tuple[list[Robot], list[str]]:
    """Return the robots of the packages `own`, and why others cannot be shown.

    Robots with a name in `started` are left out: a launch file starts them. `there` are all
    packages that descriptions may use.
    """
    found: list[Robot] = []
    faults: list[str] = []
    for package in own.values():
        # The same robot as URDF and as xacro has one page.
        new: dict[str, Robot] = {}
        for file in _files(package):
            try:
                robot = _robot(package, file, root, there)
            except ValueError as error:
                faults.append(f"{relative(file, root)}: {error}; {ADVICE}")
                continue
            if robot and robot.name not in started:
                new.setdefault(robot.name, robot)
        found += list(new.values())[:MOST]
    return found, faults


def moving(
    robot: Robot, programs: Iterable[Member], packages: Mapping[str, Package]
) -> list[Member]:
    """Return the programs that publish the joints of a robot.

    They are in its package, or in packages that depend on it.
    """
    own = robot.package.name
    return [
        program
        for program in programs
        if robot.moves
        and (program.package == own or own in packages[program.package].depends)
        and any(each.name == JOINTS for each in program.endpoints(PUBLISHER))
    ]


def _files(package: Package) -> Iterator[Path]:
    """Yield the descriptions of a package that no other one includes, URDF before xacro."""
    files = {file for pattern in PATTERNS for file in package.path.glob(pattern)}
    texts = {file: text for file in files if (text := _text(file))}
    included = {Path(name).name for text in texts.values() for name in _INCLUDED.findall(text)}
    for file in sorted(texts, key=lambda each: (each.suffix, each)):
        if file.name not in included:
            yield file


def _text(file: Path) -> str:
    """Return the text of a description, "" for other files."""
    try:
        text = file.read_text(encoding="utf-8-sig")
        return text if ElementTree.fromstring(text.strip()).tag == "robot" else ""
    except (OSError, UnicodeDecodeError, ElementTree.ParseError):
        return ""


def _robot(package: Package, file: Path, root: Path, there: Mapping[str, Package]) -> Robot | None:
    """Return the robot that a file describes; None if it has only parts of one.

    Raises: ValueError if the description cannot be read, such as xacro that needs arguments.
    """
    try:
        described = ElementTree.fromstring(published_description(file, there).strip())
    except ElementTree.ParseError as error:
        raise ValueError(f"not well-formed XML ({error})") from None
    links = {link.get("name", "") for link in described.findall("link")}
    joints = described.findall("joint")
    if not _is_whole(links, joints):
        return None
    moves = any(joint.get("type") in _MOVING and joint.find("mimic") is None for joint in joints)
    name = described.get("name") or file.name.partition(".")[0]
    node = Node(STATE_PUBLISHER, STATE_PUBLISHER, STATE_PUBLISHER, Location(file, 1))
    publisher = replace(member(node, there, {}), urdf=relative(file, root))
    return Robot(package, file, name, moves, publisher)


def _is_whole(links: Collection[str], joints: Sequence[ElementTree.Element]) -> bool:
    """Return whether joints connect all links to a tree, as robot_state_publisher demands."""
    ends = [(_link(joint, "parent"), _link(joint, "child")) for joint in joints]
    children = [child for _, child in ends]
    known = all(end in links for pair in ends for end in pair)
    return known and len(set(children)) == len(children) == len(links) - 1


def _link(joint: ElementTree.Element, end: str) -> str:
    found = joint.find(end)
    return "" if found is None else found.get("link", "")
