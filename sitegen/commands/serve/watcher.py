"""Turn file system events into sets of files that changed together."""

from __future__ import annotations

import os
import queue
from collections.abc import Iterator
from pathlib import Path

from watchdog.events import EVENT_TYPE_CLOSED, FileSystemEvent, FileSystemEventHandler
from watchdog.observers import Observer
from watchdog.observers.api import BaseObserver

from sitegen.ignored import is_ignored

# Editors write a file in several steps, or several files at once: events within this time (s)
# belong together.
PAUSE = 0.1
CHANGES = {"created", "modified", "moved", "deleted", EVENT_TYPE_CLOSED}


def changes(folder: Path) -> Iterator[list[Path]]:
    """Watch `folder` from now on; yield the files that changed since the last time, if any."""
    root = folder.resolve()
    changed: queue.Queue[Path] = queue.Queue()
    observer = Observer()
    observer.schedule(_Listener(root, changed), str(root), recursive=True)
    observer.start()
    return _together(changed, observer)


def _together(changed: queue.Queue[Path], observer: BaseObserver) -> Iterator[list[Path]]:
    try:
        while True:
            files = {changed.get()}
            try:
                while True:
                    files.add(changed.get(timeout=PAUSE))
            except queue.Empty:
                yield sorted(files)
    finally:
        observer.stop()
        observer.join()


class _Listener(FileSystemEventHandler):
    def __init__(self, root: Path, changed: queue.Queue[Path]) -> None:
        self._root = root
        self._changed = changed

    def on_any_event(self, event: FileSystemEvent) -> None:
        if event.is_directory or event.event_type not in CHANGES:
            return
        for path in filter(None, (event.src_path, event.dest_path)):
            file = Path(os.fsdecode(path))  # type: ignore[arg-type]
            if file.is_relative_to(self._root) and not _ignored(file.relative_to(self._root)):
                self._changed.put(file)


def _ignored(path: Path) -> bool:
    """Return whether a file is not the author's: hidden, made by a tool, or temporary."""
    folders = enumerate(path.parts[:-1])
    return (
        any(part.startswith(".") for part in path.parts)
        or any(is_ignored(name, at_root=depth == 0) for depth, name in folders)
        or path.name.endswith(("~", ".swp", ".tmp"))
    )
