"""The names of nodes in namespaces, and on pages."""

from __future__ import annotations

from collections.abc import Collection


def joined(above: str, name: str) -> str:
    """Return `namespace` below another one; an absolute namespace stays as it is."""
    if not name:
        return above
    return (name if name.startswith("/") else f"{above}/{name}").rstrip("/")


def free(name: str, taken: Collection[str]) -> str:
    """Return the name on the page of a node: its own, or the first with a number that is free."""
    numbered = (f"{name}_{number}" for number in range(2, len(taken) + 3))
    return next(each for each in (name, *numbered) if each not in taken)
