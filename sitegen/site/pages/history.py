"""Find the day on which the source of a page last changed, and the link to edit it."""

from __future__ import annotations

import subprocess
from collections.abc import Mapping
from datetime import UTC, datetime
from pathlib import Path
from urllib.parse import quote, urlsplit

from sitegen.model import Page, Site

# The path between a repository and a branch in the URL for editing a file.
EDITORS = {"gitlab": "-/edit", "codeberg.org": "_edit", "gitea": "_edit", "forgejo": "_edit"}


def changed_days(site: Site) -> Mapping[Path, str]:
    """Return the day of the last commit to each file, like 2026-11-21; nothing without git.

    In a shallow clone all files have the same commit, which says nothing, so nothing is returned.
    """
    if not any(page.file for page in site.pages):
        return {}
    if _git(site.root, "rev-parse", "--is-shallow-repository") != "false\n":
        return {}
    top = Path(_git(site.root, "rev-parse", "--show-toplevel").removesuffix("\n"))
    listed = _git(
        *(site.root, "-c", "core.quotePath=false", "-c", "log.showSignature=false", "log"),
        *("--format=%x00%ct", "--name-only", "--no-renames", "--", "*.md"),
    )
    days: dict[Path, str] = {}
    for commit in listed.split("\0")[1:]:
        seconds, _, names = commit.partition("\n")
        day = datetime.fromtimestamp(int(seconds), UTC).date().isoformat()
        for name in filter(None, names.split("\n")):
            days.setdefault(top / name, day)
    return days


def edit_link(site: Site, page: Page) -> str:
    """Return the URL at which the source of `page` can be edited, or nothing."""
    if not site.repository or not page.file:
        return ""
    top = _top(site.root)
    host = urlsplit(site.repository).hostname or ""
    editor = next((way for name, way in EDITORS.items() if name in host), "edit")
    return f"{site.repository}/{editor}/{quote(site.branch)}/{quote(_inside(page.file, top))}"


def _inside(file: Path, top: Path) -> str:
    return file.relative_to(top).as_posix() if file.is_relative_to(top) else file.name


def _top(root: Path) -> Path:
    """Return the folder of the repository; without one, the site's folder."""
    return next((at for at in (root, *root.parents) if (at / ".git").exists()), root)


def _git(folder: Path, *arguments: str) -> str:
    try:
        done = subprocess.run(
            ["git", "-C", str(folder), *arguments], capture_output=True, text=True, timeout=60
        )
    except (OSError, subprocess.TimeoutExpired):
        return ""
    return done.stdout if done.returncode == 0 else ""
