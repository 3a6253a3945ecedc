"""Turn files into a digest of their names and contents."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from pathlib import Path

NOT_SOURCES = {"build", "install", "log", "dist", "__pycache__"}


def digest_of(paths: Iterable[Path], *words: str) -> str:
    """Return a digest of `words` and of the names and contents of all files at `paths`."""
    digest = hashlib.sha256()
    for word in words:
        digest.update(word.encode() + b"\0")
    for path in paths:
        for file in sorted(sources(path)) if path.is_dir() else [path]:
            name = file.relative_to(path if path.is_dir() else path.parent).as_posix()
            content = hashlib.sha256(file.read_bytes()).digest()
            digest.update(name.encode() + b"\0" + content)
    return digest.hexdigest()[:20]


def sources(folder: Path) -> Iterable[Path]:
    """Yield the files of `folder` that a build may read, at any depth."""
    for entry in folder.iterdir():
        if entry.name.startswith(".") or entry.name in NOT_SOURCES:
            continue
        if entry.is_dir():
            yield from sources(entry)
        else:
            yield entry
