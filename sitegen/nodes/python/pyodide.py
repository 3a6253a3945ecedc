"""The Pyodide that pages load: its files, its version of Python, its platform."""

from __future__ import annotations

import json
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from sitegen.shipped import VENDOR

# The release that package.json names.
VERSION = "314.0.7"
# Its packages, where its own loader looks for them.
DOWNLOADS = f"https://cdn.jsdelivr.net/pyodide/v{VERSION}/full/"
SUFFIXES = {".json", ".mjs", ".wasm", ".zip"}
LOCK = VENDOR / "pyodide" / "pyodide-lock.json"


def files() -> Sequence[Path]:
    """Return the files that a page with Python nodes loads."""
    return [file for file in (VENDOR / "pyodide").iterdir() if file.suffix in SUFFIXES]


@cache
def download_size() -> int:
    """Return the size of the files whose progress a page shows: all except modules."""
    return sum(file.stat().st_size for file in files() if file.suffix != ".mjs")


@cache
def python_version() -> str:
    """Return the version of its Python, major and minor, such as 3.14."""
    version: str = _info()["python"]
    return version.rpartition(".")[0]


@cache
def platform() -> str:
    """Return the platform tag of the wheels that are compiled for it."""
    return f"pyemscripten_{_info()['abi_version']}_{_info()['arch']}"


@cache
def environment() -> dict[str, str]:
    """Return the values of environment markers (PEP 508)."""
    return {
        "extra": "",
        "implementation_name": "cpython",
        "os_name": "posix",
        "platform_machine": _info()["arch"],
        "platform_python_implementation": "CPython",
        "platform_system": "Emscripten",
        "python_full_version": _info()["python"],
        "python_version": python_version(),
        "sys_platform": "emscripten",
    }


@cache
def _info() -> dict[str, str]:
    found: dict[str, str] = json.loads(LOCK.read_text())["info"]
    return found
