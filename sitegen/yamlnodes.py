"""Parse YAML within limits, whoever wrote it: size, depth, and what aliases repeat."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

import yaml

# Far more than any file of a site or a robot has. Checked beforehand, so that no text takes more
# than a few seconds: the parser written in Python reads 100 to 400 kB in a second.
LARGEST = 4_000_000
LARGEST_IN_PYTHON = 400_000
DEEPEST = 100
# The values that aliases may add to those that were written.
MOST_REPEATED = 100_000


class LimitError(yaml.MarkedYAMLError):
    """The text exceeds a limit; `problem` says which."""


def compose(text: str) -> yaml.Node | None:
    """Return the document of `text` as a tree of nodes, None if it is empty.

    Raises: LimitError if it is too large, nested too deeply, or its aliases form a cycle or repeat
    too much; another yaml.YAMLError if it is not valid YAML.
    """
    if len(text) > LARGEST:
        raise LimitError(problem=f"larger than {LARGEST // 1_000_000} MB")
    try:
        node = _parsed(text)
    except RecursionError:
        raise LimitError(problem="nested too deeply; flatten it") from None
    if node is not None:
        _Tree().size(node)
    return node


def load(text: str) -> Any:
    """Return the value of `text`, made of Python's own types; raises what compose() raises."""
    node = compose(text)
    if node is None:
        return None
    loader = yaml.SafeLoader("")
    try:
        return loader.construct_document(node)
    except ValueError as error:  # a date like 2026-02-31
        raise yaml.constructor.ConstructorError(None, None, str(error), node.start_mark) from None
    finally:
        loader.dispose()


def events(text: str) -> list[yaml.Event]:
    """Return the events of `text`, for readers with other rules than YAML's for values.

    Raises: LimitError if it is too large or nested too deeply; another yaml.YAMLError if it is not
    valid YAML.
    """
    if len(text) > LARGEST:
        raise LimitError(problem=f"larger than {LARGEST // 1_000_000} MB")
    if yaml.__with_libyaml__:
        try:
            return list(_shallow(yaml.parse(text, Loader=yaml.CSafeLoader)))
        except LimitError:
            raise
        except yaml.YAMLError:
            if len(text) > LARGEST_IN_PYTHON:
                raise
    return list(_shallow(yaml.parse(text, Loader=yaml.SafeLoader)))


def _shallow(given: Iterable[yaml.Event]) -> Iterator[yaml.Event]:
    depth = 0
    for event in given:
        depth += isinstance(event, yaml.CollectionStartEvent)
        depth -= isinstance(event, yaml.CollectionEndEvent)
        if depth > DEEPEST:
            line = event.start_mark.line + 1 if event.start_mark else 1
            raise LimitError(problem=f"nested too deeply in line {line}; flatten it")
        yield event


def _parsed(text: str) -> yaml.Node | None:
    # libyaml is ten times faster, but it crashes on deep nesting and words its errors differently.
    # It parses text that is certainly shallow; text that it refuses is parsed again in Python.
    begins = max(len(line) - len(line.lstrip(" \t-?")) for line in text.split("\n"))
    if text.count("[") + text.count("{") + begins < 2000 and yaml.__with_libyaml__:
        try:
            return yaml.compose(text, Loader=yaml.CSafeLoader)
        except yaml.YAMLError:
            if len(text) > LARGEST_IN_PYTHON:
                raise
    if len(text) > LARGEST_IN_PYTHON:
        raise LimitError(problem="too many braces and brackets; write it in indented lines")
    return yaml.compose(text, Loader=yaml.SafeLoader)


class _Tree:
    """Counts the values of a tree whose parts may be repeated by aliases."""

    def __init__(self) -> None:
        # By node: the number of values in it, None while they are counted.
        self._sizes: dict[int, int | None] = {}
        self._repeated = 0

    def size(self, node: yaml.Node, depth: int = 0) -> int:
        """Return the number of values in `node`; raises a LimitError."""
        if id(node) in self._sizes:
            known = self._sizes[id(node)]
            if known is None:
                raise LimitError(problem="an alias stands for itself", problem_mark=node.start_mark)
            self._repeated += known
            if self._repeated > MOST_REPEATED:
                message = f"aliases repeat more than {MOST_REPEATED} values"
                raise LimitError(problem=message, problem_mark=node.start_mark)
            return known
        if depth > DEEPEST:
            message = "nested too deeply; flatten it"
            raise LimitError(problem=message, problem_mark=node.start_mark)
        self._sizes[id(node)] = None
        total = 1 + sum(self.size(part, depth + 1) for part in _parts(node))
        self._sizes[id(node)] = total
        return total


def _parts(node: yaml.Node) -> list[yaml.Node]:
    if isinstance(node, yaml.SequenceNode):
        return list(node.value)
    if isinstance(node, yaml.MappingNode):
        return [part for pair in node.value for part in pair]
    return []
