"""The values over which the loops of launch files run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import yaml

from sitegen import yamlnodes
from sitegen.launch.scope import Scope
from sitegen.launch.texts import Texts
from sitegen.launch.tree import Action

SEPARATOR = ";"
# A page with more nodes would not be usable, and a build must end.
LONGEST = 1000


def rounds(action: Action, scope: Scope, texts: Texts) -> Sequence[Mapping[str, Any]]:
    """Return the variables of each round of `for` or `for_each`, with the types of YAML.

    Raises: ValueError if the values are not valid.
    """
    if action.kind == "for":
        return _counted(action, scope, texts)
    text = texts.needed(action, "values", scope)
    found = []
    for part in filter(None, text.strip().split(SEPARATOR)):
        try:
            values = yamlnodes.load(part.strip())
        except (yaml.YAMLError, ValueError):
            values = part
        if values is None:
            continue
        if not isinstance(values, dict):
            raise ValueError(f"'{part.strip()}' is not a mapping such as {{name: a, id: 1}}")
        found.append({str(name): value for name, value in values.items()})
    if len(found) > LONGEST:
        raise ValueError(f"'values' has {len(found)} sets of values, but may have {LONGEST}")
    return found


def _counted(action: Action, scope: Scope, texts: Texts) -> Sequence[Mapping[str, Any]]:
    text = texts.needed(action, "len", scope)
    try:
        length = int(text)
    except ValueError:
        raise ValueError(f"'len' is '{text}', but must be an integer") from None
    if length > LONGEST:
        raise ValueError(f"'len' is {length}, but may be {LONGEST} at most")
    # A function has a parameter of this name.
    name = "i" if "number" in action.attributes else texts.needed(action, "name", scope)
    return [{name: number} for number in range(length)]
