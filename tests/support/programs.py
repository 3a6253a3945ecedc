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
from sitegen.errors import SiteError
from sitegen.nodes.cpp import compiler
from sitegen.nodes.cpp.jobs import Job
from sitegen.nodes.cpp.toolchain import Toolchain
from sitegen.nodes.programs import jobs_of, nodes_of
from sitegen.options import Options
from sitegen.report import Report

# Sites whose tests run in browsers without JSPI, too.
ASYNCIFY = {ROOT, *(SITES / name for name in ("engines", "faults", "files", "services"))}
# Its tests run with `--all` only.
BENCH = ROOT / "bench" / "site"
# These are complete only when a fixture has added the packages of a demo.
PARTS = {"lab", "ros2wasm"}
EVERY = [
    ROOT,
    BENCH,
    *sorted(file.parent for file in SITES.glob("*/site.yaml") if file.parent.name not in PARTS),
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
    cache = cache_folder()
    wanted: dict[bool, list[tuple[Job, str]]] = {}
    for folder in EVERY if everything else [one for one in EVERY if one != BENCH]:
        site = config.load(folder / "site.yaml")
        options = options_of(folder, everything=everything)
        engines = options.engines or ("jspi", "asyncify")
        jobs = jobs_of(site, nodes_of(site), cache=cache)
        wanted.setdefault(options.draft, []).extend((job, one) for one in engines for job in jobs)
    for draft, pairs in wanted.items():
        options, tools = Options(draft=draft), Toolchain.find()
        making = compiler.Compiler(tools, {ROOT}, ROOT, cache, Report(), options)
        missing = [
            (job, engine)
            for job, engine in pairs
            if not all(build.wasm.exists() for build in making.builds(job, [engine]))
        ]
        # Packages with many programs first: the last ones leave a processor idle.
        missing.sort(key=lambda pair: len(pair[0].executables), reverse=True)
        told = making.compile(missing) if missing else []
        # Tests that compile programs of their own would wait for it, each within its limit.
        making.compile_library("jspi")
        if wrong := [line for lines in told for line in lines]:
            raise SiteError(wrong)


if __name__ == "__main__":
    begun = time.monotonic()
    compile_all(everything="--all" in sys.argv[1:])
    print(f"compiled in {time.monotonic() - begun:.0f} s")
