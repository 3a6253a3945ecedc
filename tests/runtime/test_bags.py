"""Bags read as the page does, but in Node: all types, many messages, thousands of damaged ones."""

from __future__ import annotations

import json
import random
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bags import drive, write_bag
from mcap.writer import CompressionType
from mcap.writer import Writer as McapWriter
from paths import ROOT
from rosbags.interfaces import Nodetype
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from rosbags.typesys.store import Typestore

from sitegen.interfaces.messages import FILLER, types

# Damaged copies in every run, and with --all.
SHORT, LONG = 400, 10_000
MANY = 1_000_000
TEXTS = ("", "hello", "Küche", "日本語")
OWN = (
    "far_msgs/msg/Own",
    "string<=9[<=3] short\nbool[<=2] flags\n"
    "byte raw\nchar letter\nchar[] letters\nfar_msgs/Inner[2] inner\nuint8 ONE=1\n"
    "string NAME='a # b'\n"
    f'{"=" * 80}\nMSG: far_msgs/Inner\nint64 number -5\nstring text "a # b"  # with a default\n',
)


@pytest.mark.parametrize("how", ["cut", "chunk", "any"])
@pytest.mark.parametrize("compression", [CompressionType.ZSTD, CompressionType.LZ4])
def test_what_is_whole_of_a_damaged_bag_is_read(
    tmp_path: Path, pytestconfig: pytest.Config, how: str, compression: CompressionType
) -> None:
    bag = write_bag(tmp_path / "drive.mcap", drive(), compression, chunk_size=1024)
    count = LONG if pytestconfig.getoption("all") else SHORT
    *wrong, last = run("mutatedbags.mjs", bag, how, 1, count).splitlines()
    assert wrong == []
    assert last.startswith(f"{count} read, of 151 messages in ")


def test_types_of_the_common_packages_are_those_of_the_page(tmp_path: Path) -> None:
    """A type that differs would not be played: these are from files that others wrote."""
    store = get_typestore(Stores.LATEST)
    names = [name for name in store.fielddefs if "/msg/" in name]
    store.register(get_types_from_msg(OWN[1], OWN[0]))
    chance = random.Random(1)
    with Writer(tmp_path / "all", version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        for name in [*names, OWN[0]]:
            topic = f"/{name.replace('/msg/', '/')}"
            connection = writer.add_connection(topic, name, typestore=store)
            for time in range(3):
                data = store.serialize_cdr(filled(store, name, chance), name)
                writer.write(connection, time, data)
    known = tmp_path / "types.json"
    known.write_text(json.dumps(types(names, [])))
    found = json.loads(run("readbag.mjs", tmp_path / "all/all.mcap", known))
    compared = found.pop("compared")
    assert found == {
        "count": 3 * (len(names) + 1),
        "topics": len(names) + 1,
        **{name: [] for name in ("notes", "refused", "changed", "different")},
    }
    assert compared > 140


def test_a_million_messages_of_a_hundred_topics_are_read(tmp_path: Path) -> None:
    bag = tmp_path / "many.mcap"
    with bag.open("wb") as stream:
        writer = McapWriter(stream, enable_crcs=False)
        writer.start(profile="ros2", library="test")
        schema = writer.register_schema("std_msgs/msg/UInt8", "ros2msg", b"uint8 data")
        channels = [writer.register_channel(f"/t{n}", "cdr", schema) for n in range(100)]
        for number in range(MANY):
            writer.add_message(channels[number % 100], number, b"\x00\x01\x00\x00\x07", number)
        writer.finish()  # type: ignore[no-untyped-call]
    found = json.loads(run("readbag.mjs", bag))
    assert (found["count"], found["topics"], found["notes"]) == (MANY, 100, [])


def run(script: str, *arguments: object) -> str:
    """Run a script of this folder's support in Node."""
    command = ["node", str(ROOT / "tests/support" / script), *map(str, arguments)]
    done = subprocess.run(command, text=True, capture_output=True, check=False)
    assert done.stderr == ""
    return done.stdout


def filled(store: Typestore, name: str, chance: random.Random) -> Any:
    """Return a message with random values in all of its fields."""
    fields = store.fielddefs[name][1]
    values = {field: value(store, kind, chance) for field, kind in fields if field != FILLER}
    # Messages without fields have a byte that is always zero.
    return store.types[name](**values or {FILLER: 0})


def value(store: Typestore, kind: Any, chance: random.Random) -> Any:
    """Return a random value of a field."""
    node, detail = kind
    if node == Nodetype.NAME:
        return filled(store, detail, chance)
    if node == Nodetype.BASE:
        base, limit = detail
        if base in ("string", "wstring"):
            return chance.choice(TEXTS)[: limit or None]
        return scalar(base, chance).item()
    inner, size = detail
    length = size if node == Nodetype.ARRAY else min(size or 3, chance.randrange(4))
    values = [value(store, inner, chance) for _ in range(length)]
    if inner[0] == Nodetype.BASE and inner[1][0] not in ("string", "wstring"):
        return np.array(values, dtype=dtype(inner[1][0]))
    return values


def scalar(base: str, chance: random.Random) -> Any:
    if base == "bool":
        return np.bool_(chance.randrange(2))
    kind = dtype(base)
    if kind.kind == "f":
        return kind.type(chance.uniform(-1e6, 1e6))
    if base in ("byte", "char"):
        # rosbags takes one of them as signed.
        return kind.type(chance.randrange(128))
    return kind.type(chance.randrange(int(np.iinfo(kind).min), int(np.iinfo(kind).max) + 1))


def dtype(base: str) -> np.dtype[Any]:
    return np.dtype({"byte": "uint8", "octet": "uint8", "char": "uint8"}.get(base, base))
