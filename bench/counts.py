"""Say how often and how long the parts of the bench measure."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Counts:
    """How much is measured: turns of ours and bare, starts, seconds, nodes, pages.

    Without `cold`, the build with an empty cache, which compiles the library, is left out.
    """

    turns: int = 8
    bursts: int = 5
    starts: int = 9
    repeats: int = 5
    # Seconds that a flood is watched, and an idle page or one of plots, after some to warm up.
    flood: int = 60
    idle: int = 10
    warm_up: int = 30
    # A large bag, in MB, and places in it that are sought.
    bag: int = 1000
    seeks: int = 9
    # Nodes of a large page, and topics that each publishes.
    nodes: int = 50
    topics: int = 10
    # Pages of this site whose size is measured; all if empty.
    loads: tuple[str, ...] = ()
    # Folders of Markdown, and pages in each.
    folders: int = 20
    pages: int = 50
    cold: bool = True
    # The quality of compression: 11 is the best, which servers use for static files.
    brotli: int = 11


FULL = Counts()
# Enough to see that everything runs; the figures mean nothing.
SMALLEST = Counts(
    turns=1,
    bursts=1,
    starts=1,
    repeats=1,
    flood=1,
    idle=1,
    warm_up=1,
    bag=20,
    seeks=2,
    nodes=5,
    topics=2,
    # A console, and a prompt without one.
    loads=("demo01/", "demo07/"),
    folders=2,
    pages=10,
    cold=False,
    brotli=1,
)
