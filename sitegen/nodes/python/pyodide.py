"""Know the files of Pyodide that pages load."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from pathlib import Path

from sitegen.shipped import VENDOR

SUFFIXES = {".json", ".mjs", ".wasm", ".zip"}


def files() -> Sequence[Path]:
    """Return the files that a page with Python nodes loads."""
    return [file for file in (VENDOR / "pyodide").iterdir() if file.suffix in SUFFIXES]


@cache
def download_size() -> int:
    """Return how many bytes of them a page reports progress for: all but the modules."""
    return sum(file.stat().st_size for file in files() if file.suffix != ".mjs")
