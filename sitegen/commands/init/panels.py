"""Choose the panels of a page by what its programs offer."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from sitegen.commands.init.fields import numbers
from sitegen.commands.init.members import Member
from sitegen.commands.init.partners import COMMANDS, waiting
from sitegen.commands.init.robots import JOINTS, Robot
from sitegen.commands.init.turtle import KEY, TURTLE, TURTLESIM
from sitegen.commands.wiring.endpoint import (
    ACTION,
    LIFECYCLE,
    OPPOSITE,
    PARAMETERS,
    PUBLISHER,
    SERVICE,
    SUBSCRIPTION,
    TRANSFORMS,
)
from sitegen.config.displays import kinds
from sitegen.model import Package

# A widget of site.yaml: its kind, and its options or its only option.
Item = tuple[str, object]

_TWIST, _STAMPED = COMMANDS
_IMAGE, _COMPRESSED = "sensor_msgs/msg/Image", "sensor_msgs/msg/CompressedImage"
# For these, a visitor has more than a form.
_DRIVEN = (_TWIST, _STAMPED, _IMAGE, _COMPRESSED)
# What managed nodes publish by themselves.
_TRANSITION = "lifecycle_msgs/msg/TransitionEvent"
_DIAGNOSTICS = "diagnostic_msgs/msg/DiagnosticArray"
# A 3D view shows these, too, but other panels show more of them.
_ELSEWHERE = {_IMAGE, _COMPRESSED, "std_msgs/msg/String"}
_DESCRIPTION = "/robot_description"
# At most so many images, curves of a plot, and services or actions by name.
IMAGES, CURVES, NAMES = 2, 6, 5


def views(page: Sequence[Member]) -> Iterator[Item]:
    """Yield what shows and drives the robot, for the top of a page."""
    published = _topics(page, PUBLISHER)
    if _has_turtles(page):
        yield "robot", {"kind": TURTLESIM}
    placed = {type for kind in kinds().values() for type in kind.types} - _ELSEWHERE
    described = _DESCRIPTION in published
    if described or placed & set(published.values()) or _uses(page, TRANSFORMS):
        yield "3d", None
    for topic, type in _waiting(page, PUBLISHER).items():
        if type == _TWIST:
            yield "robot", {"kind": "diffdrive", "twist": topic}
    for topic, type in _waiting(page, SUBSCRIPTION).items():
        if topic == JOINTS and described:
            yield "joints", None
        if type in (_TWIST, _STAMPED):
            yield "teleop", {"topic": topic, **({"stamped": True} if type == _STAMPED else {})}
        if type in (_IMAGE, _COMPRESSED):
            yield "camera", {"topic": topic, **({"compressed": True} if type != _IMAGE else {})}


def panels(page: Sequence[Member], packages: Mapping[str, Package]) -> Iterator[Item]:
    """Yield what is exchanged and what can be asked, for the end of a page."""
    published = _topics(page, PUBLISHER)
    images = [topic for topic, type in published.items() if type in (_IMAGE, _COMPRESSED)]
    yield from (("image", topic) for topic in images[:IMAGES])
    curves = [
        f"{topic}.{field}" for topic, type in published.items() for field in numbers(type, packages)
    ]
    if curves:
        yield "plot", curves[:CURVES]
    for kind, widget in ((SERVICE, "services"), (ACTION, "actions")):
        names = list(_topics(page, kind))
        if names:
            yield widget, {"show": names} if len(names) <= NAMES else None
    if _uses(page, PARAMETERS):
        yield "parameters", None
    known = [{each.kind for each in member.endpoints(*OPPOSITE)} for member in page]
    if not all(kinds and not kinds & {PUBLISHER, SUBSCRIPTION} for kinds in known):
        yield "topics", _echo(page, published)
    unasked = {
        topic: type
        for topic, type in _waiting(page, SUBSCRIPTION).items()
        if type not in (*_DRIVEN, _TRANSITION) and topic != JOINTS
    }
    if len(unasked) == 1:
        [(topic, type)] = unasked.items()
        yield "publish", {"topic": topic, **({"type": type} if type else {})}
    elif unasked:
        yield "publish", None
    # Its topic is common to the tools of ROS, so it is not among `published`.
    told = (endpoint for member in page for endpoint in member.told.endpoints)
    if any((each.kind, each.type) == (PUBLISHER, _DIAGNOSTICS) for each in told):
        yield "diagnostics", None
    if _uses(page, LIFECYCLE):
        yield "lifecycle", None
    if len(page) > 1 and any(known):
        yield "graph", None


def robot_views(robot: Robot, movers: Sequence[Member]) -> list[Item]:
    """Return what shows a robot, with sliders for its joints if no program moves them."""
    sliders: list[Item] = [("joints", None)] if robot.moves and not movers else []
    return [("3d", None), *sliders, *(view for view in views(movers) if view[0] != "3d")]


def robot_panels(
    robot: Robot, movers: Sequence[Member], packages: Mapping[str, Package]
) -> list[Item]:
    """Return what tells of the joints and frames of a robot, and of the programs that move it."""
    joints: list[Item] = [("topics", {"echo": JOINTS})] if robot.moves else []
    others = (panel for panel in panels(movers, packages) if panel[0] != "topics")
    return [*joints, *others, ("tf", None)]


def _uses(page: Sequence[Member], use: str) -> bool:
    return any(use in member.told.uses for member in page)


def _echo(page: Sequence[Member], published: Mapping[str, str]) -> dict[str, str] | None:
    """Return the topic whose messages are shown first."""
    if _has_turtles(page):
        return {"echo": f"{TURTLE}1/pose"}
    echo = next(iter(published), "")
    return {"echo": echo} if echo else None


def _waiting(page: Sequence[Member], kind: str) -> dict[str, str]:
    """Return the topics with endpoints of a kind and none of the other, with their types."""
    found = {each.name: each.type for each in waiting(page, kind)}
    if not _has_turtles(page):
        return found
    return {name: type for name, type in found.items() if not name.startswith(TURTLE)}


def _has_turtles(page: Sequence[Member]) -> bool:
    return any(member.key == KEY for member in page)


def _topics(page: Sequence[Member], kind: str) -> dict[str, str]:
    """Return the names of the endpoints of a kind, with their types."""
    members = (member for member in page if member.key != KEY)
    return {each.name: each.type for member in members for each in member.endpoints(kind)}
