"""Read a MANIFEST.in: the files of a package that `include_package_data` includes."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

# What may stand for a part of a path, and for the rest of a name.
PARTS = re.compile(r"(\*\*/|\*\*|\*|\?|\[!?[^]]+\])")
REGULAR = {"**/": "(?:.+/)?", "**": ".*", "*": "[^/]*", "?": "[^/]"}


def included(file: Path, files: Iterable[str]) -> set[str]:
    """Return those of `files`, relative to the folder of `file`, that it includes."""
    everything, found = list(files), set[str]()
    if not file.is_file():
        return found
    text = file.read_text(encoding="utf-8-sig", errors="replace").replace("\\\n", " ")
    for line in text.splitlines():
        command, _, rest = line.partition("#")[0].strip().partition(" ")
        words = rest.split()
        patterns = [re.compile(_regular(pattern)) for pattern in _patterns(command, words)]
        chosen = {each for each in everything if any(one.fullmatch(each) for one in patterns)}
        if command in ("exclude", "recursive-exclude", "global-exclude", "prune"):
            found -= chosen
        else:
            found |= chosen
    return found


def _patterns(command: str, words: list[str]) -> list[str]:
    """Return the patterns of whole paths that a command means."""
    if command in ("include", "exclude"):
        return words
    if command in ("recursive-include", "recursive-exclude") and words:
        top = words[0].rstrip("/")
        return [f"{top}/**/{word}" if top != "." else f"**/{word}" for word in words[1:]]
    if command in ("global-include", "global-exclude"):
        return [f"**/{word}" for word in words]
    if command in ("graft", "prune"):
        return [f"{word.rstrip('/')}/**" for word in words]
    return []


def _regular(pattern: str) -> str:
    parts = PARTS.split(pattern.removeprefix("./"))
    return "".join(
        REGULAR.get(part, part.replace("[!", "[^") if part.startswith("[") else re.escape(part))
        for part in parts
    )
