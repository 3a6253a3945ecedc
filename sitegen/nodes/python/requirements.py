"""Turn a requirements file into wheels, downloaded by pip."""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
from pathlib import Path

from sitegen.cache.digest import digest_of
from sitegen.errors import SiteError
from sitegen.nodes.python import pyodide
from sitegen.nodes.python.wheel import Wheel, opened
from sitegen.report import Report

PIP = [
    *(sys.executable, "-m", "pip", "--disable-pip-version-check", "--no-input"),
    *("download", "--quiet", "--no-deps", "--only-binary=:all:", "--require-hashes"),
]
NONE = re.compile(r"No matching distribution found for (\S+)")


def pinned(file: Path, root: Path, *, cache: Path, report: Report) -> list[Wheel]:
    """Return the wheels that `file` lists: pure Python, or compiled for Pyodide.

    Raises: SiteError with the message of pip if it fails.
    """
    version, platform = pyodide.python_version(), pyodide.platform()
    python = f"cp{version.replace('.', '')}"
    words = [f"--python-version={version}", f"--platform={platform}"]
    words += ["--implementation=cp", f"--abi={python}"]
    folder = cache / digest_of([file], *words)
    if not folder.exists():
        cache.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=cache) as temporary:
            fresh = Path(temporary) / "wheels"
            command = [*PIP, *words, f"--dest={fresh}", f"--requirement={file}"]
            with report.during(file.name, "downloading what it lists, with pip"):
                done = subprocess.run(command, text=True, capture_output=True)
            if done.returncode:
                tag = f"{python}-{python}-{platform}"
                raise SiteError(_said_by_pip(file.relative_to(root), done.stderr, tag))
            fresh.rename(folder)
    return [opened(wheel.name, wheel) for wheel in sorted(folder.glob("*.whl"))]


def _said_by_pip(file: Path, text: str, tag: str) -> list[str]:
    errors = [line[7:] for line in text.splitlines() if line.startswith("ERROR: ")]
    line = errors[-1] if errors else text.strip()
    if found := NONE.search(line):
        advice = f"use a pure Python package, or one compiled for Pyodide ({tag})"
        return [f"{file.as_posix()}: {found[1]}: no compatible wheel found; {advice}"]
    advice = "write each as 'name==1.2.3 --hash=sha256:…'"
    return [f"{file.as_posix()}: pip: {line}; {advice}"]
