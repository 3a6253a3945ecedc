"""Copy a theme that comes with sitegen, as a start for your own."""

from __future__ import annotations

import shutil
from pathlib import Path

from sitegen.errors import SiteError, nearest
from sitegen.shipped import THEMES


def copy(name: str, target: Path) -> None:
    """Copy the theme `name` to `target`.

    Raises: SiteError if there is no such theme, or if `target` exists.
    """
    known = sorted(folder.name for folder in THEMES.iterdir() if folder.is_dir())
    if name not in known:
        raise SiteError([f"no theme named '{name}'; {nearest(name, known)}"])
    if target.exists():
        raise SiteError([f"{target} already exists; choose another folder"])
    shutil.copytree(THEMES / name, target)
