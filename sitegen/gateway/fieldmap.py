"""The fields of a message of rowe, and those of the ROS message that it stands for."""

from __future__ import annotations

import math
from collections.abc import Mapping
from copy import deepcopy
from dataclasses import dataclass, field
from typing import Any

# Units of programs: what 1 of them is in the unit of ROS (REP 103).
UNITS: Mapping[str, float] = {
    "mm": 1e-3,
    "cm": 1e-2,
    "km": 1e3,
    "mm/s": 1e-3,
    "cm/s": 1e-2,
    "km/h": 1 / 3.6,
    "deg": math.pi / 180,
    "deg/s": math.pi / 180,
    "rpm": 2 * math.pi / 60,
    "g": 1e-3,
    "ms": 1e-3,
    "us": 1e-6,
    "percent": 1e-2,
}


class FieldError(ValueError):
    """A message does not have the fields that gateway.yaml says."""


@dataclass(frozen=True)
class FieldMap:
    """Which fields go where. Fields that it does not name keep their name."""

    # By the name in rowe: the path in ROS, such as linear.x.
    fields: Mapping[str, str] = field(default_factory=dict)
    # By the path in ROS: what a message has that does not say otherwise.
    defaults: Mapping[str, Any] = field(default_factory=dict)
    # By the name in rowe: what a number is multiplied by for ROS.
    units: Mapping[str, float] = field(default_factory=dict)

    def to_ros(self, body: Mapping[str, Any]) -> dict[str, Any]:
        """Return the fields of the ROS message. Raises: FieldError."""
        found: dict[str, Any] = {}
        for name, value in body.items():
            _put(found, self.fields.get(name, name), self._times(name, value, 1), name)
        for path, value in self.defaults.items():
            if _get(found, path) is None:
                _put(found, path, deepcopy(value), path)
        return found

    def to_program(self, message: Mapping[str, Any]) -> dict[str, Any]:
        """Return the fields of the message of rowe."""
        if not self.fields and not self.units:
            return dict(message)
        rest = deepcopy(dict(message))
        found = {}
        for name, path in self.fields.items():
            value = _take(rest, path)
            if value is not None:
                found[name] = value
        found = {**rest, **found}
        return {name: self._times(name, value, -1) for name, value in found.items()}

    def _times(self, name: str, value: Any, power: int) -> Any:
        if name not in self.units:
            return value
        if isinstance(value, list):
            return [self._times(name, each, power) for each in value]
        if isinstance(value, bool) or not isinstance(value, int | float):
            if power < 0:
                # A number that JSON does not have, such as NaN, is null.
                return value
            raise FieldError(f"{name}: must be a number")
        try:
            return value * self.units[name] ** power
        except OverflowError:
            raise FieldError(f"{name}: the number is too large") from None


def _put(found: dict[str, Any], path: str, value: Any, name: str) -> None:
    *folders, last = path.split(".")
    for folder in folders:
        inner = found.setdefault(folder, {})
        if not isinstance(inner, dict):
            raise FieldError(f"{name}: '{folder}' has a value of its own")
        # The message that was given stays as it is.
        found[folder] = dict(inner)
        found = found[folder]
    found[last] = value


def _get(found: Mapping[str, Any], path: str) -> Any:
    value: Any = found
    for part in path.split("."):
        value = value.get(part) if isinstance(value, Mapping) else None
    return value


def _take(message: dict[str, Any], path: str) -> Any:
    """Remove a field, and what contains nothing but it."""
    first, _, rest = path.partition(".")
    if not rest:
        return message.pop(first, None)
    inner = message.get(first)
    if not isinstance(inner, dict):
        return None
    value = _take(inner, rest)
    if not inner:
        del message[first]
    return value
