"""Measure what a build takes, beside one run of the compiler on the same source."""

from __future__ import annotations

import os
import shlex
import shutil
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from statistics import median

from bench.browser import Progress
from bench.counts import Counts
from bench.figure import Figure, Target
from sitegen import config
from sitegen.cache.folder import cache_folder
from sitegen.model import Site
from sitegen.nodes.cpp import compiler
from sitegen.nodes.cpp.toolchain import Toolchain
from sitegen.nodes.programs import jobs_of, nodes_of

DEMO01 = Path(__file__).parent.parent / "demos" / "demo01"

# One run and what is around it: CMake looks at the compiler once for each new package.
COLD_TARGET = Target("ratio", "≤", 1)
CACHED_TARGET = Target("figure", "≤", 50)
NOTHING_TARGET = Target("figure", "≤", 300)


def build(counts: Counts) -> list[Figure]:
    """Measure `sitegen build` with an empty cache, with a full one, and a single node."""
    with tempfile.TemporaryDirectory() as temporary:
        if not counts.cold:
            return _measured(Path(temporary), cache_folder(), counts)
        own = cache_folder()
        with _cache(Path(temporary) / "cache"):
            return _measured(Path(temporary), own, counts)


def _measured(folder: Path, own: Path, counts: Counts) -> list[Figure]:
    """Measure in `folder`; `own` is the cache in which the demos are compiled."""
    site = _copy(folder / "site")
    program = [sys.executable, "-m", "sitegen", "build", str(site)]
    cold = seconds(lambda: run(program))
    warm = [seconds(lambda: run(program)) for _ in range(counts.repeats)]
    python = [seconds(lambda: run([sys.executable, "-c", "pass"])) for _ in range(counts.repeats)]

    # Elsewhere and longer by a line, so that nothing of it is in the cache but the library.
    other = _copy(folder / "other")
    with next(other.glob("src/*/src/talker.cpp")).open("a") as source:
        source.write(f"// changed {time.time_ns()}\n")
    loaded = config.load(other / "site.yaml")
    node = seconds(lambda: _compile(loaded))
    # After it, since its build tree knows the command; the first run would find cold files.
    command = _one_run(_tree(other), folder / "talker.js")
    runs = [seconds(lambda: run(command)) for _ in range(2)]
    cached = [seconds(lambda: _compile(loaded)) for _ in range(counts.repeats)]

    demos = [sys.executable, "-m", "sitegen", "build", str(DEMO01.parent.parent)]
    demos += ["--output", str(folder / "demos")]
    with _cache(own):
        run(demos)
        nothing = [seconds(lambda: run(demos)) for _ in range(counts.repeats)]

    one_run = sum(runs) / len(runs)
    title = "build of demo01, empty cache (both engines, library too)"
    figures = [Figure(title, "s", cold, one_run)] if counts.cold else []
    title = "build of demo01, nothing changed (bare: Python starts)"
    figures.append(Figure(title, "s", median(warm), median(python)))
    figures.append(
        Figure("one node, cold (bare: one em++ run)", "s", node, one_run, COLD_TARGET),
    )
    for title, times, target in (
        ("one node, cached", cached, CACHED_TARGET),
        ("demos and docs, nothing changed", nothing, NOTHING_TARGET),
    ):
        figures.append(Figure(title, "ms", median(times) * 1000, None, target))
    return figures


@contextmanager
def _cache(folder: Path) -> Iterator[Path]:
    """Let sitegen keep compiled nodes in `folder`."""
    before = os.environ.get("SITEGEN_CACHE")
    os.environ["SITEGEN_CACHE"] = str(folder)
    try:
        yield cache_folder()
    finally:
        del os.environ["SITEGEN_CACHE"]
        if before is not None:
            os.environ["SITEGEN_CACHE"] = before


def _copy(folder: Path) -> Path:
    shutil.copytree(DEMO01, folder, ignore=shutil.ignore_patterns("dist"))
    return folder


def _compile(site: Site) -> None:
    """Compile the node of a site for one engine, or find it in the cache."""
    jobs = jobs_of(site, nodes_of(site), cache=cache_folder())
    compiler.compile_nodes(
        jobs,
        ["jspi"],
        root=site.root,
        workspace=site.workspace,
        cache=cache_folder(),
        report=Progress(),
    )


def _tree(site: Path) -> Path:
    """Return the build tree of the node of a site that was just compiled."""
    package = next(site.glob("src/*"))
    trees = cache_folder().glob(f"work/*/jspi/packages/{package.name}-*")
    return max(trees, key=lambda tree: tree.stat().st_mtime_ns)


def _one_run(tree: Path, output: Path) -> list[str]:
    """Return the compiler's command lines for `talker` as one that compiles and links."""
    tools = Toolchain.find()
    commands = tools.run(tools.ninja, "-C", tree, "-t", "commands", "talker").stdout
    compiling, linking = (shlex.split(line) for line in commands.splitlines()[-2:])
    linking = linking[linking.index("&&") + 1 : -2]
    source = compiling.pop()
    # What CMake runs in front of the compiler is ours.
    flags = compiling[compiling.index(str(tools.compiler)) : compiling.index("-MD")]
    at = linking.index("-o")
    # What stands before -o is the object, what comes after it are the libraries.
    return [*flags, source, *linking[1 : at - 1], "-o", str(output), *linking[at + 2 :]]


def run(command: list[str]) -> None:
    """Run a command line that has to succeed."""
    done = Toolchain.find().run(*command)
    if done.returncode:
        raise RuntimeError(f"{shlex.join(command)}\n{done.stdout}")


def seconds(call: Callable[[], object]) -> float:
    """Return how long a call takes."""
    begun = time.monotonic()
    call()
    return time.monotonic() - begun
