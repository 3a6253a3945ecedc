"""Compile the C++ programs of the sites that tests open: `python programs.py [--all]`.

Done at once and before the tests, it uses all processors; tests that came to it one by one would
wait for each other.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

from paths import ROOT, SITES

from sitegen import config
from sitegen.cache.folder import cache_folder
from sitegen.nodes.cpp import compiler
from sitegen.nodes.programs import jobs_of, nodes_of
from sitegen.options import Options
from sitegen.report import Report

# Sites whose tests run in browsers without JSPI, too.
ASYNCIFY = {ROOT, *(SITES / name for name in ("engines", "faults", "services"))}
# That of ROS2WASM is complete only when a fixture has compiled its program as that project does.
EVERY = [
    ROOT,
    ROOT / "bench" / "site",
    *sorted(file.parent for file in SITES.glob("*/site.yaml") if file.parent.name != "ros2wasm"),
]


def options_of(folder: Path, *, everything: bool) -> Options:
    """Return how tests build the site of `folder`: with `everything`, for all engines.

    The programs of the repository's own site are what `sitegen build` makes of them. Those of the
    others are drafts: to optimize hundreds of them would take longer than the tests.
    """
    both = everything or folder in ASYNCIFY
    return Options(draft=SITES in folder.parents, engines=() if both else ("jspi",))


def compile_all(*, everything: bool) -> None:
    """Compile the programs of all sites, those that are built alike at once."""
    groups: dict[Options, list[compiler.Job]] = {}
    for folder in EVERY:
        site = config.load(folder / "site.yaml")
        options = options_of(folder, everything=everything)
        jobs = jobs_of(site, nodes_of(site), cache=cache_folder())
        groups.setdefault(options, []).extend(jobs)
    for options, jobs in groups.items():
        compiler.compile_nodes(
            jobs,
            options.engines or ("jspi", "asyncify"),
            root=ROOT,
            workspace=ROOT,
            cache=cache_folder(),
            report=Report(),
            options=options,
        )


if __name__ == "__main__":
    begun = time.monotonic()
    compile_all(everything="--all" in sys.argv[1:])
    print(f"compiled in {time.monotonic() - begun:.0f} s")
