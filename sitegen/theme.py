"""Find the themes that come with sitegen, and begin an own one."""

from __future__ import annotations

import shutil
from pathlib import Path

from sitegen.errors import SiteError, nearest

DEFAULT = "default"
BUILT_IN = Path(__file__).parent / "themes"
# An editable install has them where they are in the repository.
THEMES = BUILT_IN if BUILT_IN.is_dir() else BUILT_IN.parents[1] / "themes"


def copy(name: str, target: Path) -> None:
    """Copy a theme to `target`, a new folder, or raise a SiteError."""
    known = sorted(folder.name for folder in THEMES.iterdir() if folder.is_dir())
    if name not in known:
        raise SiteError([f"no theme named '{name}'; {nearest(name, known)}"])
    if target.exists():
        raise SiteError([f"{target} exists already; name another folder"])
    shutil.copytree(THEMES / name, target)
