"""Programs in C that use rowe."""

from __future__ import annotations

import subprocess
from pathlib import Path

from paths import ROOT

PROGRAMS = ROOT / "tests" / "rowe" / "programs"
SOURCES = ROOT / "sitegen" / "clients" / "rowe" / "c"


def compiled(folder: Path, name: str) -> Path:
    """Compile a program beside rowe, and return where it is."""
    sources = [*sorted(SOURCES.glob("*.c")), PROGRAMS / f"{name}.c"]
    options = ["-std=c11", "-g", "-O1", "-Wall", "-Wextra", "-Werror", f"-I{SOURCES}"]
    libraries = ["-lwebsockets", "-ljson-c", "-lpthread", "-lm"]
    subprocess.run(["gcc", *options, "-o", folder / name, *sources, *libraries], check=True)
    return folder / name
