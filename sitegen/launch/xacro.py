"""Run the commands by which launch files read robot descriptions."""

from __future__ import annotations

import json
import shlex
from collections.abc import Collection, Mapping, Sequence
from pathlib import Path

from sitegen.launch import apart
from sitegen.launch.substitutions import SubstitutionError

# Seconds; a description of a robot takes less than one.
LIMIT = 20
PROGRAM = Path(__file__).with_name("describe_robot.py")


def printed(line: str, folders: Mapping[str, Path], roots: Collection[Path]) -> str:
    """Return the output of a command, `cat` or `xacro`, that reads files in `roots`.

    `folders` are those of the packages of the workspace.

    Raises: SubstitutionError if the command fails or is another one.
    """
    name, *words = shlex.split(line) or [""]
    if name not in ("cat", "xacro") or not words:
        raise SubstitutionError(f"$(command …) runs 'xacro' and 'cat' here, not '{line}'")
    paths = [word for word in words if ":=" not in word and not word.startswith("-")]
    for path in paths:
        if not Path(path).is_file():
            raise SubstitutionError(f"no file '{path}'")
        # A page shows to everyone what it has read.
        if not any(Path(path).resolve().is_relative_to(root.resolve()) for root in roots):
            raise SubstitutionError(f"'{path}' is outside the workspace")
    if name == "xacro":
        return _expanded(words, folders)
    return "".join(Path(path).read_text(encoding="utf-8-sig") for path in paths)


def description(file: Path, folders: Mapping[str, Path]) -> str:
    """Return the description of a robot: a file of URDF, or what xacro makes of one.

    Raises: ValueError if it cannot be read.
    """
    try:
        if file.name.endswith(".xacro"):
            return _expanded([str(file)], folders)
        return file.read_text(encoding="utf-8-sig")
    except (OSError, SubstitutionError, UnicodeDecodeError) as error:
        raise ValueError(str(error)) from error


def _expanded(words: Sequence[str], folders: Mapping[str, Path]) -> str:
    """Return the URDF that `xacro` makes."""
    given = json.dumps({name: str(path) for name, path in folders.items()})
    try:
        done = apart.run(PROGRAM, words, given, LIMIT)
    except TimeoutError:
        raise SubstitutionError(f"xacro took longer than {LIMIT} s") from None
    if done.code:
        # The last line is the error; the lines before it are warnings.
        lines = done.stderr.strip().splitlines() or ["xacro failed"]
        raise SubstitutionError(lines[-1])
    return done.stdout
