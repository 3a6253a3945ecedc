"""Open the author's editor at a line of a file."""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import threading
from pathlib import Path

# The variable with the command of the author's editor, with placeholders for file and line.
VARIABLE = "SITEGEN_EDITOR"
# Editors with their own window, and the arguments that open a file at a line.
KNOWN = (
    "code --goto {file}:{line}",
    "codium --goto {file}:{line}",
    "cursor --goto {file}:{line}",
    "zed {file}:{line}",
    "subl {file}:{line}",
    "kate --line {line} {file}",
    "gedit +{line} {file}",
    "gnome-text-editor {file}",
)


class NoEditorError(Exception):
    """No editor is known, or it could not be started."""


def open_editor(file: Path, line: int) -> None:
    """Open `file` at `line` in the editor of `SITEGEN_EDITOR`, or in the first known one.

    Raises: NoEditorError if there is none, or if it could not be started.
    """
    command = os.environ.get(VARIABLE, "")
    if not command:
        found = (each for each in KNOWN if shutil.which(each.split()[0]))
        command = next(found, "")
    if not command:
        example = f"{VARIABLE}='code --goto {{file}}:{{line}}'"
        raise NoEditorError(f"no editor was found; set {example} before sitegen serve")
    if "{file}" not in command:
        command += " {file}"
    words = [
        word.replace("{file}", str(file)).replace("{line}", str(line))
        for word in shlex.split(command)
    ]
    try:
        process = subprocess.Popen(
            words,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
    except OSError as error:
        raise NoEditorError(f"{words[0]}: {error.strerror}; correct {VARIABLE}") from error
    threading.Thread(target=process.wait, daemon=True).start()
