"""Turn a site into the folder `dist/` and a summary of it."""

from __future__ import annotations

import time
from pathlib import Path

from sitegen.build import Made, make, write
from sitegen.cache import unchanged
from sitegen.cache.folder import cache_folder
from sitegen.model import Site
from sitegen.options import Options
from sitegen.report import Report, count, shown

# The summary lists this many pages that run nothing, and counts the others.
LISTED = 20


def build(folder: Path, *, output: Path, report: Report, debug: bool = False) -> None:
    """Build the site of `folder` into `output`; with `debug`, C++ nodes report where they fail.

    Raises: SiteError if anything is wrong; `output` stays as it was.
    """
    begun = time.monotonic()
    made = make(folder, report, output=output, options=Options(debug=debug))
    write(made.artifacts, output)
    summarize(made, report)
    programs = {program.name for program in made.programs.values()}
    pages, nodes = count(len(made.site.pages), "page"), count(len(programs), "node")
    report.say(
        f"built {pages}, {nodes} in {time.monotonic() - begun:.1f} s"
        f" → {shown(output)} (python -m http.server --directory {shown(output)})"
    )
    roots = read_folders(made.site)
    unchanged.note(folder, roots, output, cache_folder(), report.said[:-1], debug=debug)


def read_folders(site: Site) -> list[Path]:
    """Return the folders that a build of `site` reads, other than its own."""
    themes = (page.theme for page in site.pages if page.theme)
    packages = site.pyodide.packages
    wheels = [packages] if isinstance(packages, Path) else []
    return [site.workspace, site.theme, *themes, *wheels]


def summarize(made: Made, report: Report) -> None:
    """Report the pages and programs of the site."""
    site = made.site
    for note in site.notes:
        report.say(note)
    omitted = {page.path for page in [p for p in site.pages if not p.level][LISTED:]}
    listed = [page for page in site.pages if page.path not in omitted]
    width = max(len(page.path) for page in listed) + 1
    for page in listed:
        report.say(f"  /{page.path:{width}} {page.level or '  '}  {page.title}")
    if omitted:
        report.say(f"  … and {count(len(omitted), 'page')} more without nodes")
    # Nodes that use one ROS2WASM script with different types are different programs.
    for program in {one.name: one for one in made.programs.values()}.values():
        report.say(f"  {program.name}: {program.size}")
