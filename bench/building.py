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
from bench.figure import Figure, Target
from sitegen import config
from sitegen.cache.folder import cache_folder
from sitegen.model import Site
from sitegen.nodes.cpp import compiler
from sitegen.nodes.cpp.toolchain import Toolchain
from sitegen.nodes.programs import jobs_of, nodes_of

DEMO01 = Path(__file__).parent.parent / "demos" / "demo01"
REPEATS = 5

# One run and what is around it: CMake looks at the compiler once for each new package.
COLD_TARGET = Target("ratio", "≤", 1)
CACHED_TARGET = Target("figure", "≤", 50)
NOTHING_TARGET = Target("figure", "≤", 300)


def build() -> list[Figure]:
    """Measure `sitegen build` with an empty cache, with a full one, and a single node."""
    own = cache_folder()
    with tempfile.TemporaryDirectory() as temporary, _cache(Path(temporary) / "cache") as cache:
        folder = _copy(Path(temporary) / "site")
        program = [sys.executable, "-m", "sitegen", "build", str(folder)]
        cold = seconds(lambda: run(program))
        warm = [seconds(lambda: run(program)) for _ in range(REPEATS)]
        python = [seconds(lambda: run([sys.executable, "-c", "pass"])) for _ in range(REPEATS)]

        tree = next(cache.glob("work/*/jspi/packages/cpp_hello-*"))
        command = _one_run(tree, Path(temporary) / "talker.js")
        # Elsewhere and longer by a line, so that nothing of it is in the cache but the library.
        other = _copy(Path(temporary) / "other")
        with next(other.glob("src/*/src/talker.cpp")).open("a") as source:
            source.write("// changed\n")
        site = config.load(other / "site.yaml")
        # Around ours, and the mean of both, so that what else the machine does hits both.
        runs = [seconds(lambda: run(command))]
        node = seconds(lambda: _compile(site))
        runs.append(seconds(lambda: run(command)))
        demos = [sys.executable, "-m", "sitegen", "build", str(DEMO01.parent.parent)]
        demos += ["--output", str(Path(temporary) / "demos")]
        with _cache(own):
            run(demos)
            nothing = [seconds(lambda: run(demos)) for _ in range(REPEATS)]
        cached = [seconds(lambda: _compile(site)) for _ in range(REPEATS)]

    compiler = sum(runs) / len(runs)
    return [
        Figure("build of demo01, empty cache (both engines, library too)", "s", cold, compiler),
        Figure(
            "build of demo01, nothing changed (bare: Python starts)",
            "s",
            median(warm),
            median(python),
        ),
        Figure("one node, cold (bare: one em++ run)", "s", node, compiler, COLD_TARGET),
        Figure("one node, cached", "ms", median(cached) * 1000, None, CACHED_TARGET),
        Figure(
            "demos and docs, nothing changed",
            "ms",
            median(nothing) * 1000,
            None,
            NOTHING_TARGET,
        ),
    ]


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
    compiler.compile_nodes(jobs, ["jspi"], root=site.root, cache=cache_folder(), report=Progress())


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
