"""Read a YAML launch file."""

from __future__ import annotations

from pathlib import Path

import yaml

from sitegen.errors import Location
from sitegen.launch.substitutions import unescaped
from sitegen.launch.tree import Action, Exact, Given, UnreadableError
from sitegen.yamlnodes import compose

# Keys of actions that hold a list of what are nested actions in XML.
PARTS = {"param", "remap", "env", "arg", "let", "composable_node", "extra_arg", "keep", "choice"}


def read(file: Path) -> list[Action]:
    """Return the actions of a launch file.

    Raises: UnreadableError if the file is not valid.
    """
    try:
        root = compose(file.read_text(encoding="utf-8-sig"))
    except (yaml.YAMLError, ValueError) as error:
        line = getattr(getattr(error, "problem_mark", None), "line", 0) + 1
        message = getattr(error, "problem", None) or str(error)
        raise UnreadableError(Location(file, line), message) from None
    top = _pairs(file, root) if isinstance(root, yaml.MappingNode) else {}
    if list(top) != ["launch"]:
        raise UnreadableError(
            Location(file, 1), "expected one key, 'launch', with a list of actions"
        )
    return _actions(file, top["launch"])


def _actions(file: Path, node: yaml.Node) -> list[Action]:
    found = []
    for item in _items(file, node):
        pairs = _pairs(file, item)
        if len(pairs) != 1:
            raise UnreadableError(_location(file, item), "expected one action, like 'node:'")
        [(kind, value)] = pairs.items()
        found.append(_action(file, kind, value))
    return found


def _action(file: Path, kind: str, node: yaml.Node) -> Action:
    kind, location = kind.replace("-", "_"), _location(file, node)
    if kind == "group" and isinstance(node, yaml.SequenceNode):
        return Action(kind, {}, location, _actions(file, node))
    attributes: dict[str, str] = {}
    inside: list[Action] = []
    given = None
    for name, value in _pairs(file, node).items():
        if kind == "param" and name == "value":
            given = _given(file, value)
        elif isinstance(value, yaml.ScalarNode):
            attributes[name.replace("-", "_")] = value.value
        elif name in PARTS:
            inside += [_action(file, name, item) for item in _items(file, value)]
        elif kind == "group" or name == "children":
            inside += _actions(file, value)
        else:
            raise UnreadableError(_location(file, value), f"'{name}' of '{kind}' must be a string")
    if attributes.get("type", "").startswith("list_of_") and not isinstance(given, list):
        raise UnreadableError(
            location, f"'value' is not a list, but of type '{attributes['type']}'"
        )
    return Action(kind, attributes, location, inside, given)


def _given(file: Path, node: yaml.Node) -> Given:
    """Return the value of a parameter, which has the type that YAML 1.1 gives it."""
    if isinstance(node, yaml.SequenceNode):
        return [_given(file, item) for item in node.value]
    value = yaml.SafeLoader("").construct_document(node)
    if not isinstance(value, (bool, int, float, str)):
        message = "expected a boolean, a number, a string or a list of these"
        raise UnreadableError(_location(file, node), message)
    if isinstance(value, str) and "$(" not in value:
        return Exact(unescaped(value))
    return value


def _items(file: Path, node: yaml.Node) -> list[yaml.Node]:
    if not isinstance(node, yaml.SequenceNode):
        raise UnreadableError(_location(file, node), "expected a list")
    return list(node.value)


def _pairs(file: Path, node: yaml.Node) -> dict[str, yaml.Node]:
    if not isinstance(node, yaml.MappingNode):
        raise UnreadableError(_location(file, node), "expected keys and values")
    return {str(key.value): value for key, value in node.value}


def _location(file: Path, node: yaml.Node) -> Location:
    return Location(file, node.start_mark.line + 1)
