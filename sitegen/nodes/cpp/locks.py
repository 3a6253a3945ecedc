"""Let builds run side by side, except those that write to the same folders."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

from filelock import FileLock, Timeout

from sitegen.report import Report


@contextmanager
def locked(folders: Iterable[Path], report: Report) -> Iterator[None]:
    """Hold the locks of folders, which need not exist.

    All builds ask for them in the same order, so none of them waits for one that waits for it.
    """
    with ExitStack() as held:
        for folder in sorted(set(folders)):
            folder.parent.mkdir(parents=True, exist_ok=True)
            lock = FileLock(_lock_of(folder))
            try:
                lock.acquire(timeout=0)
            except Timeout:
                with report.during("sitegen", "waiting for another build"):
                    lock.acquire()
            held.callback(lock.release)
        yield


def _lock_of(folder: Path) -> Path:
    """Return the file of the lock of a folder."""
    return folder.with_name(f"{folder.name}.lock")
