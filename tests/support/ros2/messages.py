"""Make messages with native ROS 2, and compare what became of them. Runs in the native environment.

`messages.py make SEED TYPE…` prints lines "type bytes"; `messages.py compare` reads lines
"type bytes bytes" and prints what differs between the two; `messages.py default TYPE…` prints
messages as their class makes them; `messages.py show` reads lines "type bytes" and prints repr() of
each message, as JSON.
"""

from __future__ import annotations

import importlib
import json
import random
import struct
import sys
from collections.abc import Iterator
from typing import Any

import numpy
from rclpy.serialization import deserialize_message, serialize_message
from rosidl_parser import definition

INTEGERS = {f"{sign}int{bits}": (sign, bits) for sign in ("", "u") for bits in (8, 16, 32, 64)}
FLOATS = {"float": "<If", "double": "<Qd"}
ALPHABETS = ("abc xyz~", "äß£ÿ", "€漢字ハ", "😀🤖𝄞", "a\né字😀")
LENGTHS = (0, 1, 2, 3, 5, 17)


def class_of(name: str) -> Any:
    """Return the class of `pkg/msg/Name`, also for a part of a service or an action."""
    package, kind, interface = name.split("/")
    module = importlib.import_module(f"{package}.{kind}")
    if hasattr(module, interface):
        return getattr(module, interface)
    # A class that its package does not export, as rosidl's Python names the parts of an action.
    name = interface.split("_")[0]
    own = importlib.import_module(f"{package}.{kind}._{snake(name)}")
    return getattr(own, interface)


def snake(name: str) -> str:
    """Return the module that defines the interface `name`."""
    return "".join(f"_{c.lower()}" if c.isupper() else c for c in name).lstrip("_")


class Values(random.Random):
    """Makes values for the fields of a message: everyday ones, and the limits of their types."""

    def message(self, kind: Any, depth: int = 0) -> Any:
        message = kind()
        for name, slot in zip(message.get_fields_and_field_types(), kind.SLOT_TYPES, strict=True):
            setattr(message, name, self.value(slot, depth))
        return message

    def value(self, slot: Any, depth: int) -> Any:
        if isinstance(slot, definition.BasicType):
            return self.basic(slot.typename)
        if isinstance(slot, definition.AbstractGenericString):
            return self.text(slot)
        if isinstance(slot, definition.NamespacedType):
            return self.message(class_of("/".join(slot.namespaced_name())), depth + 1)
        if isinstance(slot, definition.Array):
            return [self.value(slot.value_type, depth) for _ in range(slot.size)]
        bound = getattr(slot, "maximum_size", 1000)
        # Sequences of messages that hold sequences of messages grow fast.
        lengths = [n for n in LENGTHS[: max(1, len(LENGTHS) - 2 * depth)] if n <= bound]
        return [self.value(slot.value_type, depth + 1) for _ in range(self.choice(lengths))]

    def basic(self, name: str) -> Any:
        if name == "boolean":
            return self.random() < 0.5
        if name == "octet":
            return bytes([self.choice((0, 1, 127, 128, 255))])
        if name in FLOATS:
            whole, real = FLOATS[name][:2], f"<{FLOATS[name][2]}"
            bits = self.getrandbits(8 * struct.calcsize(whole))
            common = [0.0, -0.0, 1.5, float("inf"), float("-inf"), float("nan")]
            return self.choice([*common, struct.unpack(real, struct.pack(whole, bits))[0]])
        sign, bits = INTEGERS[name]
        low, high = (0, 2**bits - 1) if sign else (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1)
        return self.choice((low, low + 1, 0, 1, high - 1, high, self.randint(low, high)))

    def text(self, slot: Any) -> str:
        size = self.choice((0, 1, 3, 10, 4000 if self.random() < 0.05 else 20))
        letters = self.choices(self.choice(ALPHABETS), k=size)
        bound = getattr(slot, "maximum_size", None)
        while bound is not None and len("".join(letters).encode()) > bound:
            letters.pop()
        return "".join(letters)


def make(seed: int, names: list[str]) -> Iterator[str]:
    values = Values(seed)
    for name in names:
        for _ in range(12):
            message = values.message(class_of(name))
            yield f"{name} {serialize_message(message).hex()}"


def default(names: list[str]) -> Iterator[str]:
    for name in names:
        yield f"{name} {serialize_message(class_of(name)()).hex()}"


def compare(name: str, native: bytes, ours: bytes) -> str:
    """Say how `ours` differs from `native`, two serialized forms of one message.

    Native ROS 2 leaves padding as it finds it, and gives an upper estimate for the length. So a
    byte may differ where ours is zero and ROS itself does not look.
    """
    kind = class_of(name)
    meant = repr(deserialize_message(native, kind))

    def changes(data: bytes) -> bool:
        try:
            return repr(deserialize_message(data, kind)) != meant
        except Exception:
            return True

    if changes(ours):
        return "read as another message"
    if len(ours) > len(native) or changes(native[: len(ours)]):
        return f"{len(ours)} bytes instead of {len(native)}"
    differing = [
        i for i, (one, other) in enumerate(zip(native, ours, strict=False)) if one != other
    ]
    flipped = bytearray(native)
    for index in differing:
        flipped[index] ^= 1
    if any(ours[index] for index in differing) or changes(bytes(flipped)):
        return f"other bytes at {differing}"
    return ""


if __name__ == "__main__":
    numpy.set_printoptions(threshold=sys.maxsize, floatmode="unique")
    command, *words = sys.argv[1:]
    if command == "make":
        print(*make(int(words[0]), words[1:]), sep="\n")
    elif command == "default":
        print(*default(words), sep="\n")
    elif command == "show":
        for line in sys.stdin:
            name, data = line.split()
            print(json.dumps(repr(deserialize_message(bytes.fromhex(data), class_of(name)))))
    else:
        for line in sys.stdin:
            name, native, ours = line.split()
            print(compare(name, bytes.fromhex(native), bytes.fromhex(ours)))
