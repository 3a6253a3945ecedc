"""Turn the C++ executables of ROS packages into WebAssembly."""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import sys
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from sitegen import interfaces
from sitegen.errors import SiteError, relative
from sitegen.model import Build, Package
from sitegen.report import Report
from sitegen.toolchain import Toolchain, ToolMissingError

CLIENT = Path(__file__).parent / "clients" / "cpp"
OPTIMIZE = "-O2"
SETTINGS = [
    "-DCMAKE_BUILD_TYPE=Release",
    *(f"-DCMAKE_{language}_FLAGS_RELEASE={OPTIMIZE}" for language in ("C", "CXX")),
    # Emscripten's own file lets CMake find packages in its system root only.
    "-DCMAKE_FIND_ROOT_PATH_MODE_PACKAGE=BOTH",
    # A program of the page cannot be run to try the compiler out, and need not be.
    "-DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY",
]
NOT_SOURCES = {"build", "install", "log", "dist", "__pycache__"}


@dataclass(frozen=True)
class Job:
    """What to compile: executables of one package, with the packages it needs built first."""

    package: Package
    executables: tuple[str, ...]
    needs: tuple[Package, ...]


Builds = Mapping[tuple[str, str], Sequence[Build]]


def compile_nodes(
    jobs: Sequence[Job], engines: Sequence[str], *, root: Path, cache: Path, report: Report
) -> Builds:
    """Compile each executable for each engine, or take it from the cache.

    Returns the builds by package and executable. Raises a SiteError that quotes the compiler.
    """
    if not jobs:
        return {}
    try:
        tools = Toolchain.find()
    except ToolMissingError as error:
        names = ", ".join(f"'{job.package.name}'" for job in jobs)
        raise SiteError([f"{error}: needed for the C++ nodes of {names}"]) from None
    compiler = Compiler(tools, root, cache, report)
    missing = [
        (job, engine)
        for job in jobs
        for engine in engines
        if not all(b.wasm.exists() for b in compiler.builds(job, [engine]))
    ]
    if missing:
        compiler.compile(missing)
    return {
        (job.package.name, executable): [compiler.build(job, executable, e) for e in engines]
        for job in jobs
        for executable in job.executables
    }


class Compiler:
    """Compiles with one toolchain into one cache.

    In the cache, `nodes/<digest>/` holds finished programs by a digest of all that went into them;
    `work/<digest>/` holds what CMake makes on the way, for one state of tools and library.
    """

    def __init__(self, tools: Toolchain, root: Path, cache: Path, report: Report) -> None:
        self._tools = tools
        self._root = root
        self._cache = cache
        self._report = report
        self._base = digest_of(
            [CLIENT, Path(interfaces.__file__), interfaces.ROS / ".digest"],
            tools.identity,
            *SETTINGS,
        )
        self._digests: dict[str, str] = {}

    def builds(self, job: Job, engines: Iterable[str]) -> list[Build]:
        """Where the programs of `job` are, or will be."""
        return [self.build(job, name, engine) for engine in engines for name in job.executables]

    def build(self, job: Job, executable: str, engine: str) -> Build:
        """Where one program is, or will be."""
        folder = self._cache / "nodes" / self._digest(job)
        stem = f"{executable}.{engine}"
        return Build(engine, folder / f"{stem}.js", folder / f"{stem}.wasm")

    def _digest(self, job: Job) -> str:
        name = job.package.name
        if name not in self._digests:
            paths = [package.path for package in (*job.needs, job.package)]
            self._digests[name] = digest_of(paths, self._base)
        return self._digests[name]

    def compile(self, jobs: Sequence[tuple[Job, str]]) -> None:
        """Compile all `jobs`, some at a time; raise one SiteError with all that failed."""
        engines = sorted({engine for _, engine in jobs})
        workers = os.cpu_count() or 1
        with ThreadPoolExecutor(workers) as pool:
            # Every program needs the library: first that, then all of them.
            list(pool.map(self._compile_library, engines))
            results = list(pool.map(lambda job: self._try_package(*job), jobs))
        problems = list(dict.fromkeys(line for lines in results for line in lines))
        if problems:
            raise SiteError(problems)

    def _work(self, engine: str) -> Path:
        return self._cache / "work" / self._base / engine

    def _prefix(self, engine: str) -> Path:
        return self._work(engine) / "prefix"

    def _compile_library(self, engine: str) -> None:
        library = self._work(engine) / "rclcpp" / "librclcpp.a"
        if library.exists():
            return
        name = f"rclcpp ({engine})"
        self._report.doing(name, "compiling the library, once for all nodes")
        interfaces.write_ros(self._prefix(engine))
        self._configure(CLIENT, library.parent, engine)
        done = self._tools.run(self._tools.ninja, "-C", library.parent)
        self._report.done(name)
        if done.returncode:
            raise RuntimeError(f"the rclcpp library could not be compiled:\n{done.stdout}")

    def _try_package(self, job: Job, engine: str) -> list[str]:
        try:
            self._compile_package(job, engine)
        except SiteError as error:
            return error.lines
        finally:
            for executable in job.executables:
                self._report.done(f"{job.package.name}/{executable} ({engine})")
        return []

    def _compile_package(self, job: Job, engine: str) -> None:
        # The packages it needs are there for their interfaces, which CMake generates.
        for needed in job.needs:
            self._configure(needed.path, self._tree(needed, engine), engine)
        tree = self._tree(job.package, engine)
        for executable in job.executables:
            self._report.doing(f"{job.package.name}/{executable} ({engine})", "compiling")
        self._configure(job.package.path, tree, engine)
        for executable in job.executables:
            done = self._tools.run(self._tools.ninja, "-C", tree, executable)
            if done.returncode:
                raise SiteError(self._compile_error(job.package, executable, done.stdout))
            self._keep(tree / "bin" / executable, self.build(job, executable, engine))
            self._report.done(f"{job.package.name}/{executable} ({engine})")

    def _tree(self, package: Package, engine: str) -> Path:
        # By its place, so that a changed package compiles only what changed.
        place = hashlib.sha256(str(package.path).encode()).hexdigest()[:12]
        return self._work(engine) / "packages" / f"{package.name}-{place}"

    def _keep(self, program: Path, build: Build) -> None:
        build.wasm.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(program.with_suffix(".js"), build.script)
        # Last, and in one step: its presence says that the program is complete.
        draft = build.wasm.with_suffix(".draft")
        shutil.copyfile(program.with_suffix(".wasm"), draft)
        draft.replace(build.wasm)

    def _configure(self, source: Path, tree: Path, engine: str) -> None:
        tools = self._tools
        defines = {
            "CMAKE_TOOLCHAIN_FILE": tools.platform_file,
            "CMAKE_MAKE_PROGRAM": tools.ninja,
            "CMAKE_PREFIX_PATH": f"{self._prefix(engine)};{CLIENT}",
            "CMAKE_RUNTIME_OUTPUT_DIRECTORY": tree / "bin",
            "SITEGEN_ENGINE": engine,
            "SITEGEN_PREFIX": self._prefix(engine),
            "SITEGEN_PYTHON": sys.executable,
            "SITEGEN_RCLCPP": self._work(engine) / "rclcpp" / "librclcpp.a",
        }
        words = [f"-D{name}={value}" for name, value in defines.items()]
        done = tools.run(tools.cmake, "-S", source, "-B", tree, "-G", "Ninja", *SETTINGS, *words)
        if done.returncode:
            raise SiteError(self._configure_error(source, done.stdout))

    def _configure_error(self, source: Path, output: str) -> list[str]:
        missing = re.search(r'package\s+configuration\s+file\s+provided\s+by\s+"(\w+)"', output)
        if missing:
            need = f"needs '{missing[1]}', which has no build for the page"
            return [f"{relative(source / 'CMakeLists.txt', self._root)}: '{source.name}' {need}"]
        shown = "\n".join(line for line in output.splitlines() if not line.startswith("-- "))
        file = relative(source / "CMakeLists.txt", self._root)
        return [f"{file}: CMake failed\n{shown.strip()}"]

    def _compile_error(self, package: Package, executable: str, output: str) -> list[str]:
        file = relative(package.path / "CMakeLists.txt", self._root)
        if f"unknown target '{executable}'" in output:
            return [f"{file}: package '{package.name}' has no executable '{executable}'"]
        source = re.search(r"^FAILED: CMakeFiles/[^/]+\.dir/(.+?)\.o(bj)?\s*$", output, re.M)
        if source:
            file = relative(package.path / source[1], self._root)
        what = "em++ failed" if source else f"em++ could not link '{executable}'"
        return [f"{file}: {what} (package '{package.name}')\n{compiler_words(output)}"]


def compiler_words(output: str) -> str:
    """Return what the compiler said in Ninja's `output`, without the command lines around it."""
    ours = re.compile(
        r"ninja: |\[\d+/\d+\] |FAILED: |em\+\+: error: '|: && |\S*/em(\+\+|cc)\s|\S*cmake -E "
    )
    return "\n".join(line for line in output.splitlines() if not ours.match(line)).strip()


def digest_of(paths: Iterable[Path], *words: str) -> str:
    """Return a digest of `words` and of the names and contents of all files at `paths`."""
    digest = hashlib.sha256()
    for word in words:
        digest.update(word.encode() + b"\0")
    for path in paths:
        for file in sorted(sources(path)) if path.is_dir() else [path]:
            name = file.relative_to(path if path.is_dir() else path.parent).as_posix()
            content = hashlib.sha256(file.read_bytes()).digest()
            digest.update(name.encode() + b"\0" + content)
    return digest.hexdigest()[:20]


def sources(folder: Path) -> Iterable[Path]:
    """Yield the files of `folder` that a build may read, at any depth."""
    for entry in folder.iterdir():
        if entry.name.startswith(".") or entry.name in NOT_SOURCES:
            continue
        if entry.is_dir():
            yield from sources(entry)
        else:
            yield entry
