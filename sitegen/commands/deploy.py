"""Publish a site as a commit on the branch that GitHub Pages serves."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import NamedTuple

from sitegen import config
from sitegen.build import VERSIONS, make, write
from sitegen.commands.build import build
from sitegen.commands.git import Repository
from sitegen.commands.versions.build import assemble
from sitegen.commands.versions.names import Version
from sitegen.errors import SiteError
from sitegen.model import Site
from sitegen.report import Report, count, shown, size

# A dry run lists at most this many files of each kind.
LISTED = 20


class Changes(NamedTuple):
    """The changes to publish: paths, in order."""

    added: list[str]
    changed: list[str]
    removed: list[str]


def deploy(
    folder: Path, report: Report, *, dry_run: bool = False, version: Version | None = None
) -> None:
    """Build the site of `folder` and publish it; with `dry_run`, only say what would happen.

    As a `version`, it is published beside those that are there.
    """
    site = config.load(folder / "site.yaml")
    target = site.deploy
    repository = Repository.of(site.root, target.remote, target.branch)
    before = repository.published()
    old = repository.files(before)
    if before and "index.html" not in old:
        message = (
            f"branch '{target.branch}' of {target.remote} contains no web site (no index.html)"
        )
        raise SiteError([f"{message}; choose another one in site.yaml: deploy: {{branch: …}}"])
    if VERSIONS in old and not version:
        message = f"branch '{target.branch}' of {target.remote} contains versions of the site"
        raise SiteError([f"{message}; publish another one: sitegen deploy --version …"])
    with tempfile.TemporaryDirectory(prefix="sitegen-") as temporary:
        output = Path(temporary) / "dist" if dry_run or version else folder / "dist"
        if version:
            published = Path(temporary) / "published"
            repository.extract(before, published)
            write(assemble(folder, version, published, report)[1], output)
        elif dry_run:
            write(make(folder, report).artifacts, output)
        else:
            build(folder, output=output, report=report)
        built = {
            file.relative_to(output).as_posix(): file.read_bytes()
            for file in sorted(output.rglob("*"))
            if file.is_file()
        }
        new = {path: repository.digest(data) for path, data in built.items()}
        changes = _changes(old, new)
        where = f"branch '{target.branch}' of {target.remote} ({repository.url})"
        what = f"{count(len(built), 'file')}, {size(sum(map(len, built.values())))}"
        if dry_run:
            for line in _listed(changes, {path: len(data) for path, data in built.items()}):
                report.say(line)
            report.say(f"would publish {what}, to {where}: {_summed_up(changes)}")
            return
        if before and not any(changes):
            report.say(f"{where} is up to date; nothing to publish")
            return
        repository.publish(output, new, before, _message(site, repository, version))
    source = f"with version {version.name}," if version else f"from {shown(output)}"
    report.say(f"published {what}, {source} to {where}: {_summed_up(changes)}")
    report.say(_next(site, repository.url, first=not before))


def _changes(old: Mapping[str, str], new: Mapping[str, str]) -> Changes:
    return Changes(
        sorted(new.keys() - old.keys()),
        sorted(path for path in new.keys() & old.keys() if new[path] != old[path]),
        sorted(old.keys() - new.keys()),
    )


def _listed(changes: Changes, sizes: Mapping[str, int]) -> Iterable[str]:
    for sign, paths in zip("+~-", changes, strict=True):
        for path in paths[:LISTED]:
            yield f"  {sign} {path}" + (f"  {size(sizes[path])}" if path in sizes else "")
        if len(paths) > LISTED:
            yield f"  {sign} and {len(paths) - LISTED} more"


def _summed_up(changes: Changes) -> str:
    names = zip(("added", "changed", "removed"), changes, strict=True)
    return ", ".join(f"{len(paths)} {name}" for name, paths in names)


def _message(site: Site, repository: Repository, version: Version | None) -> str:
    head, name = repository.head(), f" {version.name}" if version else ""
    return f"Publish {site.title}{name}" + (f", {head}" if head else "")


def _next(site: Site, remote: str, *, first: bool) -> str:
    """Return where the site is published now, and what is left to do until it is online."""
    github = re.search(r"github\.com[:/]([^/]+)/(.+?)(?:\.git)?/?$", remote)
    address = f"https://{site.deploy.cname}/" if site.deploy.cname else site.url
    if github and not address:
        owner, name = github[1].lower(), github[2]
        own = name.lower() == f"{owner}.github.io"
        address = f"https://{owner}.github.io/" + ("" if own else f"{name}/")
    if github and first:
        branch = site.deploy.branch
        return f"now choose branch '{branch}' at {_settings(*github.groups())}, then see {address}"
    if address:
        return f"see {address} in a minute"
    return "the site is available where that branch is served"


def _settings(owner: str, name: str) -> str:
    return f"https://github.com/{owner}/{name}/settings/pages"
