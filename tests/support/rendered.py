"""Render a site whose programs are not compiled."""

from __future__ import annotations

import io

from sitegen.model import Artifact, Site
from sitegen.nodes.prebuilt.resolve import Unpacked
from sitegen.nodes.programs import programs_of
from sitegen.options import Options
from sitegen.report import Report
from sitegen.site.pages import render


def render_site(site: Site) -> list[Artifact]:
    """Return the artifacts of its pages, as `sitegen check` makes them."""
    options, report = Options(compile=False), Report(io.StringIO())
    return render(
        site, programs_of(site, Unpacked(), options=options, cache=site.root, report=report)
    )
