"""Take apart the types of fields as rclpy spells them: "sequence<double, 3>", "uint8[16]"."""

from __future__ import annotations

import re
from dataclasses import dataclass

_SEQUENCE = re.compile(r"sequence<(.+?)(?:, ?(\d+))?>")
_ARRAY = re.compile(r"(.+)\[(\d+)\]")
_BOUNDED = re.compile(r"(w?string)<\d+>")

INTEGERS = {
    "int8": (72, "b"),
    "uint8": (64, "B"),
    "char": (64, "B"),
    "int16": (77, "h"),
    "uint16": (69, "H"),
    "int32": (78, "i"),
    "uint32": (70, "I"),
    "int64": (79, "q"),
    "uint64": (71, "Q"),
}
FLOATS = {"float": (85, "f"), "double": (86, "d"), "float32": (85, "f"), "float64": (86, "d")}
# By name: the tag of typed arrays in CBOR (RFC 8746, little endian), and the code of `array`.
NUMBERS = {**INTEGERS, **FLOATS}
STRINGS = ("string", "wstring")


@dataclass(frozen=True)
class FieldType:
    """The type of one field; `many` says that it is an array or a sequence, `size` of how many."""

    name: str
    many: bool = False
    size: int | None = None

    @property
    def message(self) -> str:
        """The full name of the message type, "" for a primitive type."""
        package, slash, short = self.name.partition("/")
        return f"{package}/msg/{short}" if slash else ""

    @property
    def binary(self) -> bool:
        """Whether it is an array of bytes, which JSON has as base64."""
        return self.many and self.name in ("uint8", "char")


def parse(text: str) -> FieldType:
    """Return the type that rclpy calls `text`."""
    if match := _SEQUENCE.fullmatch(text):
        return FieldType(_element(match[1]), many=True)
    if match := _ARRAY.fullmatch(text):
        return FieldType(_element(match[1]), many=True, size=int(match[2]))
    return FieldType(_element(text))


def _element(text: str) -> str:
    match = _BOUNDED.fullmatch(text)
    return match[1] if match else text
