"""Know where the sources of ROS packages are."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path
from urllib.parse import urlsplit

TABLE = Path(__file__).with_name("repositories.txt")


@dataclass(frozen=True)
class Repository:
    """A git repository with the sources of packages, and the branch for ROS 2."""

    url: str
    branch: str

    @property
    def name(self) -> str:
        """Return its owner and its name, such as ros/filters."""
        return urlsplit(self.url).path.strip("/")

    @property
    def command(self) -> str:
        """Return the command that clones it."""
        return f"git clone -b {self.branch} {self.url}.git"


def repository(package: str) -> Repository | None:
    """Return where the source of `package` is, if it is known."""
    return _repositories().get(package)


@cache
def _repositories() -> dict[str, Repository]:
    found: dict[str, Repository] = {}
    for line in TABLE.read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            url, branch, *packages = line.split(" ")
            found |= dict.fromkeys(packages, Repository(url, branch))
    return found
