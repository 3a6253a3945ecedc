"""Read the options of panels, which are widgets about the whole page."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import pairwise

from sitegen.config.document import Value
from sitegen.config.schema import Key
from sitegen.config.section import Section, check, conforms
from sitegen.config.widgetkeys import CHOICES, SHORT, THRESHOLD, WIDGETS
from sitegen.errors import Problems, nearest


def panel(kind: str, value: Value, problems: Problems) -> Mapping[str, object] | None:
    """Return the options of a panel; it may be written without any, or as the option in SHORT."""
    keys = WIDGETS[kind]
    if kind in SHORT and value.kind in ("text", "list"):
        key = next(key for key in keys if key.name == SHORT[kind])
        short = replace(key, example=f"{kind}:{key.example.removeprefix(f'{key.name}:')}")
        if not conforms(value, short, problems):
            return None
        return _options(Section(value, keys, {key.name: value}), problems)
    if value.kind == "mapping" and keys:
        section = check(value, keys, problems)
        _check_words(section, problems)
        if "min" in section.entries or "max" in section.entries:
            _check_ends(section, problems)
        return _options(section, problems)
    if value.kind == "nothing" and not any(key.required for key in keys):
        return _options(Section(value, keys, {}), problems)
    forms = [f"its options ({', '.join(key.name for key in keys)})"] if keys else []
    if not any(key.required for key in keys):
        forms.append("nothing")
    example = next((f" {key.example.partition(': ')[2]}" for key in keys if key.required), "")
    found = f"expected {' or '.join(forms)}, found {value.found}"
    problems.add(value.location, value.key, f"{found}; write it like '{kind}:{example}'")
    return None


def _options(section: Section, problems: Problems) -> dict[str, object]:
    return {key.name: _option(section, key, problems) for key in section.keys}


def _option(section: Section, key: Key, problems: Problems) -> object:
    entry = section.get(key.name)
    if entry and key.type == "decimal":
        return float(entry.text)
    if entry and key.type == "mapping of decimals":
        return {name: float(each.text) for name, each in entry.entries(problems).items()}
    if entry and key.type == "message paths" and entry.kind == "text":
        return [entry.text]
    if entry and key.type == "thresholds":
        return _thresholds(entry, problems)
    return section.option(key.name)


def _thresholds(value: Value, problems: Problems) -> list[dict[str, object]]:
    """Return thresholds, which have to rise."""
    sections = [check(item, THRESHOLD, problems) for item in value.items()]
    for section in sections:
        _check_words(section, problems)
    starts = [(section, _number(section, "from")) for section in sections]
    for (_, before), (section, start) in pairwise(starts):
        if before is not None and start is not None and start <= before:
            message = f"must be above {before:g}, that of the threshold before; sort them"
            problems.add(section.location("from"), section.label("from"), message)
    return [_options(section, problems) for section in sections]


def _check_words(section: Section, problems: Problems) -> None:
    for name, words in CHOICES.get(section.keys, {}).items():
        entry = section.get(name)
        if entry and entry.text not in words:
            message = f"unknown word '{entry.text}'; {nearest(entry.text, words)}"
            problems.add(entry.location, entry.key, message)


def _check_ends(section: Section, problems: Problems) -> None:
    low, high = (_number(section, name) for name in ("min", "max"))
    if low is not None and high is not None and low >= high:
        name = "max" if section.get("max") else "min"
        message = f"max must be above min, found {low:g} to {high:g}"
        problems.add(section.location(name), section.label(name), message)


def _number(section: Section, name: str) -> float | None:
    entry = section.get(name)
    if entry:
        return float(entry.text)
    default = next(key.default for key in section.keys if key.name == name)
    return float(default) if isinstance(default, int) else None
