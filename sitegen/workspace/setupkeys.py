"""Check the values that a package gives to setuptools."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import PurePosixPath
from typing import Any


def _names(value: Any) -> bool:
    return isinstance(value, list | tuple) and all(isinstance(each, str) for each in value)


def _paths(value: Any) -> bool:
    return _names(value) and not any(_leaves(each) for each in value)


def _leaves(path: str) -> bool:
    return "\0" in path or PurePosixPath(path).is_absolute() or not path


def _mapping(value: Any, fits: Callable[[Any], bool]) -> bool:
    return isinstance(value, Mapping) and all(
        isinstance(key, str) and fits(each) for key, each in value.items()
    )


def _folders(value: Any) -> bool:
    return _mapping(value, lambda each: isinstance(each, str) and "\0" not in each)


def _data_files(value: Any) -> bool:
    return isinstance(value, list | tuple) and all(
        isinstance(each, list | tuple)
        and len(each) == 2
        and isinstance(each[0], str)
        # Absolute paths are installed elsewhere, and left out.
        and _names(each[1])
        and not any("\0" in name for name in (each[0], *each[1]))
        for each in value
    )


def _entry_points(value: Any) -> bool:
    if isinstance(value, str):
        return True
    return _mapping(value, lambda each: isinstance(each, str | Mapping) or _names(each))


# By key: whether a value fits, and what it should be.
KEYS: dict[str, tuple[Callable[[Any], bool], str]] = {
    "packages": (_names, "a list of names"),
    "py_modules": (_names, "a list of names"),
    "scripts": (_paths, "a list of relative paths"),
    "package_dir": (_folders, "a mapping of packages to folders"),
    "package_data": (
        lambda value: _mapping(value, _paths),
        "a mapping of packages to lists of relative paths",
    ),
    "exclude_package_data": (
        lambda value: _mapping(value, _paths),
        "a mapping of packages to lists of relative paths",
    ),
    "data_files": (_data_files, "a list of pairs: a folder, and a list of paths"),
    "entry_points": (_entry_points, "a mapping of groups to lists of 'name = module:function'"),
}


def fault(name: str, value: Any) -> str:
    """Return why `value` is not valid for the key `name`, or nothing; None stands for no value."""
    fits, wanted = KEYS.get(name, (lambda _: True, ""))
    return "" if value is None or fits(value) else f"{name}: expected {wanted}"
