"""List the packages that a workspace lacks, and where their sources are."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from sitegen.config.builds import packages_of
from sitegen.errors import Problems, SiteError
from sitegen.report import Report, count
from sitegen.workspace.absent import absent
from sitegen.workspace.repositories import Repository, repository

UNKNOWN = "sitegen does not know where its sources are"

# The packages that need an absent one, by its name.
Absent = Mapping[str, Sequence[str]]


def missing(folder: Path) -> Absent:
    """Return what the packages of the workspace need, and neither it nor sitegen has.

    Raises: SiteError if there is no package, or with the problems of their files.
    """
    root = folder.resolve()
    problems = Problems(root)
    packages = packages_of(root, problems)
    problems.raise_if_any()
    if not packages:
        raise SiteError([f"{folder}: no ROS package found; give the folder of a workspace"])
    found: dict[str, list[str]] = {}
    for package in packages.values():
        for name in absent(package, packages):
            found.setdefault(name, []).append(package.name)
    return found


def tell(found: Absent, report: Report) -> None:
    """Report each missing package with the command that clones its sources."""
    for name, users in found.items():
        known = repository(name)
        what = known.command if known else UNKNOWN
        report.say(f"'{name}', needed by {_quoted(users)}: {what}", "warning")
    if not found:
        report.say("no package is missing", "good")
        return
    report.say(f"{count(len(found), 'package')} missing")
    if any(map(repository, found)):
        report.say("clone their sources with:  sitegen missing --vcs | vcs import src")


def vcs(found: Absent) -> str:
    """Return a file for `vcs import` with the repositories of all missing packages."""
    repositories: dict[str, Repository] = {}
    for each in dict.fromkeys(filter(None, map(repository, found))):
        # Packages may be on several branches of a repository.
        place = f"{each.name}-{each.branch}" if each.name in repositories else each.name
        repositories[place] = each
    lines = ["repositories:" if repositories else "repositories: {}"]
    for place, each in repositories.items():
        url, version = f"    url: {each.url}.git", f"    version: {each.branch}"
        lines += [f"  {place}:", "    type: git", url, version]
    for name, users in found.items():
        if not repository(name):
            lines.append(f"# '{name}', needed by {_quoted(users)}: {UNKNOWN}")
    return "\n".join(lines)


def _quoted(names: Sequence[str]) -> str:
    return ", ".join(f"'{name}'" for name in names)
