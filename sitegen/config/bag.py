"""Read the options of a bag: which file it plays, which topics it records."""

from __future__ import annotations

from math import inf
from pathlib import Path
from typing import Any

from sitegen.config.document import Value
from sitegen.config.files import locate
from sitegen.config.section import Section, check, conforms
from sitegen.config.widgetkeys import WIDGETS
from sitegen.errors import Problems
from sitegen.model import Widget

KIND = "bag"
# A file, or a folder as `ros2 bag record` makes it.
SUFFIXES = (".mcap", ".db3", ".bag")
METADATA = "metadata.yaml"
# The keys that only a player or only a recorder has.
PLAYING = (
    "autostart",
    "loop",
    "rate",
    "from",
    "to",
    "clock",
    "remap",
    "topics",
    "exclude",
    "views",
)
# These are about one bag.
OWN = ("autostart", "from", "to", "views")
RECORDING = ("hidden", "limit")
RATES = (0.01, 100.0)


def bag(value: Value, problems: Problems, page: Path) -> Widget | None:
    """Return the bag that `value` describes; `page` is the folder of the page."""
    keys = WIDGETS[KIND]
    if value.kind == "nothing":
        section = Section(value, keys, {})
    elif value.kind == "text":
        key = next(key for key in keys if key.name == "file")
        section = Section(value, keys, {"file": value} if conforms(value, key, problems) else {})
    else:
        section = check(value, keys, problems)
    options: dict[str, Any] = {}
    for name in ("autostart", "loop", "clock", "hidden"):
        if section.option(name) is True:
            options[name] = True
    if (views := section.option("views")) is not None:
        options["views"] = views
    for name in ("topics", "exclude", "record"):
        if entry := section.get(name):
            options[name] = [item.text for item in entry.items()]
    if entry := section.get("remap"):
        options["remap"] = entry.texts(problems)
    if entry := section.get("rate"):
        options["rate"] = _rate(entry, problems)
    options |= _part(section, problems)
    if entry := section.get("file"):
        options["file"] = _file(entry, problems, page)
    options["limit"] = section.option("limit")
    if ask := section.text("ask"):
        options["ask"] = ask
    _check(section, problems)
    return Widget(KIND, "", options, value.location)


def _check(section: Section, problems: Problems) -> None:
    """Report keys that have no effect beside the others."""
    entries = section.entries
    if "ask" in entries and "record" not in entries:
        message = "needs 'record', the topics that are logged; add a list of them"
        problems.add(section.location("ask"), section.label("ask"), message)
    for name, what in (("record", "record"), ("topics", "play")):
        if name in entries and not entries[name].items():
            message = f"names no topics; leave the key out to {what} all"
            problems.add(section.location(name), section.label(name), message)
    plays = "file" in entries or "record" not in entries
    records = "record" in entries or "file" not in entries
    for name in entries:
        if (name in PLAYING and not plays) or (name in RECORDING and not records):
            other, what = (
                ("file", "plays no bag") if name in PLAYING else ("record", "records none")
            )
            message = f"has no effect: this widget {what}; add '{other}' or remove the key"
            problems.add(section.location(name), section.label(name), message)
    for name in OWN:
        if name in entries and "file" not in entries and plays:
            message = "needs 'file', the bag that it is about"
            problems.add(section.location(name), section.label(name), message)


def _part(section: Section, problems: Problems) -> dict[str, float]:
    """Return the limits of the part that is played, in seconds."""
    entries = {name: entry for name in ("from", "to") if (entry := section.get(name))}
    part = {name: float(entry.text) for name, entry in entries.items()}
    if part.get("from", 0) < 0:
        message = f"must not be negative, found {entries['from'].text}"
        problems.add(entries["from"].location, entries["from"].label, message)
    elif part.get("to", inf) <= part.get("from", 0):
        message = f"must be more than 'from', found {entries['to'].text}"
        problems.add(entries["to"].location, entries["to"].label, message)
    return part


def _rate(entry: Value, problems: Problems) -> float | None:
    rate = float(entry.text)
    low, high = RATES
    if not low <= rate <= high:
        message = f"must be from {low:g} to {high:g}, found {entry.text}"
        problems.add(entry.location, entry.key, message)
    return rate


def _file(entry: Value, problems: Problems, page: Path) -> str:
    """Return the path of a bag, a file or a folder, relative to the folder of the site."""
    folder = any((base / entry.text).is_dir() for base in (problems.root, page))
    file = locate(entry, problems, folder=folder, page=page)
    if not file:
        return ""
    if folder and not (file / METADATA).is_file():
        message = f"'{entry.text}' has no {METADATA}; give a .mcap file or the folder of a bag"
        problems.add(entry.location, entry.label, message)
    elif not folder and file.suffix not in SUFFIXES:
        message = f"'{entry.text}' is not a bag; give a .mcap or .bag file, or the folder of a bag"
        problems.add(entry.location, entry.label, message)
    return file.relative_to(problems.root.resolve()).as_posix()
