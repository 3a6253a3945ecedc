"""Find the endpoints in the sources of a program, in C++ or Python."""

from __future__ import annotations

from sitegen.commands.wiring import cpp, python
from sitegen.commands.wiring.endpoint import Program
from sitegen.model import Package


def read(package: Package, executable: str) -> Program:
    """Return what the sources of `executable` tell, with names as they are written there."""
    if package.setup and executable in package.setup.scripts:
        return python.read(package.setup, executable)
    return cpp.read(package, executable)
