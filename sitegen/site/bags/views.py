"""Put panels beside a bag that has a page of its own, by the types of its topics."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from sitegen.config.content import Reader
from sitegen.config.displays import kinds
from sitegen.config.document import parse
from sitegen.errors import Problems
from sitegen.model import Cell, Layout, Markdown, Page, Part, Site, Widget
from sitegen.site.bags.played import KIND, file_of
from sitegen.site.bags.topics import Topic, topics

IMAGES = ("sensor_msgs/msg/Image", "sensor_msgs/msg/CompressedImage")
MOST_IMAGES = 4
# What 3D views show besides the types of their displays.
FRAMES = ("/tf", "/tf_static")
DESCRIPTION = "/robot_description"
# Many topics have these types, and few of them are about space.
PLAIN = ("std_msgs/msg/String", *IMAGES)
# Numbers of these messages that tell the most, by the path to them.
CURVES: Mapping[str, Sequence[str]] = {
    "geometry_msgs/msg/Pose": ("position.x", "position.y"),
    "geometry_msgs/msg/PoseStamped": ("pose.position.x", "pose.position.y"),
    "geometry_msgs/msg/Twist": ("linear.x", "angular.z"),
    "geometry_msgs/msg/TwistStamped": ("twist.linear.x", "twist.angular.z"),
    "nav_msgs/msg/Odometry": ("twist.twist.linear.x", "twist.twist.angular.z"),
    "sensor_msgs/msg/Imu": ("linear_acceleration.x", "angular_velocity.z"),
    "sensor_msgs/msg/JointState": ("position[:]{name}",),
}
# Their numbers say how something is stored, or how grave a text is.
DULL = ("sensor_msgs/msg/CameraInfo", "rcl_interfaces/msg/Log", "rcl_interfaces/msg/ParameterEvent")
NUMBER = re.compile(
    r"^(?:float(?:32|64)|u?int(?:8|16|32|64))[ \t]+([a-z]\w*)[ \t]*(?:$|[#\d.-])", re.MULTILINE
)
MOST_CURVES = 6
CURVES_EACH = 3


def with_views(site: Site) -> Site:
    """Return the site with panels beside bags that have a page of their own, or ask for them."""
    return replace(site, pages=tuple(_page(site, page) for page in site.pages))


def _page(site: Site, page: Page) -> Page:
    others = [part for part in page.leaves if not isinstance(part, Markdown)]
    alone = len(others) == 1 and not page.nodes and not page.scripts
    return replace(page, content=tuple(_filled(site, page, page.content, alone=alone)))


def _filled(site: Site, page: Page, parts: Iterable[Part], *, alone: bool) -> Iterator[Part]:
    for part in parts:
        if isinstance(part, Layout):
            cells = (
                replace(cell, content=tuple(_filled(site, page, cell.content, alone=alone)))
                for cell in part.cells
            )
            yield replace(part, cells=tuple(cells))
        elif isinstance(part, Widget) and part.kind == KIND:
            wanted = part.options.get("views", alone)
            views = _views(site, page, part) if wanted and part.options.get("file") else []
            plain = {name: value for name, value in part.options.items() if name != "views"}
            yield from _arranged(replace(part, options=plain), views)
        else:
            yield part


def _arranged(bag: Widget, views: Sequence[Part]) -> Iterator[Part]:
    """Yield the first view beside the bag, the others below them, and the list of topics last."""
    if not views:
        yield bag
        return
    main, *others = views
    cells = (Cell((main,), size=3), Cell((bag,), size=2))
    yield Layout("columns", cells, bag.location)
    if not others:
        return
    *middle, last = others
    if len(middle) > 1:
        yield Layout("grid", tuple(Cell((view,)) for view in middle), bag.location)
    else:
        yield from middle
    yield last


def _views(site: Site, page: Page, bag: Widget) -> list[Part]:
    items = list(_items(_played(bag.options, topics(file_of(site, str(bag.options["file"]))))))
    problems = Problems(site.root)
    value = parse(json.dumps(items), bag.location, problems, key=KIND, empty="")
    folder = page.file.parent if page.file else site.root
    reader = Reader(page.nodes, problems, Problems(site.root), folder)
    views = list(reader.items(value)) if value else []
    problems.raise_if_any()
    return views


def _played(options: Mapping[str, Any], found: Iterable[Topic]) -> list[Topic]:
    """Return the topics that a player publishes, by the names that it publishes them with."""
    chosen, left, names = (options.get(key) for key in ("topics", "exclude", "remap"))
    return [
        replace(topic, name=(names or {}).get(topic.name, topic.name))
        for topic in found
        if (not chosen or topic.name in chosen) and topic.name not in (left or ())
    ]


def _items(played: Sequence[Topic]) -> Iterator[dict[str, Any]]:
    """Yield the items of `content` that show topics."""
    spatial = {name for kind in kinds().values() for name in kind.types if name not in PLAIN}
    if any(
        topic.type in spatial or topic.name in FRAMES or topic.name.endswith(DESCRIPTION)
        for topic in played
    ):
        yield {"3d": None}
    for topic in [topic for topic in played if topic.type in IMAGES][:MOST_IMAGES]:
        yield {"image": topic.name}
    if series := [curve for topic in played for curve in _curves(topic, spatial)]:
        yield {"plot": series[:MOST_CURVES]}
    yield {"topics": None}


def _curves(topic: Topic, spatial: set[str]) -> list[str]:
    """Return paths to numbers of a topic."""
    paths: Sequence[str] = CURVES.get(topic.type, ())
    if not paths and topic.type not in spatial and topic.type not in (*IMAGES, *DULL):
        own, *_ = topic.definition.split("=" * 80)
        paths = NUMBER.findall(own)[:CURVES_EACH]
    return [f"{topic.name}.{path}" for path in paths]
