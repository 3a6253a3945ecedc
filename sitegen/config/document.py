"""Parse YAML into values that know their location."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import yaml

from sitegen.config.yamlfault import explain
from sitegen.errors import Location, Problems
from sitegen.yamlnodes import LimitError, compose

KINDS = {"str": "text", "bool": "flag", "int": "number", "null": "nothing"}


@dataclass(frozen=True)
class Value:
    """A YAML value; `key` is the path to it from the top, and `start` the location of the top."""

    node: yaml.Node
    key: str
    location: Location
    start: Location

    @property
    def label(self) -> str:
        """The name of this value in a message."""
        return self.key or "yaml"

    @property
    def kind(self) -> str:
        """One of: text, flag, number, nothing, list, mapping, other."""
        if isinstance(self.node, yaml.MappingNode):
            return "mapping"
        if isinstance(self.node, yaml.SequenceNode):
            return "list"
        kind = KINDS.get(self.node.tag.rpartition(":")[2], "other")
        # YAML 1.1 also has numbers like 0x10, 1_000 and 12:30, which no author of a site means.
        return "other" if kind == "number" and not re.fullmatch(r"\d+", self.text) else kind

    @property
    def text(self) -> str:
        """A scalar as it was written."""
        return self.node.value if isinstance(self.node.value, str) else ""

    @property
    def scalar(self) -> str | bool | int:
        """A scalar by its meaning: a boolean, a number or a string."""
        if self.kind == "flag":
            return self.text.lower() in ("true", "yes", "on")
        return int(self.text) if self.kind == "number" else self.text

    @property
    def found(self) -> str:
        """The kind of this value, as messages name it."""
        if self.kind in ("list", "nothing"):
            return {"list": "a list", "nothing": "nothing"}[self.kind]
        if self.kind == "mapping":
            return "keys and values"
        if self.kind == "text":
            return f"the text '{shortened(self.text)}'" if self.text.strip() else "an empty text"
        return {"number": f"the number {self.text}", "flag": f"the truth value {self.text}"}.get(
            self.kind, f"'{shortened(self.text)}', which YAML does not read as text"
        )

    @property
    def text_start(self) -> Location:
        """Where the first line of a text was written."""
        block = isinstance(self.node, yaml.ScalarNode) and self.node.style in ("|", ">")
        return self._location(self.node.start_mark.line + block)

    def has(self, *keys: str) -> bool:
        """Return whether a mapping has one of `keys`, valid or not."""
        return any(key.text in keys for key, _ in self._pairs())

    def items(self) -> list[Value]:
        """Return the items of a list; of any other value, none."""
        nodes = self.node.value if isinstance(self.node, yaml.SequenceNode) else []
        return [
            replace(self, node=node, key=f"{self.key}[{i}]", location=self._location_of(node))
            for i, node in enumerate(nodes)
        ]

    def entries(self, problems: Problems) -> dict[str, Value]:
        """Return the values of a mapping by key, and report unusable and repeated keys."""
        entries: dict[str, Value] = {}
        for key, value in self._pairs():
            if key.kind != "text":
                problems.add(
                    key.location,
                    self.label,
                    f"a key must be text, found {key.found}; put it in quotes",
                )
            elif key.text in entries:
                line = entries[key.text].location.line
                problems.add(
                    key.location, value.key, f"already given on line {line}; remove one of the two"
                )
            else:
                entries[key.text] = value
        return entries

    def texts(self, problems: Problems) -> dict[str, str]:
        """Return the texts of a mapping by key, and report unusable and repeated keys."""
        return {name: each.text for name, each in self.entries(problems).items()}

    def _pairs(self) -> Iterator[tuple[Value, Value]]:
        for key, node in self.node.value if isinstance(self.node, yaml.MappingNode) else []:
            location = self._location_of(key)
            name = key.value if isinstance(key, yaml.ScalarNode) else "?"
            path = f"{self.key}.{name}" if self.key else name
            yield (
                replace(self, node=key, location=location),
                replace(self, node=node, key=path, location=location),
            )

    def _location_of(self, node: yaml.Node) -> Location:
        return self._location(node.start_mark.line)

    def _location(self, line: int) -> Location:
        return Location(self.start.file, self.start.line + line)


def read(file: Path, problems: Problems) -> str | None:
    """Return the text of `file` with normalized line ends; report one that cannot be read."""
    try:
        data = file.read_bytes()
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        message = f"not UTF-8 (byte 0x{data[error.start]:02x}); save the file as UTF-8"
        problems.add(Location(file, line), "text", message)
        return None
    except OSError as error:
        problems.add(Location(file, 1), "text", f"cannot be read: {error.strerror}")
        return None
    return text.replace("\r\n", "\n").replace("\r", "\n")


def parse(
    text: str, start: Location, problems: Problems, *, key: str = "", empty: str = ""
) -> Value | None:
    """Return the value of the YAML `text`, which begins at `start`; report invalid YAML.

    For text without a value, the problem says to write what `empty` names.
    """
    try:
        node = compose(text)
    except LimitError as error:
        line = error.problem_mark.line if error.problem_mark else 0
        problems.add(Location(start.file, start.line + line), "yaml", str(error.problem))
        return None
    except yaml.YAMLError as error:
        line, what = explain(error, text)
        problems.add(Location(start.file, start.line + line), "yaml", what)
        return None
    if node is None:
        if empty:
            problems.add(start, key or "yaml", empty)
        return None
    location = Location(start.file, start.line + node.start_mark.line)
    return Value(node, key, location, start)


def shortened(text: str) -> str:
    """Return `text` as one line, cut to a length that fits into a message."""
    line = " ".join(text.split())
    return line if len(line) <= 40 else f"{line[:39]}…"
