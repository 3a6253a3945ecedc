"""Build a site into the folder `dist/` and print a summary."""

from __future__ import annotations

import time
from pathlib import Path

from sitegen.build import make, write
from sitegen.cache import unchanged
from sitegen.cache.folder import cache_folder
from sitegen.commands.summary import summary
from sitegen.model import Site
from sitegen.options import PUBLISH, Options
from sitegen.report import Report, count, shown, size


def build(
    folder: Path,
    *,
    output: Path,
    report: Report,
    options: Options = PUBLISH,
    verbose: bool = False,
) -> None:
    """Build the site of `folder` into `output`, with a summary.

    The summary lists all pages and nodes if `verbose`, else as many as fit on a screen.

    Raises: SiteError if anything is wrong; `output` is left unchanged.
    """
    begun, since = time.monotonic(), time.time_ns()
    made = make(folder, report, output=output, options=options)
    write(made.artifacts, output)
    before = list(report.said)
    sums = {
        each: summary(made.site, made.programs, made.artifacts, verbose=each)
        for each in (False, True)
    }
    for line in sums[verbose]:
        report.say(line)
    programs = {program.name for program in made.programs.values()}
    # Pages share files.
    total = sum({artifact.path: artifact.size for artifact in made.artifacts}.values())
    pages, nodes = count(len(made.site.pages), "page"), count(len(programs), "node")
    report.say(
        f"built {pages}, {nodes}, {size(total)} in {time.monotonic() - begun:.1f} s"
        f" → {shown(output)} (python -m http.server --directory {shown(output)})",
        "good",
    )
    if any(program.fault for program in made.programs.values()):
        return  # the next build tries again
    roots = read_folders(made.site)
    said = {each: [*before, *lines] for each, lines in sums.items()}
    unchanged.note(folder, roots, output, cache_folder(), said, debug=options.debug, since=since)


def read_folders(site: Site) -> list[Path]:
    """Return the folders besides its own that a build of `site` reads."""
    themes = (page.theme for page in site.pages if page.theme)
    packages = site.pyodide.packages
    wheels = [packages] if isinstance(packages, Path) else []
    return [site.workspace, site.theme, *themes, *wheels]
