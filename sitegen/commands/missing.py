"""List the packages that a workspace lacks, and where their sources are."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from sitegen import workspace
from sitegen.config.builds import builds_of
from sitegen.errors import Problems, SiteError
from sitegen.report import Report, count
from sitegen.workspace.absent import absent
from sitegen.workspace.repositories import repository

UNKNOWN = "sitegen does not know where its sources are"

# The packages that need a missing one, by its name.
Missing = Mapping[str, Sequence[str]]


def missing(folder: Path) -> Missing:
    """Return what the packages of the workspace need, and neither it nor sitegen has.

    Raises: SiteError if there is no package, or with the problems of their files.
    """
    root = folder.resolve()
    problems = Problems(root)
    settings = builds_of(root, problems).settings
    packages = workspace.scan(root, settings, problems)
    problems.raise_if_any()
    if not packages:
        raise SiteError([f"{folder}: no ROS package found; give the folder of a workspace"])
    found: dict[str, list[str]] = {}
    for package in packages.values():
        for name in absent(package, packages):
            found.setdefault(name, []).append(package.name)
    return found


def tell(found: Missing, report: Report) -> None:
    """Report each missing package with the command that clones its sources."""
    for name, users in found.items():
        known = repository(name)
        what = known.clone if known else UNKNOWN
        report.say(f"'{name}', needed by {_quoted(users)}: {what}", "warning")
    if not found:
        report.say("no package is missing", "good")
        return
    report.say(f"{count(len(found), 'package')} missing")
    if any(map(repository, found)):
        report.say("clone their sources with:  sitegen missing --vcs | vcs import src")


def vcs(found: Missing) -> str:
    """Return a file for `vcs import` with the repositories of all missing packages."""
    lines = ["repositories:"]
    repositories = dict.fromkeys(filter(None, map(repository, found)))
    for each in repositories:
        url, version = f"    url: {each.url}.git", f"    version: {each.branch}"
        lines += [f"  {each.name}:", "    type: git", url, version]
    if not repositories:
        lines = ["repositories: {}"]
    for name, users in found.items():
        if not repository(name):
            lines.append(f"# '{name}', needed by {_quoted(users)}: {UNKNOWN}")
    return "\n".join(lines)


def _quoted(names: Sequence[str]) -> str:
    return ", ".join(f"'{name}'" for name in names)
