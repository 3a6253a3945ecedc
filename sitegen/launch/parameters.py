"""The parameters that launch files give to nodes, with the types that launch_ros gives them."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import yaml

from sitegen import yamlnodes
from sitegen.errors import nearest
from sitegen.launch.substitutions import unescaped
from sitegen.launch.tree import Action, Exact, Given
from sitegen.launch.types import ANY, LISTS, SCALARS, is_of, typed
from sitegen.rclyaml import EVERYWHERE, NAMES, Overrides, Scalar, Value, scalar, written
from sitegen.workspace import parameterfiles

# Expands the substitutions of a text.
Expand = Callable[[str], str]

# The parameters that all nodes have which come after them: names with values, and files.
Everyones = Iterable[tuple[str, Value] | Path]


class Parameters:
    """Reads the parameters of actions.

    `expand_file` expands the text of a parameter file; `find` returns the file of a name.
    """

    def __init__(self, expand: Expand, expand_file: Expand, find: Callable[[str], Path]) -> None:
        self._expand = expand
        self._expand_file = expand_file
        self._find = find

    def of_node(self, action: Action, everyones: Everyones, full_name: str) -> dict[str, str]:
        """Return the rules `-p name:=value` of a node; `full_name` is empty if it is not known.

        Raises: ValueError if a parameter is not valid.
        """
        found = Overrides()
        for one in everyones:
            if isinstance(one, Path):
                parameterfiles.add(found, one)
            else:
                # launch_ros writes a list as Python does, which ROS reads as a string.
                given = tuple(one[1]) if isinstance(one[1], list) else one[1]
                found.add(one[0], str(given))
        for each in action.of_kind("param", "parameter"):
            if "from" in each.attributes:
                parameterfiles.add(found, self._file(each), self._expansion(each))
            else:
                for name, value in self._values(each, ""):
                    found.set(name, _dumped(value), full_name or EVERYWHERE)
        return parameterfiles.rules(found, full_name)

    def of_component(self, action: Action, everyones: Everyones, full_name: str) -> dict[str, str]:
        """Return those of a component, which gets values with their types, not a command line.

        Raises: ValueError if a parameter is not valid.
        """
        found: dict[str, Value] = {}
        for one in everyones:
            if isinstance(one, Path):
                found |= _of_file(parameterfiles.text(one), full_name)
            else:
                found[one[0]] = one[1]
        for each in action.of_kind("param", "parameter"):
            if "from" in each.attributes:
                text = self._expansion(each)(parameterfiles.text(self._file(each)))
                found |= _of_file(text, full_name)
            else:
                found |= self._values(each, "")
        return {name: written(value) for name, value in found.items()}

    def value(self, action: Action) -> Any:
        """Return the value of `set_parameter`, or of a mapping in a Python file."""
        given = action.value if action.value is not None else action.attributes.get("value", "")
        return _of_mapping(given, self._expand)

    def _file(self, action: Action) -> Path:
        return self._find(self._expand(action.attributes["from"]))

    def _expansion(self, action: Action) -> Expand:
        """Return what is done to the text of a parameter file."""
        wanted = self._expand(action.attributes.get("allow_substs", ""))
        return self._expand_file if wanted and typed(wanted, "bool") else str

    def _values(self, action: Action, above: str) -> Iterable[tuple[str, Value]]:
        """Yield the parameters of an action, those of nested ones with dotted names."""
        if "name" not in action.attributes:
            raise ValueError("'name' is missing")
        name = f"{above}{self._expand(action.attributes['name'])}"
        if action.kind == "parameter":
            yield name, self.value(action)
        elif action.value is not None or "value" in action.attributes:
            yield name, self._of_entity(action)
        else:
            for inner in action.of_kind("param"):
                yield from self._values(inner, f"{name}.")

    def _of_entity(self, action: Action) -> Any:
        """Return the value of `param`, or of ParameterValue in a Python file."""
        named = action.attributes.get("type", ANY)
        if named not in {**SCALARS, **LISTS, ANY: None}:
            advice = nearest(named, [*SCALARS, *LISTS, ANY])
            raise ValueError(f"'{named}' is not a type of parameters; {advice}")
        given = action.value
        if given is None:
            given = _of_xml(action.attributes["value"], action.attributes.get("value_sep"), named)
        if not isinstance(given, list):
            return self._item(given, named)
        if named in SCALARS:
            raise ValueError(f"a list is not of type '{named}'")
        kind = named.removeprefix("list_of_") if named != ANY else ANY
        items = [self._item(item, kind) for item in given]
        if not is_of(items, named):
            raise ValueError("the values of a list must have the same type")
        return items

    def _item(self, given: Given, named: str) -> Any:
        if isinstance(given, str):
            expanded = self._expand(given)
            # The description of a robot is a string, even if it is valid YAML.
            kind = "str" if expanded.lstrip().startswith("<") and named == ANY else named
            return typed(expanded, kind)
        value = given.text if isinstance(given, Exact) else given
        if not is_of(value, named):
            raise ValueError(f"'{value}' is not of type '{named}'")
        return value


def _of_xml(text: str, separator: str | None, named: str) -> Given:
    """Return the value of an attribute: it has a type before its substitutions are expanded."""
    if separator:
        kind = named.removeprefix("list_of_")
        return [_exact(typed(part, kind, partly=True)) for part in text.split(separator)]
    value = typed(text, named, partly=True)
    return [_exact(item) for item in value] if isinstance(value, list) else _exact(value)


def _exact(value: Scalar) -> Given:
    if isinstance(value, str) and "$(" not in value:
        return Exact(unescaped(value))
    return value


def _of_mapping(given: Given, expand: Expand) -> Any:
    if isinstance(given, Exact):
        return given.text
    if isinstance(given, str):
        text = expand(given)
        is_description = text.lstrip().startswith("<")
        given = text if is_description or not text else typed(text, ANY, partly=True)
    elif isinstance(given, list):
        given = [_of_mapping(item, expand) for item in given]
    if isinstance(given, list) and not all(isinstance(item, type(given[0])) for item in given):
        raise ValueError("the values of a list must have the same type")
    if given == []:
        raise ValueError("an empty list has no type")
    return given


def _dumped(value: Value) -> Value:
    """Return what a node reads of a value that launch_ros has written to a file.

    PyYAML writes some strings without quotes that ROS takes for numbers, such as 1e3.
    """
    if isinstance(value, list):
        items = [_dumped_scalar(item) for item in value]
        kinds = sorted({NAMES[type(item)] for item in items})
        if len(kinds) > 1:
            raise ValueError(f"ROS reads the values of the list as {' and '.join(kinds)}")
        return items or None
    return None if value is None else _dumped_scalar(value)


def _dumped_scalar(value: Scalar) -> Scalar:
    text = value if isinstance(value, str) else str(value)
    if isinstance(value, (bool, float)) or isinstance(scalar(text), str):
        return value
    is_plain = not yaml.safe_dump(text).startswith(("'", '"'))
    return scalar(text) if is_plain or isinstance(value, int) else value


def _of_file(text: str, full_name: str) -> Iterable[tuple[str, Value]]:
    """Yield the parameters of a file for a component, which launch_ros itself reads."""
    try:
        data = yamlnodes.load(text)
    except yaml.YAMLError as error:
        raise ValueError(f"the parameter file is not valid YAML: {error}") from None
    sections = dict(_sections("", data if isinstance(data, dict) else {}))
    for name in ("**", full_name.lstrip("/")):
        yield from _flat("", sections.get(name) or {})


def _sections(above: str, part: dict[Any, Any]) -> Iterable[tuple[str, Any]]:
    for key, value in part.items():
        if key == "ros__parameters":
            yield above, value
        elif isinstance(value, dict):
            name = str(key).lstrip("/")
            yield from _sections(f"{above}/{name}" if above else name, value)


def _flat(above: str, values: dict[Any, Any]) -> Iterable[tuple[str, Value]]:
    for name, value in values.items():
        if isinstance(value, dict):
            yield from _flat(f"{above}{name}.", value)
        elif isinstance(value, (bool, int, float, str, list)):
            yield f"{above}{name}", value
        else:
            raise ValueError(f"'{above}{name}' in the parameter file has no valid value")
