"""Choose the panels of a page by what its programs offer."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from sitegen.commands.init.fields import numbers
from sitegen.commands.init.members import Member
from sitegen.commands.init.partners import COMMANDS, waiting
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
# Messages that have a place in the world.
_PLACED = {
    *(f"visualization_msgs/msg/{name}" for name in ("Marker", "MarkerArray")),
    *("visualization_msgs/msg/InteractiveMarkerUpdate", "geometry_msgs/msg/PoseArray"),
    *("geometry_msgs/msg/PolygonStamped", "geometry_msgs/msg/PoseWithCovarianceStamped"),
    *(f"nav_msgs/msg/{name}" for name in ("OccupancyGrid", "Odometry", "Path")),
    *(f"sensor_msgs/msg/{name}" for name in ("LaserScan", "PointCloud2")),
}
_DESCRIPTION, _JOINTS = "/robot_description", "/joint_states"
# At most so many panels, curves and names of a kind.
PANELS, CURVES, NAMES = 2, 6, 5


def views(page: Sequence[Member]) -> Iterator[Item]:
    """Yield what shows and drives the robot, for the top of a page."""
    published = _topics(page, PUBLISHER)
    if _has_turtles(page):
        yield "robot", {"kind": TURTLESIM}
    placed = _PLACED & set(published.values()) or _DESCRIPTION in published
    if placed or _uses(page, TRANSFORMS):
        yield "3d", None
    for topic, type in _waiting(page, PUBLISHER).items():
        if type == _TWIST:
            yield "robot", {"kind": "diffdrive", "twist": topic}
    for topic, type in _waiting(page, SUBSCRIPTION).items():
        if topic == _JOINTS and _DESCRIPTION in published:
            yield "joints", None
        if type in (_TWIST, _STAMPED):
            yield "teleop", {"topic": topic, **({"stamped": True} if type == _STAMPED else {})}
        if type in (_IMAGE, _COMPRESSED):
            yield "camera", {"topic": topic, **({"compressed": True} if type != _IMAGE else {})}


def panels(page: Sequence[Member], packages: Mapping[str, Package]) -> Iterator[Item]:
    """Yield what is exchanged and what can be asked, for the end of a page."""
    published = _topics(page, PUBLISHER)
    images = [topic for topic, type in published.items() if type in (_IMAGE, _COMPRESSED)]
    yield from (("image", topic) for topic in images[:PANELS])
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
        if type not in (*_DRIVEN, _TRANSITION) and topic != _JOINTS
    }
    if len(unasked) == 1:
        [(topic, type)] = unasked.items()
        yield "publish", {"topic": topic, **({"type": type} if type else {})}
    elif unasked:
        yield "publish", None
    if any(type == _DIAGNOSTICS for type in _topics(page, PUBLISHER, common=True).values()):
        yield "diagnostics", None
    if _uses(page, LIFECYCLE):
        yield "lifecycle", None
    if len(page) > 1 and any(known):
        yield "graph", None


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
    own = {each.name: each.type for each in waiting(page, kind)}
    turtles = TURTLE if _has_turtles(page) else "none"
    return {name: type for name, type in own.items() if not name.startswith(turtles)}


def _has_turtles(page: Sequence[Member]) -> bool:
    return any(member.key == KEY for member in page)


def _topics(page: Sequence[Member], kind: str, *, common: bool = False) -> dict[str, str]:
    """Return the names of the endpoints of a kind, with their types."""
    found = (
        endpoint
        for member in page
        if member.key != KEY
        for endpoint in (member.told.endpoints if common else member.endpoints(kind))
        if endpoint.kind == kind and not endpoint.foreign
    )
    return {each.name: each.type for each in found}
