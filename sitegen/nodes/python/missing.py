"""Report the modules that Python programs import and that pages lack, each of them once."""

from __future__ import annotations

from collections.abc import Mapping

# Where a program imports a module that its page lacks, by the message about the module.
Missing = Mapping[str, str]


def message(module: str, why: str) -> str:
    """Return the message about a module that a program imports."""
    return f"import {module}: {why}"


def lines(programs: Mapping[str, Missing]) -> list[str]:
    """Return a line for each module that `programs` lack, with the names of these programs."""
    places: dict[str, str] = {}
    names: dict[str, list[str]] = {}
    for name, missing in programs.items():
        for message, place in missing.items():
            places.setdefault(message, place)
            names.setdefault(message, []).append(name)
    return [
        f"{place}: {message} (left out: {', '.join(names[message])})"
        for message, place in places.items()
    ]
