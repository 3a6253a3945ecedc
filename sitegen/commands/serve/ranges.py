"""Read a part of a file, as browsers ask for those of large bags (RFC 9110, section 14)."""

from __future__ import annotations

import re
from pathlib import Path

ASKED = re.compile(r"bytes=(\d{1,18})-(\d{0,18})")


def asked_part(header: str, size: int) -> range | None:
    """Return which bytes of `size` a Range header asks for; None if all should be sent.

    A server may ignore requests for several parts, for those at the end, and for impossible ones.
    """
    asked = ASKED.fullmatch(header.strip())
    if not asked:
        return None
    first, last = int(asked[1]), int(asked[2] or size)
    return range(first, min(last + 1, size)) if first <= last and first < size else None


def read_part(file: Path, part: range) -> bytes:
    """Return some bytes of a file."""
    with file.open("rb") as stream:
        stream.seek(part.start)
        return stream.read(len(part))
