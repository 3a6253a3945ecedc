"""Read the messages of bags in MCAP, which is the format of ROS 2."""

from __future__ import annotations

import struct
from collections.abc import Callable, Collection, Iterator
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

MAGIC = b"\x89MCAP0\r\n"
# The records of MCAP that matter here.
SCHEMA, CHANNEL, MESSAGE, CHUNK, DATA_END = 3, 4, 5, 6, 15
CDR = "cdr"
# How often to look whether a file has come (s).
PAUSE = 0.005


class Recorded(NamedTuple):
    """A message of a bag; `time` is that of its recording in nanoseconds since 1970."""

    topic: str
    message: Any
    time: int


class _Channel(NamedTuple):
    topic: str
    type: str
    encoding: str


def bag(source: str | Path | bytes, topics: Collection[str] | None = None) -> Iterator[Recorded]:
    """Yield the messages of a bag in the order of time, those of `topics` or all.

    `source` is its content, a file of the program, or an address: in JupyterLab relative to the
    folder of the notebooks, in other pages relative to the page.

    Raises: ValueError if it is no bag in MCAP, or if it is compressed in a way that the page cannot
        read; OSError if it is not found.
    """
    data = source if isinstance(source, bytes) else _content(source)
    if not data.startswith(MAGIC):
        raise ValueError("not a bag in MCAP; convert it with 'ros2 bag convert'")
    types: dict[int, str] = {}
    channels: dict[int, _Channel] = {}
    found: list[tuple[int, int, memoryview]] = []
    for kind, content in _records(memoryview(data)[len(MAGIC) :]):
        _take(kind, content, types, channels, found)
    found.sort(key=lambda one: one[0])
    for time, number, message in found:
        channel = channels[number]
        if topics is None or channel.topic in topics:
            yield Recorded(channel.topic, _deserialized(channel, message), time)


def _content(source: str | Path) -> bytes:
    if Path(source).is_file():
        return Path(source).read_bytes()
    import js  # type: ignore[import-not-found]
    from rclpy_backend import notebook

    address = str(js.URL.new(str(source), notebook.address or js.location.href).href)
    try:
        return _fetched(address)
    except Exception as error:
        raise FileNotFoundError(f"no bag at {address}: {error}") from None


def _fetched(address: str) -> bytes:
    """Return a file of the site; the program waits for it."""
    import ros_host
    from rclpy_backend.system import blocking

    file = ros_host.file(address)
    if ros_host.stacks:
        while not file.done:
            blocking.wait(PAUSE)
        if file.error:
            raise OSError(file.error)
        file = file.content
    return bytes(file.to_bytes())


def _records(data: memoryview) -> Iterator[tuple[int, memoryview]]:
    """Yield the kind and the content of each record, up to the end of the messages."""
    at = 0
    while at + 9 <= len(data):
        kind, size = struct.unpack_from("<BQ", data, at)
        content = data[at + 9 : at + 9 + size]
        if kind == DATA_END or len(content) < size:
            return
        yield kind, content
        at += 9 + size


def _take(
    kind: int,
    content: memoryview,
    types: dict[int, str],
    channels: dict[int, _Channel],
    found: list[tuple[int, int, memoryview]],
) -> None:
    if kind == SCHEMA:
        (number,) = struct.unpack_from("<H", content)
        types[number] = _text(content, 2)[0]
    elif kind == CHANNEL:
        number, schema = struct.unpack_from("<HH", content)
        topic, at = _text(content, 4)
        channels[number] = _Channel(topic, types.get(schema, ""), _text(content, at)[0])
    elif kind == MESSAGE:
        number, _, time = struct.unpack_from("<HIQ", content)
        found.append((time, number, content[22:]))
    elif kind == CHUNK:
        compression, at = _text(content, 28)
        (size,) = struct.unpack_from("<Q", content, at)
        packed = content[at + 8 : at + 8 + size]
        for inner, record in _records(_unpacked(compression, packed)):
            _take(inner, record, types, channels, found)


def _text(content: memoryview, at: int) -> tuple[str, int]:
    """Return the text at a place, and the place after it."""
    (size,) = struct.unpack_from("<I", content, at)
    return bytes(content[at + 4 : at + 4 + size]).decode(), at + 4 + size


def _unpacked(compression: str, packed: memoryview) -> memoryview:
    if not compression:
        return packed
    decompress = _decompressor(compression)
    if decompress is None:
        advice = "record it without compression, or convert it with 'ros2 bag convert'"
        raise ValueError(f"this page cannot read a bag compressed with {compression}; {advice}")
    return memoryview(decompress(bytes(packed)))


def _decompressor(compression: str) -> Callable[[bytes], bytes] | None:
    try:
        if compression == "zstd":
            return import_module("compression.zstd").decompress  # type: ignore[no-any-return]
        if compression == "lz4":
            return import_module("lz4.frame").decompress  # type: ignore[no-any-return]
    except ImportError:
        pass
    return None


def _deserialized(channel: _Channel, message: memoryview) -> Any:
    from rclpy.serialization import deserialize_message

    parts = channel.type.split("/")
    if channel.encoding != CDR or len(parts) != 3:
        what = f"{channel.topic} has messages in '{channel.encoding}'"
        raise ValueError(f"{what}, not in CDR; choose others with 'topics'")
    package, kind, name = parts
    of_type = getattr(import_module(f"{package}.{kind}"), name)
    return deserialize_message(bytes(message), of_type)
