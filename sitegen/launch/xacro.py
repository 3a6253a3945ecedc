"""Turn a robot description in xacro into a URDF."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from sitegen.launch.substitutions import SubstitutionError

PROGRAM = Path(__file__).with_name("describe_robot.py")


def expanded(words: Sequence[str], folders: Mapping[str, Path]) -> str:
    """Return what `xacro` prints for these words; raises a SubstitutionError.

    `folders` are those of the packages of the workspace.
    """
    given = json.dumps({name: str(path) for name, path in folders.items()})
    command = [sys.executable, "-I", "-B", str(PROGRAM), *words]
    done = subprocess.run(command, input=given, text=True, capture_output=True)
    if done.returncode:
        # The last line says what is wrong; what was said before are warnings.
        lines = done.stderr.strip().splitlines() or ["xacro failed"]
        raise SubstitutionError(lines[-1])
    return done.stdout
