"""Prepare the images of a page for browsers: lasting names, sizes, lazy loading."""

from __future__ import annotations

import functools
import hashlib
import re
from collections.abc import Callable
from pathlib import Path

# A name with only these characters needs no quoting in a URL.
_UNSAFE = re.compile(r"[^\w.-]+")
_CANDIDATE = re.compile(r"[\s,]*([^\s,](?:\S*[^\s,])?)(?:,+(?=\s|$)|\s*$|\s+([^,]*)(?:,|$))")
_LENGTH = re.compile(r"""\s(width|height)\s*=\s*["']?(\d+)["'\s>]""", re.IGNORECASE)
_LAZY = ("loading", "lazy"), ("decoding", "async")


def lasting_name(file: Path) -> str:
    """Return a path inside `dist/` that depends on the content of `file`."""
    name = _UNSAFE.sub("-", file.stem) or "file"
    return f"media/{name}.{_digest(file, file.stat().st_mtime_ns)}{file.suffix.lower()}"


def resourced(text: str, address: Callable[[str], str]) -> str:
    """Return a `srcset` with other addresses.

    A comma ends a picture after its address or its descriptor; one inside of an address belongs to
    it, as in https://html.spec.whatwg.org/multipage/images.html#parsing-a-srcset-attribute.
    """
    pictures = _CANDIDATE.findall(text)
    return ", ".join(f"{address(url)} {size}".strip() for url, size in pictures)


def sized(tag: str, file: Path) -> str:
    """Return an `<img>` that loads lazily and has the size of `file`, so that nothing moves."""
    given = {name.lower(): int(length) for name, length in _LENGTH.findall(tag)}
    width, height = _size(file, file.stat().st_mtime_ns)
    if width > 0 and height > 0:
        if "width" in given:
            width, height = given["width"], round(height * given["width"] / width)
        elif "height" in given:
            width, height = round(width * given["height"] / height), given["height"]
        for name, length in (("width", width), ("height", height)):
            if name not in given:
                tag = _with(tag, name, str(length))
    for name, value in _LAZY:
        if not re.search(rf"\s{name}\s*=", tag, re.IGNORECASE):
            tag = _with(tag, name, value)
    return tag


def _with(tag: str, name: str, value: str) -> str:
    end = "/>" if tag.endswith("/>") else ">"
    return f'{tag.removesuffix(end).rstrip()} {name}="{value}"{end}'


@functools.cache
def _digest(file: Path, changed: int) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest()[:10]


@functools.cache
def _size(file: Path, changed: int) -> tuple[int, int]:
    """Return width and height in pixels; -1 if they are unknown."""
    # It imports HTTP libraries, which takes longer than a page of text.
    import imagesize

    try:
        width, height = imagesize.get(file)
    except (OSError, ValueError, SyntaxError):
        return -1, -1
    return round(width), round(height)
