"""Read the configuration files of RViz (`.rviz`)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import yaml

from sitegen.config.displays import kinds
from sitegen.launch.names import joined
from sitegen.yamlnodes import LimitError, compose

# What RViz writes when nobody has chosen a background: the theme's then is the better one.
USUAL_BACKGROUND = "#303030"
# The height of a window, and what the menu and the bars of tools and time take of it (px).
USUAL_HEIGHT, BARS = 690, 90

# For each class of RViz: the kind of our display, and which of its properties each option is.
# A property "A/B" is the property B of A.
CLASSES: Mapping[str, tuple[str, Mapping[str, str]]] = {
    "Axes": ("axes", {"length": "Length", "radius": "Radius", "frame": "Reference Frame"}),
    "Grid": (
        "grid",
        {
            "cells": "Plane Cell Count",
            "size": "Cell Size",
            "color": "Color",
            "alpha": "Alpha",
            "plane": "Plane",
            "frame": "Reference Frame",
        },
    ),
    "TF": (
        "tf",
        {
            "names": "Show Names",
            "axes": "Show Axes",
            "arrows": "Show Arrows",
            "scale": "Marker Scale",
            "timeout": "Frame Timeout",
        },
    ),
    "RobotModel": (
        "robot",
        {
            "topic": "Description Topic/Value",
            "visual": "Visual Enabled",
            "collision": "Collision Enabled",
            "alpha": "Alpha",
            "prefix": "TF Prefix",
        },
    ),
    "Marker": ("markers", {"topic": "Topic/Value"}),
    "MarkerArray": ("markers", {"topic": "Topic/Value"}),
    "InteractiveMarkers": (
        "interactive_markers",
        {"topic": "Interactive Markers Namespace"},
    ),
    "LaserScan": (
        "laser_scan",
        {
            "topic": "Topic/Value",
            "size": "Size (m)",
            "alpha": "Alpha",
            "decay": "Decay Time",
            "color": "Color",
        },
    ),
    "PointCloud2": (
        "point_cloud",
        {
            "topic": "Topic/Value",
            "size": "Size (m)",
            "alpha": "Alpha",
            "decay": "Decay Time",
            "color": "Color",
        },
    ),
    "Map": ("map", {"topic": "Topic/Value", "alpha": "Alpha", "scheme": "Color Scheme"}),
    "Path": (
        "path",
        {"topic": "Topic/Value", "color": "Color", "alpha": "Alpha", "width": "Line Width"},
    ),
    "Odometry": (
        "odometry",
        {
            "topic": "Topic/Value",
            "keep": "Keep",
            "color": "Shape/Color",
            "alpha": "Shape/Alpha",
            "length": "Shape/Shaft Length",
            "distance": "Position Tolerance",
            "angle": "Angle Tolerance",
        },
    ),
    "Pose": (
        "pose",
        {
            "topic": "Topic/Value",
            "color": "Color",
            "alpha": "Alpha",
            "shape": "Shape",
            "length": "Shaft Length",
        },
    ),
    "PoseWithCovariance": (
        "pose",
        {
            "topic": "Topic/Value",
            "color": "Color",
            "alpha": "Alpha",
            "shape": "Shape",
            "length": "Shaft Length",
        },
    ),
    "PoseArray": (
        "pose_array",
        {"topic": "Topic/Value", "color": "Color", "alpha": "Alpha", "length": "Arrow Length"},
    ),
    "PointStamped": (
        "point",
        {
            "topic": "Topic/Value",
            "radius": "Radius",
            "color": "Color",
            "alpha": "Alpha",
            "keep": "History Length",
        },
    ),
    "Polygon": ("polygon", {"topic": "Topic/Value", "color": "Color", "alpha": "Alpha"}),
    "Range": ("range", {"topic": "Topic/Value", "color": "Color", "alpha": "Alpha"}),
    "Wrench": (
        "wrench",
        {
            "topic": "Topic/Value",
            "force_color": "Force Color",
            "torque_color": "Torque Color",
            "force_scale": "Force Arrow Scale",
            "torque_scale": "Torque Arrow Scale",
            "alpha": "Alpha",
        },
    ),
    "Imu": ("imu", {"topic": "Topic/Value", "alpha": "Box properties/Box alpha"}),
    "Camera": ("camera", {"topic": "Topic/Value", "alpha": "Alpha"}),
}
# How RViz colours points, by its name of the way.
COLOURED = {"FlatColor": "color", "Intensity": "intensity", "RGB8": "rgb", "RGBF32": "rgb"}
# Tools that publish, and ours.
TOOLS = {"SetGoal": "goal", "SetInitialPose": "estimate", "PublishPoint": "point"}
FIXED = "<Fixed Frame>"
# The full names of topics for an RViz without a namespace.
ABSOLUTE = partial(joined, "")


@dataclass(frozen=True)
class Configuration:
    """What a `.rviz` file says: the options of a 3D view, and what has no counterpart there."""

    options: Mapping[str, Any]
    unsupported: tuple[str, ...]


def read_configuration(file: Path, resolved: Callable[[str], str] = ABSOLUTE) -> Configuration:
    """Return what a `.rviz` file says; `resolved` returns the full names of topics.

    Raises: ValueError with the reason if it cannot be read.
    """
    try:
        root = compose(file.read_text(encoding="utf-8-sig"))
        found = yaml.SafeLoader("").construct_document(root) if root else None
    except (LimitError, OSError, UnicodeDecodeError, ValueError, yaml.YAMLError) as error:
        line = " ".join(str(error).split())[:200]
        raise ValueError(f"{file.name} cannot be read as YAML: {line}") from error
    manager = _at(found, "Visualization Manager")
    if not isinstance(manager, dict):
        raise ValueError(f"{file.name} has no 'Visualization Manager'; save it with RViz 2")
    unsupported: list[str] = []
    shown = list(_displays(_list(manager.get("Displays")), True, unsupported, resolved))
    frame = _at(manager, "Global Options/Fixed Frame")
    options: dict[str, Any] = {"displays": shown}
    if isinstance(frame, str) and frame:
        options["frame"] = frame
    background = _color(_at(manager, "Global Options/Background Color"))
    if background and background != USUAL_BACKGROUND:
        options["background"] = background
    if topics := dict(_tools(_list(manager.get("Tools")), resolved)):
        options["tools"] = topics
    if view := _view(_at(manager, "Views/Current"), _at(found, "Window Geometry/Height")):
        options["view"] = view
    return Configuration(options, tuple(dict.fromkeys(unsupported)))


def _displays(
    given: list[Any], enabled: bool, unsupported: list[str], resolved: Callable[[str], str]
) -> Iterator[dict[str, Any]]:
    for each in given:
        if not isinstance(each, dict):
            continue
        on = enabled and each.get("Enabled") is not False
        name = str(each.get("Class", "")).rpartition("/")[2]
        if name == "Group":
            yield from _displays(_list(each.get("Displays")), on, unsupported, resolved)
        elif name not in CLASSES or CLASSES[name][0] not in kinds():
            unsupported.append(str(each.get("Class", "a display without a class")))
        else:
            shown = _display(name, each, on)
            yield {
                key: resolved(value) if key == "topic" else value for key, value in shown.items()
            }


def _display(name: str, given: dict[str, Any], enabled: bool) -> dict[str, Any]:
    kind, properties = CLASSES[name]
    defaults, choices = kinds()[kind].defaults, kinds()[kind].choices
    found: dict[str, Any] = {"kind": kind}
    for option, place in properties.items():
        value = _at(given, place)
        # Displays of former versions have their topic as a text.
        if value is None and place == "Topic/Value":
            value = given.get("Topic")
        default = defaults[option]
        if isinstance(default, bool):
            fits = isinstance(value, bool)
        elif isinstance(default, int | float):
            fits = isinstance(value, int | float) and not isinstance(value, bool)
            fits = fits and math.isfinite(value)
        elif default.startswith("#"):
            value = _color(value)
            fits = bool(value)
        elif option in choices:
            value = str(value).lower() if option != "plane" else value
            fits = value in choices[option]
        else:
            fits = isinstance(value, str) and value not in ("", FIXED)
        if fits and kind == "interactive_markers":
            value = f"{value}/update"
        if fits:
            found[option] = value
    if "color_by" in defaults:
        found |= _colouring(given)
    if name in ("LaserScan", "PointCloud2") and given.get("Style") == "Points":
        # A size in pixels.
        found.pop("size", None)
    if not enabled:
        found["enabled"] = False
    return found


def _colouring(given: dict[str, Any]) -> dict[str, Any]:
    """Return how points are coloured, and the range of values if it is fixed."""
    way = given.get("Color Transformer")
    axis = str(given.get("Axis", "Z")).lower()
    by = axis if way == "AxisColor" else COLOURED.get(str(way), "")
    found: dict[str, Any] = {"color_by": by} if by else {}
    fixed = given.get("Autocompute Intensity Bounds") is False
    least, most = given.get("Min Intensity"), given.get("Max Intensity")
    if by == "intensity" and fixed and isinstance(least, int | float):
        found |= {"min": least, "max": most if isinstance(most, int | float) else least + 1}
    return found


def _tools(given: list[Any], resolved: Callable[[str], str]) -> Iterator[tuple[str, str]]:
    for each in given:
        if isinstance(each, dict):
            name = TOOLS.get(str(each.get("Class", "")).rpartition("/")[2])
            topic = _at(each, "Topic/Value")
            if name and isinstance(topic, str) and topic:
                yield name, resolved(topic)


def _view(given: Any, height: Any) -> dict[str, Any] | None:
    """Return the camera of a view, of an orbit or straight down, in a window of `height` (px)."""
    if not isinstance(given, dict):
        return None
    kind = str(given.get("Class", "")).rpartition("/")[2]
    if kind == "TopDownOrtho":
        x, y = _number(given.get("X"), 0), _number(given.get("Y"), 0)
        # Pixels for each metre; at zoom 1, a panel shows two metres.
        size = max(_number(height, USUAL_HEIGHT) - BARS, BARS)
        zoom = max(abs(_number(given.get("Scale"), 10)), 0.01) * 2 / size
        return {"top": True, "eye": [x, y, 100], "target": [x, y, 0], "zoom": zoom}
    if kind not in ("Orbit", "XYOrbit", "ThirdPersonFollower"):
        return None
    yaw, pitch = _number(given.get("Yaw"), 0.785), _number(given.get("Pitch"), 0.785)
    distance = max(_number(given.get("Distance"), 10), 0.01)
    focus = _at(given, "Focal Point")
    target = [_number(_at(focus, axis), 0) for axis in "XYZ"]
    flat = math.cos(pitch) * distance
    offset = (math.cos(yaw) * flat, math.sin(yaw) * flat, math.sin(pitch) * distance)
    eye = [round(one + other, 4) for one, other in zip(target, offset, strict=True)]
    return {"top": False, "eye": eye, "target": target, "zoom": 1}


def _at(value: Any, place: str) -> Any:
    """Return the value at a path of keys, None if there is none."""
    for name in place.split("/"):
        value = value.get(name) if isinstance(value, dict) else None
    return value


def _list(value: Any) -> list[Any]:
    return value if isinstance(value, list) else []


def _number(value: Any, default: float) -> float:
    usable = isinstance(value, int | float) and not isinstance(value, bool)
    return float(value) if usable and math.isfinite(value) else default


def _color(value: Any) -> str:
    """Return a colour of RViz, "255; 0; 0", as "#ff0000"; "" if it is none."""
    parts = str(value).split(";") if isinstance(value, str) else []
    if len(parts) != 3 or not all(part.strip().isdigit() for part in parts):
        return ""
    return "#" + "".join(f"{min(int(part), 255):02x}" for part in parts)
