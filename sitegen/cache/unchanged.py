"""Detect that nothing has changed since the last build, from the files it read and wrote."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from sitegen.ignored import is_ignored
from sitegen.shipped import PACKAGE, THEMES

GENERATOR = (PACKAGE, THEMES)


def recall(
    folder: Path, output: Path, cache: Path, *, debug: bool, verbose: bool = False
) -> list[str] | None:
    """Return the report of the last build of `folder` to `output` if nothing has changed since."""
    try:
        record = json.loads(_file(output, cache).read_text(encoding="utf-8"))
        roots = [Path(root) for root in record["roots"]]
        same = record["debug"] == debug and record["read"] == _read(folder, roots, output)
        if same and record["wrote"] == _digest([output]):
            return [str(line) for line in record["said"]["verbose" if verbose else "brief"]]
    except (OSError, ValueError, KeyError, TypeError):
        pass  # no record, or one that another version wrote
    return None


def note(
    folder: Path,
    roots: Iterable[Path],
    output: Path,
    cache: Path,
    said: Mapping[bool, Sequence[str]],
    *,
    debug: bool,
    since: int,
) -> None:
    """Record that `output` was built from `folder` and the other folders `roots`.

    `said` is the report without and with --verbose. Nothing is recorded if a file has changed after
    `since`, the time in ns when the build began: it may have been read before that.
    """
    roots = sorted(set(roots))
    within = (root.resolve() for root in (folder, *roots))
    files = (file for root in within for file in _files(root, output.resolve()))
    if any(about.st_ctime_ns > since for _, about in files):
        return
    record = {
        "debug": debug,
        "roots": [str(root) for root in roots],
        "read": _read(folder, roots, output),
        "wrote": _digest([output]),
        "said": {"brief": list(said[False]), "verbose": list(said[True])},
    }
    file = _file(output, cache)
    file.parent.mkdir(parents=True, exist_ok=True)
    fresh = file.with_suffix(f".{os.getpid()}")
    fresh.write_text(json.dumps(record), encoding="utf-8")
    fresh.replace(file)


def _file(output: Path, cache: Path) -> Path:
    name = hashlib.sha256(str(output.resolve()).encode()).hexdigest()[:20]
    return cache / "built" / f"{name}.json"


def _read(folder: Path, roots: Sequence[Path], output: Path) -> str:
    """Return a digest of everything a build reads: site, sitegen, compiler and Git history."""
    tools = [Path(tool) for tool in (shutil.which("em++"), shutil.which("git")) if tool]
    folder = folder.resolve()
    above = next((at for at in (folder, *folder.parents) if (at / ".git").exists()), folder)
    history = _repository(above / ".git") / "logs/HEAD"
    return _digest([folder, *roots, *GENERATOR, *tools, history], without=output.resolve())


def _repository(git: Path) -> Path:
    """Return the folder with the Git history of a working tree; it may be named by a file."""
    if not git.is_file():
        return git
    name = git.read_text(encoding="utf-8", errors="surrogateescape").removeprefix("gitdir:")
    return git.parent / name.strip()


def _digest(roots: Sequence[Path], without: Path | None = None) -> str:
    """Return a digest of the names, sizes and times of all files in `roots`."""
    found = hashlib.sha256()
    for root in dict.fromkeys(root.resolve() for root in roots):
        for path, about in sorted(_files(root, without)):
            line = f"{path}\0{about.st_size}\0{about.st_mtime_ns}\0{about.st_ino}\n"
            found.update(line.encode("utf-8", "surrogateescape"))
    return found.hexdigest()


def _files(root: Path, without: Path | None) -> Iterator[tuple[str, os.stat_result]]:
    if not root.is_dir():
        if root.exists():
            yield str(root), root.stat()
        return
    left_out, seen = str(without), set[str]()
    waiting = [str(root)]
    while waiting:
        folder = waiting.pop()
        # Links may lead back to a folder above.
        if (real := os.path.realpath(folder)) in seen:
            continue
        seen.add(real)
        with os.scandir(folder) as entries:
            here = list(entries)
        if any(entry.name == "pyvenv.cfg" for entry in here):
            continue
        for entry in here:
            # Unlike an entry, a path takes a link to itself for neither a file nor a folder.
            target = Path(entry) if entry.is_symlink() else entry
            if target.is_dir():
                if entry.path != left_out and not is_ignored(entry.name, at_root=False):
                    waiting.append(entry.path)
            elif target.is_file():
                yield entry.path, entry.stat()
