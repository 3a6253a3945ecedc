"""Find the builds of prebuilt programs in their archives."""

from __future__ import annotations

import hashlib
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from sitegen.cache.fetch import FetchError, fetch, mismatch
from sitegen.errors import Problems
from sitegen.model import Build, Node, Prebuilt, Site
from sitegen.nodes.prebuilt.archive import LARGEST, ArchiveError, Member, described, members, unpack
from sitegen.report import Report


@dataclass(frozen=True)
class Unpacked:
    """The builds of prebuilt nodes, by package and executable, and the files that they open."""

    builds: Mapping[tuple[str, str], Sequence[Build]] = field(default_factory=dict)
    share: Mapping[str, Path] = field(default_factory=dict)


def resolve(site: Site, *, cache: Path, report: Report) -> tuple[Site, Unpacked]:
    """Return the site with the nodes that its archives contain, and what was in these.

    Raises: SiteError if an archive cannot be read, or does not contain a node that the site names.
    """
    problems = Problems(site.root)
    nodes = [node for page in site.pages for node in page.nodes.values()]
    own = {node.program for node in nodes if not isinstance(node.kind, Prebuilt)}
    builds: dict[tuple[str, str], Sequence[Build]] = {}
    share: dict[str, Path] = {}
    found: dict[Prebuilt, Node] = {}
    folders: dict[tuple[str | Path, str], Path | None] = {}
    for node in nodes:
        given = node.kind
        if not isinstance(given, Prebuilt) or given in found:
            continue
        origin = (given.source, given.sha256)
        if origin not in folders:
            folders[origin] = _unpacked(given, site.root, cache / "compiled", problems, report)
        folder = folders[origin]
        member = _chosen(given, members(folder), site, problems) if folder else None
        if member is None:
            continue
        name = (member.package, member.executable)
        if name in own or builds.get(name, member.builds) != member.builds:
            message = f"another '{'/'.join(name)}' is already on the site; use one of the two"
            problems.add(given.location, given.key, message)
        builds[name] = member.builds
        share |= member.share
        found[given] = replace(node, package=member.package, executable=member.executable)
    problems.raise_if_any()
    if not found:
        return site, Unpacked()
    pages = tuple(
        replace(page, nodes={name: _named(node, found) for name, node in page.nodes.items()})
        for page in site.pages
    )
    return replace(site, pages=pages), Unpacked(builds, share)


def _named(node: Node, found: Mapping[Prebuilt, Node]) -> Node:
    if not isinstance(node.kind, Prebuilt):
        return node
    same = found[node.kind]
    return replace(node, package=same.package, executable=same.executable)


def _unpacked(
    given: Prebuilt, root: Path, cache: Path, problems: Problems, report: Report
) -> Path | None:
    """Return the folder of the unpacked archive, which is named by its hash."""
    try:
        if isinstance(given.source, Path):
            name, file = given.source.relative_to(root).as_posix(), given.source
            digest = hashlib.sha256(file.read_bytes()).hexdigest()
            if given.sha256 and given.sha256 != digest:
                raise FetchError(mismatch(f"'{name}'", digest))
            if not (cache / digest).exists():
                unpack(file, cache / digest)
            return cache / digest
        name, folder = given.source, cache / given.sha256
        if folder.exists():
            return folder
        cache.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=cache) as temporary:
            file = Path(temporary) / "archive.zip"
            report.doing(name, "fetching")
            try:
                fetch(name, given.sha256, file, largest=LARGEST)
            finally:
                report.done(name)
            unpack(file, folder)
        return folder
    except FetchError as error:
        problems.add(given.location, given.key, str(error))
    except ArchiveError as error:
        problems.add(given.location, given.key, f"{name} cannot be used: {error}")
    return None


def _chosen(
    given: Prebuilt, nodes: Sequence[Member], site: Site, problems: Problems
) -> Member | None:
    """Return the one node of an archive that the author means."""
    fitting = [
        node
        for node in nodes
        if given.package in ("", node.package) and given.executable in ("", node.executable)
    ]
    if len(fitting) != 1:
        which = "no such node" if not fitting else "more than one node"
        advice = f"set 'package' and 'executable' to one of: {described(fitting or nodes)}"
        problems.add(given.location, given.key, f"the archive has {which}; {advice}")
        return None
    [node] = fitting
    if site.asyncify and len(node.builds) < 2:
        message = "was compiled for current browsers only; write 'asyncify: false' under 'site'"
        problems.add(given.location, given.key, f"'{described([node])}' {message}")
    return node
