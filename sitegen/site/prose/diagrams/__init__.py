"""Draw diagrams when the site is built: flowcharts and sequence diagrams of Mermaid, as SVG."""

from __future__ import annotations

import functools

from sitegen.site.prose.diagrams.fault import DiagramError
from sitegen.site.prose.diagrams.flowchart import flowchart
from sitegen.site.prose.diagrams.sequence import sequence

__all__ = ["DiagramError", "drawn"]


@functools.cache
def drawn(source: str) -> str:
    """Return the SVG of a diagram.

    Raises: DiagramError if the diagram is invalid or unsupported.
    """
    lines = [line.strip().rstrip(";").strip() for line in source.split("\n")]
    lines = [line for line in lines if line and not line.startswith("%%")]
    kind = lines[0].split()[0] if lines else ""
    if kind in ("graph", "flowchart"):
        return flowchart(lines)
    if kind == "sequenceDiagram":
        return sequence(lines)
    message = f"'{kind}' is not a supported diagram; start with 'flowchart LR' or 'sequenceDiagram'"
    raise DiagramError(lines[0] if lines else "", message)
