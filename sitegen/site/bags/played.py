"""Find the bags that pages play; those that pages cannot read are converted to MCAP."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from sitegen.errors import Problems
from sitegen.model import Artifact, Page, Site, Widget
from sitegen.report import Report
from sitegen.site.bags.conversion import conversion, digest, readable

KIND = "bag"
FOLDER = "bags"


@dataclass(frozen=True)
class Bags:
    """The bags of a page: their paths in `dist/` by the path that the author wrote."""

    paths: Mapping[str, str]
    artifacts: Sequence[Artifact]


def convert(site: Site, report: Report) -> None:
    """Convert the bags of a site that pages cannot read, and say what was changed in them.

    Raises: SiteError if one has to be converted and that fails.
    """
    problems = Problems(site.root)
    widgets = {name: widget for page in site.pages for name, widget in _played(page)}
    for name, widget in widgets.items():
        needed = conversion(site.root / name)
        if not needed:
            continue
        if not needed.is_done:
            report.doing(name, "converting to MCAP")
            try:
                needed.run()
            except ValueError as error:
                problems.add(widget.location, "bag.file", f"'{name}' {error}")
            finally:
                report.done(name)
        if needed.note:
            report.say(f"{name}: {needed.note}", "warning")
    problems.raise_if_any()


def bags(site: Site, page: Page) -> Bags:
    """Return the bags that the widgets of a page play; they have been converted."""
    paths: dict[str, str] = {}
    artifacts = []
    for name, _ in _played(page):
        file = file_of(site, name)
        stem = re.sub(r"[^\w.-]+", "-", Path(name).name.removesuffix(".mcap"))
        paths[name] = f"{FOLDER}/{stem}.{digest(file)[:10]}.mcap"
        artifacts.append(Artifact(paths[name], file))
    return Bags(paths, artifacts)


def file_of(site: Site, name: str) -> Path:
    """Return the MCAP file of a bag that has been converted, if that was necessary."""
    path = site.root / name
    needed = conversion(path)
    return needed.target if needed else readable(path) or path


def _played(page: Page) -> list[tuple[str, Widget]]:
    """Return the bags of a page as the author wrote them, each with its first player."""
    found: dict[str, Widget] = {}
    for part in page.leaves:
        if isinstance(part, Widget) and part.kind == KIND and part.options.get("file"):
            found.setdefault(str(part.options["file"]), part)
    return list(found.items())
