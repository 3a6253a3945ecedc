"""Pack text into the pixels of a PNG image, as clients of rosbridge unpack it."""

from __future__ import annotations

import math
import struct
import zlib
from base64 import b64encode

SIGNATURE = b"\x89PNG\r\n\x1a\n"
TRUECOLOUR = 2


def encode(text: str) -> str:
    """Return a PNG image in base64; its pixels are the bytes of `text`, and line ends after it."""
    data = text.encode()
    width = max(1, math.isqrt(math.ceil(len(data) / 3)))
    height = max(1, math.ceil(len(data) / 3 / width))
    data = data.ljust(width * height * 3, b"\n")
    step = width * 3
    # Each row begins with the number of its filter: none.
    rows = b"".join(b"\0" + data[i : i + step] for i in range(0, len(data), step))
    head = struct.pack(">IIBBBBB", width, height, 8, TRUECOLOUR, 0, 0, 0)
    parts = (b"IHDR", head), (b"IDAT", zlib.compress(rows, 3)), (b"IEND", b"")
    return b64encode(SIGNATURE + b"".join(_chunk(*part) for part in parts)).decode()


def _chunk(kind: bytes, data: bytes) -> bytes:
    check = zlib.crc32(kind + data)
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", check)
