"""Read a 3D view: its displays, or the `.rviz` file that describes it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from sitegen.config import displays
from sitegen.config.document import Value
from sitegen.config.files import locate
from sitegen.config.rviz import read_configuration
from sitegen.config.section import check
from sitegen.config.widgetkeys import WIDGETS
from sitegen.errors import Location, Problems
from sitegen.model import Widget

KIND = "3d"
TOOLS = ("goal", "estimate", "point")


def scene(value: Value, problems: Problems, notes: Problems, page: Path) -> Widget | None:
    """Return the 3D view that `value` describes.

    `notes` get what its `.rviz` file has in vain; `page` is the folder of the page.
    """
    if value.kind == "nothing":
        return Widget(KIND, "", {}, value.location)
    if value.kind == "text":
        message = f"expected its options or nothing, found {value.found}"
        like = f"3d: {{rviz: {value.text}}}" if value.text.endswith(".rviz") else "3d:"
        problems.add(value.location, value.key, f"{message}; write it like '{like}'")
        return None
    section = check(value, WIDGETS[KIND], problems)
    options: dict[str, Any] = {}
    if given := section.get("rviz"):
        options |= _configured(given, problems, notes, page)
    for name in ("frame", "background"):
        if text := section.text(name):
            options[name] = text
    if given := section.get("displays"):
        shown = displays.displays(given, problems)
        for one, item in zip(shown, given.items(), strict=False):
            _locate(one, item, problems, page)
        options["displays"] = [*options.get("displays", ()), *shown]
    if given := section.get("tools"):
        topics = given.entries(problems)
        for name, entry in topics.items():
            if name not in TOOLS:
                message = f"no tool '{name}'; there are {', '.join(TOOLS)}"
                problems.add(entry.location, entry.key, message)
        options["tools"] = {name: entry.text for name, entry in topics.items()}
    if section.option("top") is True:
        options["top"] = True
    return Widget(KIND, "", options, value.location)


def _configured(given: Value, problems: Problems, notes: Problems, page: Path) -> dict[str, Any]:
    """Return the options that the `.rviz` file named by `given` stands for."""
    file = locate(given, problems, page=page)
    if not file:
        return {}
    try:
        found = read_configuration(file)
    except ValueError as error:
        problems.add(given.location, given.key, f"{error}")
        return {}
    if found.unsupported:
        names = ", ".join(found.unsupported)
        notes.add(Location(file, 1), "rviz", f"{names}: not supported in the 3D view and left out")
    return dict(found.options)


def _locate(display: dict[str, Any], item: Value, problems: Problems, page: Path) -> None:
    """Replace the file of a robot by its path below the folder of the site."""
    if not display.get("file"):
        return
    [options] = item.entries(problems).values()
    file = locate(options.entries(problems)["file"], problems, page=page)
    if file:
        display["file"] = file.relative_to(problems.root.resolve()).as_posix()
