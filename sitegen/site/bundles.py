"""Find the bundles of the runtime; in a checkout, make them again if modules have changed."""

from __future__ import annotations

import functools
import hashlib
import json
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from sitegen.errors import SiteError
from sitegen.report import Report
from sitegen.shipped import BUNDLES, PACKAGE, RUNTIME

# Only in a checkout: an installed sitegen comes with its bundles.
BUNDLER = PACKAGE.parent / "bundle.mjs"
STAMP = ".digest"


@dataclass(frozen=True)
class Bundle:
    """A bundle of the runtime: the bundles that it imports, and the modules in it."""

    imports: Sequence[str]
    modules: Sequence[str]


def bundles() -> Mapping[str, Bundle]:
    """Return the bundles by path below `runtime/` in the site."""
    return _read()[0]


def imports() -> Mapping[str, Sequence[str]]:
    """Return the imports of each module of the runtime, as paths below RUNTIME."""
    return _read()[1]


def with_imports(names: Sequence[str]) -> list[str]:
    """Return the bundles `names` and all that they import, each once."""
    known, found = bundles(), dict[str, None]()
    waiting = [*reversed(names)]
    while waiting:
        name = waiting.pop()
        if name not in found:
            found[name] = None
            waiting += reversed(known[name].imports)
    return [*found]


def refresh(report: Report) -> None:
    """Make the bundles again if a module has changed since they were made.

    Raises: SiteError if that fails.
    """
    if not BUNDLER.is_file() or is_current():
        return
    # Missing while sitegen itself is built.
    from filelock import FileLock

    from sitegen.cache.folder import cache_folder

    folder = cache_folder()
    folder.mkdir(parents=True, exist_ok=True)
    with FileLock(folder / "bundles.lock"):
        if not is_current():
            report.doing("runtime", "its modules have changed; bundling them again")
            try:
                make()
            finally:
                report.done("runtime")


def make() -> None:
    """Make the bundles.

    Raises: SiteError if that fails.
    """
    node = shutil.which("node")
    if not node:
        raise SiteError(["node not found; the browser modules need Node.js 20 (nodejs.org)"])
    digest = _digest()
    done = subprocess.run([node, BUNDLER.name], cwd=BUNDLER.parent, text=True, capture_output=True)
    if done.returncode:
        raise SiteError([f"node {BUNDLER.name} failed:\n{done.stderr.rstrip()}"])
    (BUNDLES / STAMP).write_text(digest)


def is_current() -> bool:
    """Return whether the bundles were made from the modules as they are now."""
    stamp = BUNDLES / STAMP
    return stamp.is_file() and stamp.read_text() == _digest()


def _digest() -> str:
    """Return a digest of everything that the bundles are made from."""
    found = hashlib.sha256(BUNDLER.read_bytes())
    for file in sorted(RUNTIME.rglob("*.js")):
        found.update(f"\0{file.relative_to(RUNTIME).as_posix()}\0".encode())
        found.update(file.read_bytes())
    return found.hexdigest()


def _read() -> tuple[Mapping[str, Bundle], Mapping[str, Sequence[str]]]:
    file = BUNDLES / "modules.json"
    return _parsed(file, file.stat().st_mtime_ns)


@functools.lru_cache(maxsize=1)
def _parsed(file: Path, time: int) -> tuple[Mapping[str, Bundle], Mapping[str, Sequence[str]]]:
    """Return the parsed contents of a file, cached by its modification time."""
    found = json.loads(file.read_text(encoding="utf-8"))
    return {name: Bundle(**one) for name, one in found["bundles"].items()}, found["modules"]
