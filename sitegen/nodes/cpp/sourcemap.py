"""Turn the source map of a program into the lines of its author's files."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from pathlib import Path

DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"
# A range of a program: its first byte, the number of its source file (-1: unknown), and its line.
Stretch = tuple[int, int, int]


def lines_of(source_map: Path, folders: Sequence[str]) -> dict[str, object]:
    """Return the lines of the files in `folders`: see Lines in runtime/workers/cpp/stackTrace.js.

    `folders` are the paths that the compiler was given for the author's folders; all other files
    are left out.
    """
    data = json.loads(source_map.read_text(encoding="utf-8"))
    # Emscripten makes paths relative to the map, although they are names given to the compiler.
    sources = [re.sub(r"^(\.\./)+", "", source) for source in data["sources"]]
    files: dict[str, int] = {}
    at: list[int] = []
    last = (0, -1, 0)
    for begin, source, line in _stretches(data["mappings"]):
        name = sources[source] if source >= 0 else ""
        own = any(name.startswith(f"{folder}/") for folder in folders)
        file = files.setdefault(name, len(files)) if own else -1
        stretch = (begin, file, line if own else 0)
        if stretch[1:] != last[1:]:
            at += [begin - last[0], *stretch[1:]]
            last = stretch
    return {"files": list(files), "at": at}


def _stretches(mappings: str) -> Iterator[Stretch]:
    """Decode the mappings of a program, which are all in one line of the map."""
    begin = source = line = 0
    for segment in mappings.split(","):
        numbers = list(_numbers(segment))
        if len(numbers) > 1:
            source += numbers[1]
            line += numbers[2]
        if numbers:
            begin += numbers[0]
            yield begin, source if len(numbers) > 1 else -1, line + 1


def _numbers(segment: str) -> Iterator[int]:
    """Decode base64 VLQ: five bits in each digit, the lowest first, the sign in the first bit."""
    value = shift = 0
    for digit in segment:
        bits = DIGITS.index(digit)
        value |= (bits & 31) << shift
        if bits & 32:
            shift += 5
        else:
            yield -(value >> 1) if value & 1 else value >> 1
            value = shift = 0
