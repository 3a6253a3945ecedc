"""Turn what clients send into messages of rclpy."""

from __future__ import annotations

import array
import binascii
import math
import time
from base64 import b64decode
from collections.abc import Callable, Hashable
from functools import cache
from typing import Any

from cbor2 import CBORTag

from sitegen.gateway.fieldtypes import FLOATS, INTEGERS, NUMBERS, STRINGS, parse
from sitegen.gateway.fieldtypes import FieldType as Type
from sitegen.gateway.native import NativeError, load_type

Decoder = Callable[[Any, str], Any]
CODES = {tag: code for tag, code in NUMBERS.values()}
# ROS 1 calls the fields of times "secs" and "nsecs".
TIMES = {"sec": ("sec", "secs"), "nanosec": ("nanosec", "nsecs")}


class InvalidValueError(NativeError):
    """A value does not fit its field; the text names both."""


def from_json(values: Any, kind: Any, where: str = "") -> Any:
    """Return a message of class `kind` with `values`; what they leave out has its default.

    Raises: InvalidValueError for unknown fields and values of other types.
    """
    if not isinstance(values, dict):
        if values is None or values == []:
            values = {}
        else:
            raise _wrong(where, "an object", values)
    slots = _slots(kind)
    message = kind()
    for name, value in values.items():
        slot = slots.get(name)
        place = f"{where}.{name}" if where else str(name)
        if slot is None:
            if name == "seq" and kind.__name__ == "Header":
                continue  # what ROS 1 has besides
            raise InvalidValueError(f"{kind.__name__} has no field '{place[:100]}'")
        try:
            setattr(message, name, slot(value, place))
        except (AssertionError, TypeError, ValueError, OverflowError):
            raise InvalidValueError(f"{place}: {_shown(value)} does not fit") from None
    if "stamp" in slots and kind.__name__ == "Header" and "stamp" not in values:
        message.stamp = now(type(message.stamp))
    elif "header" in slots and "header" not in values and "stamp" in _slots(_class(message.header)):
        message.header.stamp = now(type(message.header.stamp))
    return message


def now(kind: Any) -> Any:
    """Return this moment as a builtin_interfaces/Time."""
    nanoseconds = time.time_ns()
    return kind(sec=nanoseconds // 10**9, nanosec=nanoseconds % 10**9)


def _class(message: Any) -> Any:
    return type(message)


@cache
def _slots(kind: Hashable) -> dict[str, Decoder]:
    fields: dict[str, str] = kind.get_fields_and_field_types()  # type: ignore[attr-defined]
    return {name: _decoder(parse(text)) for name, text in fields.items()}


def _decoder(field: Type) -> Decoder:
    one = _single(field)
    if not field.many:
        return one
    code = NUMBERS[field.name][1] if field.name in NUMBERS else ""

    def many(value: Any, where: str) -> Any:
        items = _items(value, field, where)
        if field.size is not None and len(items) != field.size:
            raise InvalidValueError(f"{where}: expected {field.size} values, found {len(items)}")
        if code:
            return _packed(items, code, where)
        return [one(item, f"{where}[{i}]") for i, item in enumerate(items)]

    return many


def _items(value: Any, field: Type, where: str) -> Any:
    if field.binary and isinstance(value, str):
        try:
            return b64decode(value, validate=True)
        except binascii.Error:
            raise InvalidValueError(f"{where}: not base64") from None
    if isinstance(value, CBORTag) and value.tag in CODES and isinstance(value.value, bytes):
        typed = array.array(CODES[value.tag])
        try:
            typed.frombytes(value.value)
        except ValueError:
            raise InvalidValueError(f"{where}: an array that ends within a number") from None
        return typed
    if isinstance(value, list | tuple) or (isinstance(value, bytes) and field.binary):
        return value
    raise _wrong(where, "a list", value)


def _packed(items: Any, code: str, where: str) -> Any:
    if isinstance(items, array.array) and items.typecode == code:
        return items
    if code in "fd" and isinstance(items, list | tuple):
        items = [math.nan if item is None else item for item in items]
    if isinstance(items, list | tuple) and bool in {type(item) for item in items}:
        raise InvalidValueError(f"{where}: expected numbers, found a truth value")
    try:
        return array.array(code, items)
    except (TypeError, ValueError, OverflowError):
        raise InvalidValueError(f"{where}: expected a list of numbers that fit") from None


def _single(field: Type) -> Decoder:
    if field.message in ("builtin_interfaces/msg/Time", "builtin_interfaces/msg/Duration"):
        return lambda value, where: _time(value, field.message, where)
    if field.message:
        return lambda value, where: from_json(value, load_type(field.message), where)
    return {
        **dict.fromkeys(INTEGERS, _integer),
        **dict.fromkeys(FLOATS, _float),
        **dict.fromkeys(STRINGS, _string),
        "boolean": _flag,
        "bool": _flag,
        "octet": lambda value, where: bytes([_integer(value, where)]),
    }[field.name]


def _time(value: Any, name: str, where: str) -> Any:
    kind = load_type(name)
    if value == "now" and name.endswith("Time"):
        return now(kind)
    if not isinstance(value, dict):
        raise _wrong(where, "an object with 'sec' and 'nanosec'", value)
    found = kind()
    for field, names in TIMES.items():
        for each in names:
            if each in value:
                setattr(found, field, _integer(value[each], f"{where}.{each}"))
    return found


def _integer(value: Any, where: str) -> int:
    if isinstance(value, float) and value.is_integer():
        return int(value)
    if not isinstance(value, int) or isinstance(value, bool):
        raise _wrong(where, "a whole number", value)
    return value


def _float(value: Any, where: str) -> float:
    if value is None:
        return math.nan
    if not isinstance(value, int | float) or isinstance(value, bool):
        raise _wrong(where, "a number", value)
    return float(value)


def _string(value: Any, where: str) -> str:
    if not isinstance(value, str):
        raise _wrong(where, "text", value)
    return value


def _flag(value: Any, where: str) -> bool:
    if not isinstance(value, bool):
        raise _wrong(where, "true or false", value)
    return value


def _wrong(where: str, expected: str, value: Any) -> InvalidValueError:
    return InvalidValueError(f"{where or 'message'}: expected {expected}, found {_shown(value)}")


def _shown(value: Any) -> str:
    if isinstance(value, dict | list):
        return "an object" if isinstance(value, dict) else "a list"
    text = str(value)[:41]
    return f"'{text[:40]}…'" if len(text) > 40 else f"'{text}'"
