"""Compute digests of files."""

from __future__ import annotations

import hashlib
from collections.abc import Collection, Iterable, Iterator
from pathlib import Path

from sitegen.ignored import is_ignored


def digest_of(paths: Iterable[Path], *words: str, roots: Collection[Path] = ()) -> str:
    """Return a digest of `words` and of the names and contents of all files at `paths`.

    `roots` are the roots of workspaces and sites, whose build folders are ignored.
    """
    digest = hashlib.sha256()
    for word in words:
        digest.update(word.encode() + b"\0")
    for path in paths:
        for file in sorted(_files(path, roots, set())) if path.is_dir() else [path]:
            name = file.relative_to(path if path.is_dir() else path.parent).as_posix()
            content = hashlib.sha256(file.read_bytes()).digest()
            digest.update(name.encode() + b"\0" + content)
    return digest.hexdigest()[:20]


def _files(folder: Path, roots: Collection[Path], seen: set[Path]) -> Iterator[Path]:
    # Links may lead back to a folder above, or to themselves.
    if (real := folder.resolve()) in seen:
        return
    seen.add(real)
    at_root = folder in roots
    for entry in sorted(folder.iterdir()):
        if entry.is_file():
            yield entry
        elif entry.is_dir() and not is_ignored(entry.name, at_root=at_root):
            yield from _files(entry, roots, seen)
