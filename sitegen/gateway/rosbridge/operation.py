"""Check the fields of operations."""

from __future__ import annotations

from typing import Any


class InvalidOperationError(Exception):
    """An operation lacks something, or may not be done; the text says what."""


def text(message: dict[str, Any], name: str, default: str | None = None) -> str:
    """Return a field that is text. Raises: InvalidOperationError if it is not."""
    value = message.get(name, default)
    if value is None and default is not None:
        return default
    if not isinstance(value, str):
        what = "needs" if value is None else "needs text as"
        raise InvalidOperationError(f"{message['op']}: {what} '{name}'")
    return value


def number(message: dict[str, Any], name: str, default: float = 0) -> float:
    """Return a field that is a number from 0. Raises: InvalidOperationError if it is not."""
    value = message.get(name)
    if value is None:
        return default
    if not isinstance(value, int | float) or isinstance(value, bool) or not 0 <= value < 2**53:
        raise InvalidOperationError(f"{message['op']}: '{name}' must be a number from 0")
    return value


def flag(message: dict[str, Any], name: str) -> bool:
    """Return whether a field is true."""
    return message.get(name) in (True, 1)


def graph_name(message: dict[str, Any], name: str) -> str:
    """Return a field that is the name of a topic, a service or an action, with "/" before it."""
    found = text(message, name)
    if not found.strip("/"):
        raise InvalidOperationError(f"{message['op']}: '{name}' is empty")
    return found if found.startswith("/") else f"/{found}"
