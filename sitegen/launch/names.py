"""The names of nodes in namespaces, and on pages."""

from __future__ import annotations


def joined(above: str, name: str) -> str:
    """Return `namespace` below another one; an absolute namespace stays as it is."""
    if not name:
        return above
    return (name if name.startswith("/") else f"{above}/{name}").rstrip("/")


def numbered(name: str, number: int) -> str:
    """Return the name on the page of the node that is the `number`-th of this name."""
    return name if number == 1 else f"{name}_{number}"
