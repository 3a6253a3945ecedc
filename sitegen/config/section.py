"""Check a mapping against the keys of the schema."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sitegen.config.document import Value, shortened
from sitegen.config.schema import FORMS, TYPES, Key, belongs, meant
from sitegen.errors import Location, Problems, nearest


@dataclass(frozen=True)
class Section:
    """A checked mapping: invalid values are replaced by their defaults."""

    value: Value
    keys: tuple[Key, ...]
    entries: Mapping[str, Value]

    def get(self, name: str) -> Value | None:
        """Return the value of `name`, None if it is missing or invalid."""
        return self.entries.get(name)

    def option(self, name: str) -> str | bool | int | list[str] | None:
        """Return the text, boolean, number or list of text of `name`, or its default."""
        entry = self.get(name)
        if entry is None:
            return next(key.default for key in self.keys if key.name == name)
        return [item.text for item in entry.items()] if entry.kind == "list" else entry.scalar

    def text(self, name: str) -> str:
        """Return the text of `name`, or its default."""
        return str(self.option(name) or "")

    def location(self, name: str) -> Location:
        """Return the location of `name`, or of the mapping if it is missing."""
        return (self.get(name) or self.value).location

    def label(self, name: str) -> str:
        """Return the label of `name` in messages."""
        return f"{self.value.key}.{name}" if self.value.key else name


def check(value: Value, keys: tuple[Key, ...], problems: Problems) -> Section:
    """Return the entries of `value` that are valid according to `keys`, and report all others."""
    if value.kind != "mapping":
        names = ", ".join(key.name for key in keys)
        message = f"expected keys and values, found {value.found}; the keys are {names}"
        problems.add(value.location, value.label, message)
        return Section(value, keys, {})
    known = {key.name: key for key in keys}
    entries = value.entries(problems)
    sound: dict[str, Value] = {}
    for name, entry in entries.items():
        if name not in known:
            place = belongs(name, keys)
            near = meant(name, keys) or nearest(name, known)
            message = f"belongs {place}" if place else f"unknown key; {near}"
            problems.add(entry.location, entry.key, message)
        elif conforms(entry, known[name], problems):
            sound[name] = entry
    section = Section(value, keys, sound)
    for key in keys:
        if key.required and key.name not in entries:
            message = f"missing; write it like '{key.example}'"
            problems.add(value.location, section.label(key.name), message)
    return section


def conforms(value: Value, key: Key, problems: Problems) -> bool:
    """Return whether `value` is of the type of `key`, and report if it is not."""
    kind, name = TYPES[key.type]
    empty = (kind == "text" and not value.text.strip()) or (kind == "number" and value.text == "0")
    if value.kind not in kind.split(" or ") or empty:
        problems.add(value.location, value.label, f"expected {name}, {_found(value, key)}")
        return False
    form = key.type.removeprefix("list of ").removeprefix("mapping of ").removesuffix("s")
    form = form if form in FORMS else "text"
    parts = _texts(value, key, problems)
    wrong = [part for part in parts if not _fits(part, form)]
    for part in wrong:
        message = f"expected {TYPES[form][1]}, {_found(part, key)}"
        problems.add(part.location, part.key, message)
    return not wrong


def _fits(value: Value, form: str) -> bool:
    pattern = FORMS.get(form)
    sound = value.kind in TYPES[form][0].split(" or ")
    return sound and (pattern is None or bool(pattern.fullmatch(value.text)))


def _texts(value: Value, key: Key, problems: Problems) -> list[Value]:
    if key.type.startswith("list of ") or (key.type == "message paths" and value.kind == "list"):
        return value.items()
    if key.type == "message paths":
        return [value]
    if key.type in FORMS:
        return [value]
    return list(value.entries(problems).values()) if key.type.startswith("mapping of ") else []


def _found(value: Value, key: Key) -> str:
    if ("text" in key.type or key.type == "digest") and value.kind in ("number", "flag", "other"):
        return f'found {value.found}; put it in quotes: "{shortened(value.text)}"'
    return f"found {value.found}; write it like '{key.example}'"
