"""Create a small workspace: two nodes, and a site that runs them."""

from __future__ import annotations

import re
import tempfile
from pathlib import Path

from sitegen.commands import schema
from sitegen.errors import SiteError

# The template: a complete workspace, for a robot with this name.
TEMPLATE = Path(__file__).parent / "templates" / "workspace"
NAME, TITLE = "my_robot", "My robot"
# The rule for names of packages (REP 144).
PACKAGE = re.compile(r"[a-z](_?[a-z0-9])+")


def new(folder: Path) -> list[str]:
    """Create the workspace `folder`, with packages named after it; return its files.

    Raises: SiteError if its name is not a valid package name, or if the folder is not empty.
    """
    name = folder.name
    if not PACKAGE.fullmatch(name):
        advice = "use lower-case letters, digits and single '_', starting with a letter"
        like = _like(name)
        raise SiteError(
            [f"'{name or folder}' is not a valid package name; {advice}, like '{like}'"]
        )
    _check_free(folder)
    folder.parent.mkdir(parents=True, exist_ok=True)
    files = sorted(file for file in TEMPLATE.rglob("*") if file.is_file())
    # Moved into place only when it is complete.
    with tempfile.TemporaryDirectory(dir=folder.parent, prefix=f".{name}-") as temporary:
        fresh = Path(temporary) / name
        written = [_write(file, fresh, name) for file in files if "__pycache__" not in file.parts]
        written.append(schema.write(fresh).name)
        fresh.rename(folder)
    return sorted(written)


def _check_free(folder: Path) -> None:
    if folder.is_dir():
        found = sorted(entry.name for entry in folder.iterdir())
        if not found:
            return
        more = f" and {len(found) - 5} more" if len(found) > 5 else ""
        there = f"{', '.join(found[:5])}{more}"
        raise SiteError([f"{folder} already exists and contains {there}; choose another name"])
    if folder.exists() or folder.is_symlink():
        raise SiteError([f"{folder} is a file; choose another name"])


def _write(file: Path, to: Path, name: str) -> str:
    """Write a file of the template below `to`, with `name` filled in; return its path."""
    path = file.relative_to(TEMPLATE).as_posix().replace(NAME, name)
    text = file.read_text(encoding="utf-8")
    title = name.replace("_", " ").capitalize()
    copy = to / path
    copy.parent.mkdir(parents=True, exist_ok=True)
    copy.write_text(text.replace(NAME, name).replace(TITLE, title), encoding="utf-8")
    return path


def _like(name: str) -> str:
    """Return a valid name that is similar to `name`."""
    word = re.sub(r"[^a-z0-9]+", "_", name.lower()).strip("_0123456789")
    return word if PACKAGE.fullmatch(word) else NAME
