"""Write GitHub workflows: one publishes the site, one compiles its nodes for other sites."""

from __future__ import annotations

import json
from pathlib import Path

from sitegen.commands import installed
from sitegen.errors import SiteError

TEMPLATES = Path(__file__).parent / "templates" / "github"
FOLDER = Path(".github") / "workflows"
# The placeholders in the templates.
SITE, SITEGEN, BRANCH = "SITE: .\n", "SITEGEN: ros-sitegen\n", "branches: [main]"


def workflows(folder: Path, what: installed.Requirement) -> dict[Path, str]:
    """Return the workflows for the site of `folder`, by file; they install `what`.

    They belong to the repository that contains the folder.

    Raises: SiteError if a workflow already exists.
    """
    root = next((up for up in (folder, *folder.parents) if (up / ".git").exists()), folder)
    files = {root / FOLDER / each.name: each.read_text() for each in sorted(TEMPLATES.iterdir())}
    there = [file for file in files if file.exists()]
    if there:
        raise SiteError([f"{file} already exists; remove or edit it" for file in there])
    site = json.dumps(folder.relative_to(root).as_posix(), ensure_ascii=False)
    branch = json.dumps(_branch(root))
    return {
        file: text.replace(SITE, f"SITE: {site}\n")
        .replace(SITEGEN, f"SITEGEN: {json.dumps(what.text)}\n")
        .replace(BRANCH, f"branches: [{branch}]")
        for file, text in files.items()
    }


def _branch(root: Path) -> str:
    """Return the current branch of the repository."""
    head = root / ".git" / "HEAD"
    text = head.read_text() if head.is_file() else ""
    return text.removeprefix("ref: refs/heads/").strip() if text.startswith("ref: ") else "main"
