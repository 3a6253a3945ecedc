"""Turn messages of rclpy into what JSON and CBOR have."""

from __future__ import annotations

import array
import math
import sys
from base64 import b64encode
from collections.abc import Callable, Hashable
from functools import cache
from typing import Any

from cbor2 import CBORTag

from sitegen.gateway.fieldtypes import FLOATS, INTEGERS, NUMBERS, FieldType, parse
from sitegen.gateway.native import load_type

Encoder = Callable[[Any], Any]


def to_json(message: Any) -> dict[str, Any]:
    """Return a message as JSON has it: bytes as base64, and null for what is no finite number."""
    kind: Any = type(message)
    found: dict[str, Any] = _fields(kind, False)(message)
    return found


def to_cbor(message: Any) -> dict[str, Any]:
    """Return a message as CBOR has it: bytes as such, and arrays of numbers as typed arrays."""
    kind: Any = type(message)
    found: dict[str, Any] = _fields(kind, True)(message)
    return found


@cache
def _fields(kind: Hashable, cbor: bool) -> Encoder:
    fields: dict[str, str] = kind.get_fields_and_field_types()  # type: ignore[attr-defined]
    encoders = [(name, _encoder(parse(text), cbor)) for name, text in fields.items()]

    def encode(message: Any) -> dict[str, Any]:
        return {name: encoder(getattr(message, name)) for name, encoder in encoders}

    return encode


def _encoder(field: FieldType, cbor: bool) -> Encoder:
    if field.binary:
        return bytes if cbor else lambda value: b64encode(bytes(value)).decode()
    if field.many and field.name in NUMBERS and cbor:
        return _typed(*NUMBERS[field.name])
    one = _single(field, cbor)
    if not field.many:
        return one
    if field.name in INTEGERS:
        return lambda values: values.tolist() if hasattr(values, "tolist") else list(values)
    if field.name in FLOATS:
        # Most arrays have finite numbers only.
        return lambda values: _finite(
            values.tolist() if hasattr(values, "tolist") else list(values)
        )
    return lambda values: [one(value) for value in values]


def _single(field: FieldType, cbor: bool) -> Encoder:
    if field.message:
        # The class is loaded when it is needed: importing a package loads all of it.
        def nested(value: Any) -> Any:
            kind: Any = type(value)
            return _fields(kind, cbor)(value)

        return nested
    if field.name in FLOATS and not cbor:
        return lambda value: value if math.isfinite(value) else None
    if field.name == "octet":
        return lambda value: value[0]
    return _same


def _same(value: Any) -> Any:
    return value


def _finite(values: list[float]) -> list[float | None]:
    if all(map(math.isfinite, values)):
        return list(values)
    return [value if math.isfinite(value) else None for value in values]


def _typed(tag: int, code: str) -> Encoder:
    def encode(values: Any) -> CBORTag:
        packed = values if isinstance(values, array.array) else array.array(code, values)
        if sys.byteorder == "big":
            packed = array.array(packed.typecode, packed)
            packed.byteswap()
        return CBORTag(tag, packed.tobytes())

    return encode


def empty(type_name: str) -> dict[str, Any]:
    """Return a message of this type with its defaults."""
    return to_json(load_type(type_name)())
