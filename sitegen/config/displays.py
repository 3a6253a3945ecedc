"""Read the displays of a 3D view."""

from __future__ import annotations

import functools
import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sitegen.config.document import Value
from sitegen.config.schema import FORMS
from sitegen.errors import Problems, nearest
from sitegen.shipped import BUNDLES

Setting = str | bool | int | float
NUMBER = re.compile(r"-?(\d+(\.\d*)?|\.\d+)([eE][-+]?\d+)?", re.ASCII)


@dataclass(frozen=True)
class Kind:
    """A kind of display, as its module in runtime/widgets/3d/displays/ defines it.

    `types` are those of the messages that it shows; `defaults` are its options with their values.
    """

    title: str
    types: Sequence[str]
    defaults: Mapping[str, Setting]
    choices: Mapping[str, Sequence[str]]


@functools.cache
def kinds() -> Mapping[str, Kind]:
    """Return the kinds of displays by name."""
    found = json.loads((BUNDLES / "displays.json").read_text(encoding="utf-8"))
    return {name: Kind(**one) for name, one in found.items()}


def displays(value: Value, problems: Problems) -> list[dict[str, Any]]:
    """Return the displays that a list describes, each with its `kind` and its options."""
    return [one for item in value.items() if (one := _display(item, problems))]


def _display(item: Value, problems: Problems) -> dict[str, Any] | None:
    if item.kind == "text":
        return {"kind": item.text} if _known(item, problems) else None
    entries = item.entries(problems) if item.kind == "mapping" else {}
    if len(entries) != 1:
        message = f"expected a display, found {item.found}; write it like 'laser_scan: /scan'"
        problems.add(item.location, item.label, message)
        return None
    [(name, value)] = entries.items()
    if name not in kinds():
        message = f"unknown display '{name}'; {nearest(name, kinds())}"
        problems.add(value.location, value.key, message)
        return None
    kind = kinds()[name]
    if value.kind == "nothing":
        return {"kind": name}
    if value.kind == "text" and kind.types:
        return {"kind": name, **_options(name, {"topic": value}, problems)}
    if value.kind != "mapping":
        like = f"{name}: {{topic: {kind.defaults['topic']}}}" if kind.types else f"- {name}"
        message = f"expected its options, found {value.found}; write it like '{like}'"
        problems.add(value.location, value.key, message)
        return None
    return {"kind": name, **_options(name, value.entries(problems), problems)}


def _known(item: Value, problems: Problems) -> bool:
    if item.text in kinds():
        return True
    message = f"unknown display '{item.text}'; {nearest(item.text, kinds())}"
    problems.add(item.location, item.label, message)
    return False


def _options(name: str, entries: Mapping[str, Value], problems: Problems) -> dict[str, Setting]:
    kind = kinds()[name]
    found: dict[str, Setting] = {}
    for key, entry in entries.items():
        if key == "enabled" and entry.kind == "flag":
            found[key] = entry.scalar
            continue
        if key not in kind.defaults:
            message = f"unknown option; {nearest(key, (*kind.defaults, 'enabled'))}"
            problems.add(entry.location, entry.key, message)
            continue
        setting, wanted = _setting(key, entry, kind)
        if setting is None:
            message = f"expected {wanted}, found {entry.found}"
            problems.add(entry.location, entry.key, message)
        else:
            found[key] = setting
    return found


def _setting(key: str, entry: Value, kind: Kind) -> tuple[Setting | None, str]:
    """Return the value of an option, or None and what is expected."""
    default, text = kind.defaults[key], entry.text
    if key in kind.choices:
        return text if text in kind.choices[key] else None, f"one of {', '.join(kind.choices[key])}"
    if isinstance(default, bool):
        return entry.scalar if entry.kind == "flag" else None, "true or false"
    if isinstance(default, int | float):
        return float(text) if NUMBER.fullmatch(text) else None, "a number"
    if default.startswith("#"):
        return text if FORMS["color"].fullmatch(text) else None, 'a color like "#2b4bd8"'
    if key == "topic":
        return text if FORMS["name"].fullmatch(text) else None, f"a topic like {default}"
    return text if entry.kind in ("text", "number") else None, "text"
