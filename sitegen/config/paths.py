"""Check the paths of pages, and make a path from any name."""

from __future__ import annotations

import re
import unicodedata

MARKS = "._~+-"


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
    if not all(each and each == segment(each) for each in segments):
        return (
            f"'{text}' may contain only lower-case letters, digits, '-', '_', '.', '~' and '+'; "
            f"{hint}"
        )
    return ""


def segment(name: str) -> str:
    """Return a name, in any script, in the form of one segment of a path."""
    # There are several ways to write "ü", and file systems choose different ones.
    text = unicodedata.normalize("NFC", unicodedata.normalize("NFC", name).lower())
    text = "".join(char if _is_allowed(char) else " " for char in text)
    return re.sub(" +", "-", text).lstrip(".")


def _is_allowed(char: str) -> bool:
    if char.isascii():
        return char.isalnum() or char in MARKS
    # Letters, digits, and the signs that belong to letters in many scripts.
    return unicodedata.category(char)[0] in "LMN"
