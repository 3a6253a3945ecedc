"""Read and write messages as native ROS 2 does: XCDR1, little-endian, behind four bytes of header.

How a class is read and written is worked out once, from the types of its slots.
"""

from __future__ import annotations

import array
import importlib
import re
import struct
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

from rosidl_parser import definition

from rclpy_backend.arrays import fixed_array

HEADER = b"\x00\x01\x00\x00"
PADS = [bytes(size) for size in range(8)]
LENGTH = struct.Struct("<I")
# How struct and array write numbers.
CODES = {
    **{"boolean": "?", "octet": "B", "char": "B", "wchar": "H", "float": "f", "double": "d"},
    **{"int8": "b", "uint8": "B", "int16": "h", "uint16": "H"},
    **{"int32": "i", "uint32": "I", "int64": "q", "uint64": "Q"},
}
# Sequences of these are arrays of numbers in Python, all others are lists.
NUMBERS = set(CODES) - {"boolean", "octet", "char", "wchar"}

Write = Callable[[bytearray, Any], None]
Read = Callable[["Input"], Any]


class CdrError(Exception):
    """These bytes are no message of that type."""


class Input:
    """The bytes of a message, and how far they are read."""

    __slots__ = ("at", "data")

    def __init__(self, data: bytes) -> None:
        self.data = memoryview(data)[len(HEADER) :]
        self.at = 0

    def take(self, size: int, alignment: int = 1) -> int:
        """Return where the next `size` bytes begin, and go behind them."""
        begin = self.at + -self.at % alignment
        self.at = begin + size
        if self.at > len(self.data):
            raise CdrError("it ends too early")
        return begin

    def length(self, smallest: int) -> int:
        """Return the length of what follows, whose elements have at least `smallest` bytes."""
        begin = self.take(4, 4)
        count: int = LENGTH.unpack_from(self.data, begin)[0]
        if count * smallest > len(self.data) - self.at:
            raise CdrError("it ends too early")
        return count


class Codec(NamedTuple):
    """How values of a type are written and read; `smallest` is what one takes at least."""

    write: Write
    read: Read
    smallest: int = 1


def serialize(message: Any, message_type: type) -> bytes:
    """Return the bytes of a message; raises a TypeError if it is of another type."""
    if not isinstance(message, message_type):
        raise TypeError(f"Expected {message_type}, got {type(message)}")
    output = bytearray()
    codec_of(message_type).write(output, message)
    return HEADER + output


def deserialize(data: bytes, message_type: type) -> Any:
    """Return the message; raises a CdrError if `data` is none of that type."""
    if bytes(data[:2]) != HEADER[:2]:
        raise CdrError("its encoding is not CDR, little-endian")
    return codec_of(message_type).read(Input(data))


def rclpy_serialize(pymsg: Any, py_msg_type: type) -> bytes:
    """Return the bytes of a message."""
    return serialize(pymsg, py_msg_type)


def rclpy_deserialize(pybuffer: bytes, pymsg_type: type) -> Any:
    """Return the message that the bytes are."""
    return deserialize(pybuffer, pymsg_type)


@cache
def codec_of(message_type: Any) -> Codec:
    """Return how messages of a generated class are written and read."""
    names = [f"_{name}" for name in message_type._fields_and_field_types]
    codecs = [_codec(slot) for slot in message_type.SLOT_TYPES]
    writes = [(name, codec.write) for name, codec in zip(names, codecs, strict=True)]
    reads = [(name, codec.read) for name, codec in zip(names, codecs, strict=True)]

    def write(output: bytearray, message: Any) -> None:
        if not isinstance(message, message_type):
            raise TypeError(f"Expected {message_type}, got {type(message)}")
        for name, put in writes:
            put(output, getattr(message, name))
        if not writes:
            output.append(0)  # IDL has no empty messages

    def read(source: Input) -> Any:
        # Its own __init__ would make and check all fields, only to replace them.
        message = message_type.__new__(message_type)
        message._check_fields = False
        for name, get in reads:
            setattr(message, name, get(source))
        if not reads:
            source.take(1)
        return message

    return Codec(write, read)


def _codec(slot: Any) -> Codec:
    if isinstance(slot, definition.BasicType):
        return _octet() if slot.typename == "octet" else _number(CODES[slot.typename])
    if isinstance(slot, definition.AbstractWString):
        return _wide_text(getattr(slot, "maximum_size", None))
    if isinstance(slot, definition.AbstractString):
        return _text(getattr(slot, "maximum_size", None))
    if isinstance(slot, definition.NamespacedType):
        return _nested(slot)
    fixed = slot.size if isinstance(slot, definition.Array) else None
    bound = getattr(slot, "maximum_size", None)
    element = slot.value_type
    if isinstance(element, definition.BasicType) and element.typename in NUMBERS:
        return _numbers(CODES[element.typename], element.typename, fixed, bound)
    return _elements(_codec(element), fixed, bound)


def _number(code: str) -> Codec:
    form = struct.Struct(f"<{code}")
    size, pack, unpack = form.size, form.pack, form.unpack_from

    def write(output: bytearray, value: Any) -> None:
        output += PADS[-len(output) % size]
        output += pack(value)

    def read(source: Input) -> Any:
        return unpack(source.data, source.take(size, size))[0]

    return Codec(write, read, size)


def _octet() -> Codec:
    def write(output: bytearray, value: bytes) -> None:
        output += value

    def read(source: Input) -> bytes:
        begin = source.take(1)
        return bytes(source.data[begin : begin + 1])

    return Codec(write, read)


def _check(length: int, bound: int | None, what: str) -> None:
    if bound is not None and length > bound:
        raise ValueError(f"{what} of {length} where its type allows {bound}")


def _put_length(output: bytearray, length: int) -> None:
    output += PADS[-len(output) % 4]
    output += LENGTH.pack(length)


def _text(bound: int | None) -> Codec:
    def write(output: bytearray, value: str) -> None:
        if not isinstance(value, str):
            raise TypeError(f"Expected <class 'str'>, got {type(value)}")
        text = value.encode()
        _check(len(text), bound, "a text")
        _put_length(output, len(text) + 1)
        output += text
        output.append(0)

    def read(source: Input) -> str:
        length = source.length(1)
        begin = source.take(length)
        text = bytes(source.data[begin : begin + length]).removesuffix(b"\0")
        if bound is not None and len(text) > bound:
            raise CdrError(f"a text of {len(text)} where its type allows {bound}")
        return text.decode(errors="replace")

    return Codec(write, read, 4)


def _wide_text(bound: int | None) -> Codec:
    """Return the codec of texts with four bytes for each unit of UTF-16."""

    def write(output: bytearray, value: str) -> None:
        units = array.array("H", value.encode("utf-16-le"))
        _check(len(units), bound, "a text")
        _put_length(output, len(units))
        output += struct.pack(f"<{len(units)}I", *units)

    def read(source: Input) -> str:
        length = source.length(4)
        if bound is not None and length > bound:
            raise CdrError(f"a text of {length} where its type allows {bound}")
        units = struct.unpack_from(f"<{length}I", source.data, source.take(4 * length))
        text = struct.pack(f"<{length}H", *(unit & 0xFFFF for unit in units))
        return text.decode("utf-16-le", errors="replace")

    return Codec(write, read, 4)


def _nested(slot: Any) -> Codec:
    # Looked up when it is needed: its module may be the one that is just being imported.
    @cache
    def codec() -> Codec:
        return codec_of(_class_of(slot))

    return Codec(
        lambda output, value: codec().write(output, value), lambda source: codec().read(source)
    )


def _class_of(slot: Any) -> Any:
    module = importlib.import_module(".".join(slot.namespaces))
    if hasattr(module, slot.name):
        return getattr(module, slot.name)
    # A part of a service or an action, which only the interface's own module names.
    words = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", slot.name.partition("_")[0])
    file = re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", words).lower()
    return getattr(importlib.import_module(f"{module.__name__}._{file}"), slot.name)


def _numbers(code: str, name: str, fixed: int | None, bound: int | None) -> Codec:
    size = struct.calcsize(f"<{code}")

    def write(output: bytearray, value: Any) -> None:
        if fixed is None:
            _check(len(value), bound, "a sequence")
            _put_length(output, len(value))
            if not len(value):
                return
        elif len(value) != fixed:
            raise ValueError(f"an array of {len(value)} where its type has {fixed}")
        output += PADS[-len(output) % size]
        if isinstance(value, array.array) and value.typecode == code:
            output += value.tobytes()
        else:
            output += struct.pack(f"<{len(value)}{code}", *value)

    def read(source: Input) -> Any:
        length = source.length(size) if fixed is None else fixed
        if bound is not None and length > bound:
            raise CdrError(f"a sequence of {length} where its type allows {bound}")
        begin = source.take(length * size, size) if length else 0
        numbers = array.array(code)
        numbers.frombytes(source.data[begin : begin + length * size])
        return numbers if fixed is None else fixed_array.array(numbers, fixed_array.named(name))

    return Codec(write, read, 4 if fixed is None else fixed * size)


def _elements(element: Codec, fixed: int | None, bound: int | None) -> Codec:
    def write(output: bytearray, value: Any) -> None:
        if fixed is None:
            _check(len(value), bound, "a sequence")
            _put_length(output, len(value))
        elif len(value) != fixed:
            raise ValueError(f"an array of {len(value)} where its type has {fixed}")
        for each in value:
            element.write(output, each)

    def read(source: Input) -> Any:
        length = source.length(element.smallest) if fixed is None else fixed
        if bound is not None and length > bound:
            raise CdrError(f"a sequence of {length} where its type allows {bound}")
        return [element.read(source) for _ in range(length)]

    return Codec(write, read, 4 if fixed is None else fixed * element.smallest)
