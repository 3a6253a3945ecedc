"""Read parameter files of ROS."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import yaml

from sitegen import yamlnodes
from sitegen.rclyaml import EVERYWHERE, Overrides, ParameterError, matches, written

OPTION = "--params-file"


def add(overrides: Overrides, file: Path, expanded: Callable[[str], str] = str) -> None:
    """Add the parameters of `file` to `overrides`; `expanded` may change the text before.

    Raises: ValueError if the file cannot be read.
    """
    try:
        overrides.file(yamlnodes.events(expanded(text(file))))
    except ParameterError as error:
        raise ValueError(f"'{file.name}' (line {error.line}): {error}") from None
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        line = f" (line {mark.line + 1})" if mark else ""
        what = getattr(error, "problem", None) or str(error)
        raise ValueError(f"'{file.name}' is not valid YAML{line}: {what}") from None


def text(file: Path) -> str:
    """Return the text of a parameter file.

    Raises: ValueError if it cannot be read.
    """
    try:
        return file.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise ValueError(f"'{file.name}' cannot be read: {error}") from None


def rules(overrides: Overrides, full_name: str = "") -> dict[str, str]:
    """Return parameters as the names and values of `-p name:=value`.

    They are those of the node `full_name`. If that is not known, a name begins with the pattern of
    the nodes that it is for, unless it is for all: `/arm/left:speed`.
    """
    if full_name:
        meant = (one for one in overrides if matches(one.pattern, full_name))
        return {one.name: written(one.value) for one in meant}
    return {
        name if pattern == EVERYWHERE else f"/{pattern.lstrip('/')}:{name}": written(value)
        for pattern, name, value in overrides
    }
