"""Look for files by any name: unlike pathlib, say no where a name is too long for a file."""

from __future__ import annotations

import os
from pathlib import Path


def is_file(path: str | Path) -> bool:
    """Return whether there is a file at `path`."""
    return os.path.isfile(path)  # noqa: PTH113


def is_folder(path: str | Path) -> bool:
    """Return whether there is a folder at `path`."""
    return os.path.isdir(path)  # noqa: PTH112


def exists(path: str | Path) -> bool:
    """Return whether there is anything at `path`."""
    return os.path.exists(path)  # noqa: PTH110
