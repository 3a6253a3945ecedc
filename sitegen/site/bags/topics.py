"""Read which topics a bag has: from the summary at the end of an MCAP file (mcap.dev/spec)."""

from __future__ import annotations

import os
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

MAGIC = b"\x89MCAP0\r\n"
# The last record: its kind and length, where the summary and its offsets begin, and a checksum.
FOOTER = struct.Struct("<BQQQI")
SCHEMA, CHANNEL = 3, 4
# The largest summary that is read, in bytes.
LARGEST = 64_000_000


@dataclass(frozen=True)
class Topic:
    """A topic of a bag; `definition` is the text of its type as .msg, or empty."""

    name: str
    type: str
    definition: str


def topics(file: Path) -> list[Topic]:
    """Return the topics of a bag by name; none if it has no summary, or a damaged one."""
    schemas: dict[int, tuple[str, str]] = {}
    found: dict[str, Topic] = {}
    try:
        for kind, record in _records(_summary(file)):
            if kind == SCHEMA:
                number, name, encoding, text = _schema(record)
                schemas[number] = (name, text if encoding == "ros2msg" else "")
            elif kind == CHANNEL:
                number, name = _channel(record)
                found[name] = Topic(name, *schemas.get(number, ("", "")))
    except (struct.error, UnicodeDecodeError):
        return []
    return [found[name] for name in sorted(found)]


def _summary(file: Path) -> bytes:
    with file.open("rb") as stream:
        end = stream.seek(0, os.SEEK_END) - FOOTER.size - len(MAGIC)
        if end < len(MAGIC):
            return b""
        stream.seek(end)
        _, _, start, _, _ = FOOTER.unpack(stream.read(FOOTER.size))
        if stream.read() != MAGIC or not 0 < start <= end or end - start > LARGEST:
            return b""
        stream.seek(start)
        return stream.read(end - start)


def _records(content: bytes) -> Iterator[tuple[int, bytes]]:
    at = 0
    while at < len(content):
        kind, length = struct.unpack_from("<BQ", content, at)
        yield kind, content[at + 9 : at + 9 + length]
        at += 9 + length


def _schema(record: bytes) -> tuple[int, str, str, str]:
    [number] = struct.unpack_from("<H", record)
    name, at = _text(record, 2)
    encoding, at = _text(record, at)
    text, _ = _text(record, at)
    return number, name, encoding, text


def _channel(record: bytes) -> tuple[int, str]:
    """Return the number of the schema, and the topic."""
    _, schema = struct.unpack_from("<HH", record)
    return schema, _text(record, 4)[0]


def _text(record: bytes, at: int) -> tuple[str, int]:
    """Return the text at a place, and where the next one begins."""
    [length] = struct.unpack_from("<I", record, at)
    end = at + 4 + length
    return record[at + 4 : end].decode(), end
