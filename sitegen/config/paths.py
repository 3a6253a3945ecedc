"""Check the paths of pages, and make a path from any name."""

from __future__ import annotations

import re

SEGMENT = re.compile(r"[a-z0-9_~-][a-z0-9._~-]*")


def path_fault(text: str) -> str:
    """Return why `text` is no valid path of a page, or nothing."""
    segments = text.removesuffix("/").split("/")
    way = "/".join(filter(None, map(segment, segments)))
    hint = f"write '{way}/'" if way else "write '/' for the first page"
    if text == "/":
        return ""
    if "\\" in text:
        return f"'{text}' contains a backslash; write '{text.replace(chr(92), '/')}'"
    if text.startswith("/"):
        return f"'{text}' is an absolute path; {hint}"
    if ".." in segments:
        return f"'{text}' is outside the site; {hint}"
    if not all(map(SEGMENT.fullmatch, segments)):
        return (
            f"'{text}' may contain only lower-case letters, digits, '-', '_', '.' and '~'; {hint}"
        )
    return ""


def segment(name: str) -> str:
    """Return a name in the form of one segment of a path."""
    return re.sub(r"[^a-z0-9._~-]+", "-", name.lower()).lstrip(".")
