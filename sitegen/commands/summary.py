"""Summarize a site in lines that fit on a screen, however large it is."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from sitegen.model import BROWSERS, Artifact, Page, Program, Programs, Site
from sitegen.report import count, size

# At most this many lines of each kind; together, they fit on a screen of 24 lines.
NOTES, PAGES, NODES = 3, 10, 6
# What 3D views load, of which so many are listed without being asked.
MESHES, MESHES_LISTED = "meshes/", 3


def summary(
    site: Site,
    programs: Programs,
    artifacts: Iterable[Artifact] = (),
    *,
    verbose: bool = False,
) -> list[str]:
    """Return lines about the notes, pages, nodes and meshes of a site.

    If `verbose`, they are about all of them.
    """
    # Nodes that use one ROS2WASM script with different types are different programs.
    nodes = list({one.name: one for one in programs.values()}.values())
    meshes = {one.path: one.size for one in artifacts if one.path.startswith(MESHES)}
    brief = [*_notes(site.notes), *_pages(site.pages), *_nodes(nodes), *_meshes(meshes)]
    everything = [*_notes(site.notes, True), *_pages(site.pages, True), *_nodes(nodes, True)]
    everything += _meshes(meshes, True)
    if verbose or brief == everything:
        return everything
    return [*brief, "  --verbose lists all"]


def _notes(notes: Sequence[str], everything: bool = False) -> Iterator[str]:
    shown = notes if everything or len(notes) <= NOTES + 1 else notes[:NOTES]
    yield from shown
    if len(shown) < len(notes):
        yield f"… and {count(len(notes) - len(shown), 'note')} more"


def _pages(pages: Sequence[Page], everything: bool = False) -> Iterator[str]:
    rows = [(f"/{page.path}", page.level or "", page.title) for page in pages]
    left = 0
    if not everything and len(rows) > PAGES + 1:
        groups = list(_groups(pages).values())
        # A site is mainly about the pages that run nodes; pages of text are left out first.
        ranked = sorted(groups, key=lambda group: not any(page.level for page in group))
        kept = [group for group in groups if group in ranked[:PAGES]]
        rows = [_row(group) for group in kept]
        left = len(pages) - sum(map(len, kept))
    widths = [max(len(row[column]) for row in rows) for column in (0, 1)]
    for path, level, title in rows:
        yield f"  {path:{widths[0]}}  {level:{widths[1]}}  {title}".rstrip()
    if left:
        yield f"  … and {count(left, 'page')} more"


def _groups(pages: Iterable[Page]) -> Mapping[str, list[Page]]:
    """Return the pages by their first folder, in the order of the first page of each."""
    groups: dict[str, list[Page]] = {}
    for page in pages:
        groups.setdefault(page.path.partition("/")[0], []).append(page)
    return groups


def _row(group: Sequence[Page]) -> tuple[str, str, str]:
    levels = sorted({page.level for page in group if page.level})
    level = "-".join(dict.fromkeys([*levels[:1], *levels[-1:]]))
    if len(group) == 1:
        return f"/{group[0].path}", level, group[0].title
    return f"/{group[0].path.partition('/')[0]}/…", level, count(len(group), "page")


def _nodes(programs: Sequence[Program], everything: bool = False) -> Iterator[str]:
    if everything or len(programs) <= NODES:
        for one in programs:
            what = "did not build" if one.fault else f"{one.written_in}{_sizes([one])}"
            yield f"  {one.name}: {what}"
        return
    if failed := sum(bool(one.fault) for one in programs):
        yield f"  {count(failed, 'node')} did not build"
    programs = [one for one in programs if not one.fault]
    for what in sorted({one.written_in for one in programs}):
        group = [one for one in programs if one.written_in == what]
        yield f"  {count(len(group), 'node')} in {what}{_sizes(group)}"


def _sizes(programs: Sequence[Program]) -> str:
    """Return the total size of the programs in bytes, and the browsers that they are for."""
    # Programs may share files.
    files: dict[str, dict[str, int]] = {}
    for one in programs:
        for engine, own in one.sizes.items():
            files.setdefault(engine, {}).update(own)
    said = (
        f", {size(sum(each.values()))}" + (f" for {BROWSERS[engine]}" if engine else "")
        for engine, each in files.items()
    )
    return "".join(said)


def _meshes(sizes: Mapping[str, int], everything: bool = False) -> Iterator[str]:
    """Yield what 3D views load, since meshes are often larger than all the rest."""
    if not sizes:
        return
    ordered = sorted(sizes.items(), key=lambda one: (-one[1], one[0]))
    total = f"  {count(len(sizes), 'file')} for 3D views, {size(sum(sizes.values()))}"
    if not everything and len(sizes) > MESHES_LISTED:
        name, largest = ordered[0]
        yield f"{total}; the largest is {name.removeprefix(MESHES)}, {size(largest)}"
        return
    yield total
    yield from (f"    {name.removeprefix(MESHES)}: {size(one)}" for name, one in ordered)
