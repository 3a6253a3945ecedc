"""What message classes ask for their type support: here it is only a name.

rclpy wants to see that a class has one; messages are read and written by rclpy_backend.cdr.
"""

from __future__ import annotations


class _TypeSupport:
    def __init__(self, package: str) -> None:
        self._package = package

    def __getattr__(self, name: str) -> str:
        return f"{self._package}.{name}"


def import_type_support(pkg_name: str) -> _TypeSupport:
    """Return what has a value for each name that the classes of a package ask for."""
    return _TypeSupport(pkg_name)
