"""Provide the type support that generated message classes import: only a name.

rclpy checks that a class has one; rclpy_backend.cdr reads and writes the messages.
"""

from __future__ import annotations


class _TypeSupport:
    def __init__(self, package: str) -> None:
        self._package = package

    def __getattr__(self, name: str) -> str:
        return f"{self._package}.{name}"


def import_type_support(pkg_name: str) -> _TypeSupport:
    """Return an object that has any attribute that the classes of a package ask for."""
    return _TypeSupport(pkg_name)
