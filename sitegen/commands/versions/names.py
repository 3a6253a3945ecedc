"""Say what a version may be called."""

from __future__ import annotations

import re
from typing import NamedTuple

NAME = re.compile(r"[A-Za-z0-9]+([._+-][A-Za-z0-9]+)*")
# What stands beside the folders of versions.
TAKEN = {
    *("404.html", "CNAME", "index.html", "redirect.js", "robots.txt", "sw.js", "versions.json"),
}


class Version(NamedTuple):
    """A version: the name of its folder, and other names that lead to it."""

    name: str
    aliases: tuple[str, ...] = ()


def is_name(text: str) -> bool:
    """Return whether a version may have this name, which is a part of its address."""
    return bool(NAME.fullmatch(text)) and text not in TAKEN
