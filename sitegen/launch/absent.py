"""The packages that launch files name and that neither the workspace nor sitegen has."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

from sitegen.launch.shares import PREFIX
from sitegen.launch.without import SCREENS
from sitegen.shipped import PACKAGES
from sitegen.workspace.absent import NO_BUILD, NOT_HERE, clone
from sitegen.workspace.libraries import NEVER
from sitegen.workspace.repositories import repository

LEFT_OUT = "(left out)"
NOTE = re.compile(
    rf"needs (?:package )?'(\w+)', (?:{NO_BUILD}|{NOT_HERE}; .*) {re.escape(LEFT_OUT)}$"
)


def published(package: str) -> str:
    """Return the note about what needs a package of ROS; "" for unknown ones and for sitegen's."""
    if (PACKAGES / package).is_dir():
        return ""
    if package in NEVER or package.startswith(SCREENS):
        return f"needs '{package}', {NO_BUILD}"
    if not repository(package):
        return ""
    return f"needs package '{package}', {clone(package)}"


def elsewhere(package: str) -> str:
    """Return the note about what needs a package that a page does not have."""
    return f"needs package '{package}', which is not on this page"


def names_absent(line: str) -> str:
    """Return the package that is absent if a line is the note about one, else ""."""
    found = NOTE.search(line)
    return found[1] if found else ""


class Absent:
    """Remembers the absent packages that a launch file asks for; `note` returns the note about one.

    The file gets the path that the package would have on the page, because many files include a
    launch file of it, which can be left out, and nothing else.
    """

    def __init__(self, note: Callable[[str], str]) -> None:
        self.note = note
        self.folders: dict[str, Path] = {}

    def folder(self, package: str) -> Path | None:
        """Return the folder that stands for an absent package, None if its name is unknown."""
        if not self.note(package):
            return None
        return self.folders.setdefault(package, Path(f"{PREFIX}/share/{package}"))

    def of(self, path: Path) -> str:
        """Return the note about a path in an absent package; "" for other paths."""
        owners = (name for name, folder in self.folders.items() if path.is_relative_to(folder))
        return next(map(self.note, owners), "")

    def named(self, text: str) -> str:
        """Return the note about the absent package whose folder is in `text`, "" without one."""
        owners = (name for name, folder in self.folders.items() if f"{folder}/" in f"{text}/")
        return next(map(self.note, owners), "")
