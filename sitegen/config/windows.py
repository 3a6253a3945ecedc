"""Turn the windows that a launch file opens into widgets."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

from sitegen.config.layout import captioned
from sitegen.config.rviz import Configuration, read_configuration
from sitegen.config.widgetkeys import WIDGETS
from sitegen.errors import Problems
from sitegen.launch import Window
from sitegen.model import Cell, Layout, Part, Widget

# Parameters of joint_state_publisher that say what the sliders do anyway.
FOLLOWED = ("robot_description", "use_sim_time")
# The share of the width that a 3D view has beside other windows.
LARGE = 3
SMALL = 2


def shown(
    windows: Sequence[Window], nodes: Sequence[str], problems: Problems, notes: Problems
) -> list[Part]:
    """Return the widgets that take the places of windows, those in 3D beside one of the others.

    What `nodes` print shows over those in 3D, too.
    """
    widgets = [_widget(one, problems, notes) for one in windows if one.kind in WIDGETS]
    large = tuple(captioned(widget, nodes) for widget in widgets if widget.kind == "3d")
    small = tuple(widget for widget in widgets if widget.kind != "3d")
    if not large or not small:
        return [*large, *small]
    # One is about as high as a 3D view; more would leave the space below that empty.
    cells = (Cell(large, size=LARGE), Cell(small[:1], size=SMALL))
    return [Layout("columns", cells, large[0].location), *small[1:]]


def _widget(window: Window, problems: Problems, notes: Problems) -> Widget:
    defaults = {key.name: key.default for key in WIDGETS[window.kind] if not key.required}
    options: dict[str, Any] = defaults
    if window.kind == "3d":
        options = _rviz(window, problems, notes)
    elif window.kind == "image" and (topics := _plain(window)):
        options = {**defaults, "topic": window.resolved(topics[0])}
    elif window.kind == "plot" and (paths := _plain(window)):
        options = {**defaults, "series": [path for one in paths for path in _paths(one, window)]}
    elif window.kind == "joints":
        options = {**defaults, "zeros": _zeros(window, notes)}
    return Widget(window.kind, "", options, window.location)


def _zeros(window: Window, notes: Problems) -> dict[str, float]:
    """Return where the joints are at first, by the parameters of joint_state_publisher."""
    zeros: dict[str, float] = {}
    for name, text in window.parameters.items():
        if name in FOLLOWED:
            continue
        start, _, joint = name.partition(".")
        try:
            if start != "zeros" or not joint:
                raise ValueError
            zeros[joint] = float(text)
        except ValueError:
            message = f"parameter '{name}' is ignored; the sliders know 'zeros.<joint>', a number"
            notes.add(window.location, window.executable, message)
    return zeros


def _rviz(window: Window, problems: Problems, notes: Problems) -> dict[str, Any]:
    """Return the options of the view that `rviz2` would open with its arguments."""
    options: dict[str, Any] = {}
    found = dict(pairwise(window.arguments))
    name = found.get("-d") or found.get("--display-config") or ""
    if name:
        options |= _configured(Path(name), window, problems, notes)
    if frame := found.get("-f") or found.get("--fixed-frame"):
        options["frame"] = frame
    return options


def _configured(file: Path, window: Window, problems: Problems, notes: Problems) -> dict[str, Any]:
    try:
        configuration: Configuration = read_configuration(file, window.resolved)
    except ValueError as error:
        problems.add(window.location, "rviz2", str(error))
        return {}
    if configuration.unsupported:
        names = ", ".join(configuration.unsupported)
        notes.add(window.location, "rviz2", f"{names}: not supported in the 3D view and left out")
    return dict(configuration.options)


def _plain(window: Window) -> list[str]:
    """Return the arguments that are no options."""
    return [word for word in window.arguments if not word.startswith("-")]


def _paths(path: str, window: Window) -> list[str]:
    """Return the message paths that an argument of rqt_plot names: `/a/x:y` is two of them."""
    first, *others = path.split(":")
    above = first.rpartition("/")[0]
    return [_path(one, window) for one in (first, *(f"{above}/{name}" for name in others))]


def _path(path: str, window: Window) -> str:
    return path if path.startswith("/") else f"{window.namespace}/{path}"
