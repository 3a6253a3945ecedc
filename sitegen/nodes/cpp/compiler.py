"""Turn the C++ executables of ROS packages into WebAssembly."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from concurrent.futures import Executor, Future, ThreadPoolExecutor, wait
from dataclasses import replace
from functools import partial
from pathlib import Path

from sitegen.cache.digest import digest_of
from sitegen.cache.durations import Durations
from sitegen.cache.folder import forget_old, use
from sitegen.errors import SiteError
from sitegen.interfaces import generator
from sitegen.model import BROWSERS, Build, Package
from sitegen.nodes.cpp import drafts, libraries, plugins
from sitegen.nodes.cpp.cmake import CMake
from sitegen.nodes.cpp.diagnosis import brief, lacks_library
from sitegen.nodes.cpp.digests import Digests, sources
from sitegen.nodes.cpp.jobs import Compiled, Job
from sitegen.nodes.cpp.licences import licences_of
from sitegen.nodes.cpp.locks import locked
from sitegen.nodes.cpp.progress import Progress, counted, plan
from sitegen.nodes.cpp.project import Project
from sitegen.nodes.cpp.sources import LibrarySources
from sitegen.nodes.cpp.store import keep
from sitegen.nodes.cpp.toolchain import Toolchain, ToolMissingError
from sitegen.options import PUBLISH, Options
from sitegen.report import Report
from sitegen.shipped import PACKAGE
from sitegen.workspace.dependencies import closure


def compile_nodes(
    jobs: Sequence[Job],
    engines: Sequence[str],
    *,
    root: Path,
    workspace: Path,
    cache: Path,
    report: Report,
    options: Options = PUBLISH,
    optional: Collection[tuple[str, str]] = (),
) -> Compiled:
    """Compile each executable for each engine, or take it from the cache.

    `root` is the folder of the site, `workspace` that of the workspace. `optional` programs, by
    package and executable, may need libraries that no page can have. With `keep_going`, errors are
    reported, and everything else is returned.

    Raises: SiteError with the output of the compiler if another program does not compile.
    """
    if not jobs:
        return Compiled({}, {})
    try:
        tools = Toolchain.find()
    except ToolMissingError as error:
        names = ", ".join(f"'{job.package.name}'" for job in jobs)
        raise SiteError([f"{error}: needed for the C++ nodes of {names}"]) from None
    compiler = Compiler(tools, {root, workspace}, root, cache, report, options)
    missing = [
        (job, engine)
        for job in jobs
        for engine in engines
        if not all(map(plugins.is_complete, compiler.builds(job, [engine])))
    ]
    faults: dict[tuple[str, str], str] = {}
    if missing:
        if line := drafts.reason([compiler.builds(job, [engine]) for job, engine in missing]):
            report.say_once(line)
        told = compiler.compile(missing)
        problems, left_out = dict[str, None](), dict[str, None]()
        for (job, engine), lines in zip(missing, told, strict=True):
            failed = compiler.failed(job, engine) if lines else []
            faults |= dict.fromkeys(failed, brief(lines[0])) if lines else {}
            if all(map(lacks_library, lines)) and {*failed} <= {*optional}:
                names = ", ".join(map("/".join, failed))
                left_out |= dict.fromkeys(f"{line} (left out: {names})" for line in lines)
            else:
                problems |= dict.fromkeys(lines)
        if problems and not options.keep_going:
            raise SiteError([*problems])
        for line in problems:
            report.say(line, "bad")
        for line in left_out:
            report.say(line, "warning")
        forget_old(cache)
    builds = {
        (job.package.name, executable): [compiler.build(job, executable, e) for e in engines]
        for job in jobs
        for executable in job.executables
    }
    # Of the executables of a failed job, some may have compiled.
    built = {key: each for key, each in builds.items() if all(one.wasm.exists() for one in each)}
    for folder in {build.wasm.parent for each in built.values() for build in each}:
        use(folder)
    lost = (line for each in built.values() for build in each for line in plugins.noted(build))
    for line in dict.fromkeys(lost):
        report.say(line, "warning")
    packages = {each.name: each for job in jobs for each in (*job.needs, job.package)}
    return Compiled(
        built,
        {key: fault for key, fault in faults.items() if key not in built},
        licences_of([*packages.values()], compiler.library_sources, report),
    )


# The errors of packages that other packages depend on, by package.
Failures = Mapping[str, list[str]]
# The folders of a job for one engine.
Step = Callable[[Job, str], None]


def work_folder(tools: Toolchain, cache: Path) -> Path:
    """Return the folder below `cache` for the files that CMake makes with `tools`."""
    # The generated files contain paths of this installation, and break when it moves.
    base = digest_of(sources(), tools.identity)
    return cache / "work" / digest_of([], base, str(PACKAGE))


class Compiler:
    """Compiles with one toolchain into one cache.

    In the cache, `nodes/<digest>/` holds finished programs by a digest of everything that they are
    made from, and `nodes/<digest>-draft/` those that are drafts; `work/<digest>/` holds the build
    folders of CMake for one version of the tools and the library.
    """

    def __init__(
        self,
        tools: Toolchain,
        roots: Collection[Path],
        root: Path,
        cache: Path,
        report: Report,
        options: Options,
    ) -> None:
        self._tools = tools
        self._root = root
        self._report = report
        self._debug = options.debug
        self._keep_going = options.keep_going
        self._draft = options.draft and not options.debug
        self._cache = cache
        self._nodes = cache / "nodes"
        self._work = work_folder(tools, cache)
        self.library_sources = LibrarySources(self._cmake("").sources, report)
        base = digest_of(sources(), tools.identity)
        shown = root if options.debug else None
        self._digests = Digests(base, roots, shown, self.library_sources)
        self._folders: dict[tuple[Path, str], Path] = {}

    def builds(self, job: Job, engines: Iterable[str]) -> list[Build]:
        """Return the locations of the programs of `job`, whether they exist or not."""
        return [self.build(job, name, engine) for engine in engines for name in job.executables]

    def build(self, job: Job, executable: str, engine: str) -> Build:
        """Return the location of one program, whether it exists or not."""
        folder = self._folder(job, engine)
        stem = f"{executable}.{engine}"
        suffixes = ["js", "wasm", "types.json", *(["lines.json"] if self._debug else [])]
        return Build(engine, *(folder / f"{stem}.{suffix}" for suffix in suffixes))

    def failed(self, job: Job, engine: str) -> list[tuple[str, str]]:
        """Return the programs of `job` that do not exist, by package and executable."""
        names = (
            name for name in job.executables if not self.build(job, name, engine).wasm.exists()
        )
        return [(job.package.name, name) for name in names]

    def _folder(self, job: Job, engine: str) -> Path:
        # A program that already exists in its final form needs no draft. Asked once, because the
        # answer may change while compiling.
        key = (job.package.path, engine)
        if key not in self._folders:
            folder = self._nodes / self._digests.of(job.package, job.needs)
            wanted = [folder / f"{name}.{engine}.wasm" for name in job.executables]
            drafted = self._draft and not all(wasm.exists() for wasm in wanted)
            self._folders[key] = drafts.draft_of(folder) if drafted else folder
        return self._folders[key]

    def compile(self, jobs: Sequence[tuple[Job, str]]) -> list[list[str]]:
        """Compile all `jobs`, several at a time; return the errors of each."""
        engines = sorted({engine for _, engine in jobs})
        self._write_ros()
        packages = ((engine, one) for job, engine in jobs for one in (job.package, *job.needs))
        trees = {self._cmake(engine).tree(package) for engine, package in packages}
        with locked(trees, self._report), ThreadPoolExecutor(os.cpu_count() or 1) as pool:
            # Every program needs the exports of the packages it depends on, and then the library.
            wanted = [[job for job, one in jobs if one == engine] for engine in engines]
            failed = dict(zip(engines, pool.map(self._prepare, engines, wanted), strict=True))
            told = self._told(pool, partial(self._configure_job, failed), jobs)
            # CMake reports missing packages within seconds; the library takes minutes the first
            # time.
            ready = [at for at, lines in enumerate(told) if not lines]
            if ready:
                self._tell_of_warnings([jobs[at] for at in ready])
                list(pool.map(self._compile_library, engines))
                compiling = partial(self._compile_job, failed)
                made = self._told(pool, compiling, [jobs[at] for at in ready])
                for at, lines in zip(ready, made, strict=True):
                    told[at] = lines
        return told

    def _told(self, pool: Executor, step: Step, jobs: Sequence[tuple[Job, str]]) -> list[list[str]]:
        """Run a step for all `jobs`, several at a time; return the errors of each."""

        def attempt(job: Job, engine: str) -> list[str]:
            try:
                step(job, engine)
            except SiteError as error:
                # What goes wrong in each engine alike is told once.
                return [line.replace(f"{self._work / engine}/", "") for line in error.lines]
            return []

        return list(pool.map(attempt, *zip(*jobs, strict=True)))

    def _tell_of_warnings(self, jobs: Sequence[tuple[Job, str]]) -> None:
        strict = {
            f"'{job.package.name}'"
            for job, engine in jobs
            if self._cmake(engine).has_strict_warnings(job.package)
        }
        if names := ", ".join(sorted(strict)):
            self._report.say(f"-Werror has no effect in builds for the browser: {names}")

    def _cmake(self, engine: str, watch: Callable[[str], None] | None = None) -> CMake:
        tools = replace(self._tools, watch=watch)
        return CMake(tools, self._work, engine, self._debug, self._draft)

    def _write_ros(self) -> None:
        cmake, complete = self._cmake(""), self._work / "ros.complete"
        with locked([cmake.ros], self._report):
            use(self._work)
            if not complete.exists():
                generator.write_ros(cmake.ros)
                generator.write_shipped(cmake.ros)
                libraries.write(cmake.ros)
                complete.touch()
            libraries.link(cmake.headers, self._tools.eigen)

    def compile_library(self, engine: str) -> None:
        """Compile the rclcpp library for an engine, if no build has done so yet."""
        self._write_ros()
        self._compile_library(engine)

    def _compile_library(self, engine: str) -> None:
        name, what = f"rclcpp ({BROWSERS[engine]})", "compiling the library (once for all nodes)"
        cmake = self._cmake(engine, counted(self._report, name, what))
        with locked([cmake.library.parent], self._report):
            if cmake.library.exists():
                return
            self._report.doing(name, what)
            done = cmake.make_library()
            self._report.done(name)
        if done.returncode:
            raise RuntimeError(f"the rclcpp library could not be compiled:\n{done.stdout}")

    def _prepare(self, engine: str, jobs: Sequence[Job]) -> Failures:
        """Build the interfaces and libraries of the packages that others need.

        Returns the errors by package. They count only if a job then fails because of that package:
        many dependencies are needed only when the robot starts.
        """
        failed: dict[str, list[str]] = {}
        needs = {need.name: need for job in jobs for need in job.needs}

        def prepare(
            package: Package, its_own: Sequence[Package], before: Sequence[Future[None]]
        ) -> None:
            wait(before)
            try:
                self._prepare_package(engine, package, its_own, failed)
            except SiteError as error:
                failed[package.name] = error.lines

        # In build order, so that each waits only for those that began before it.
        prepared: dict[str, Future[None]] = {}
        with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
            for need in needs.values():
                if (need.path / "CMakeLists.txt").exists():
                    its_own = closure(need, needs)
                    before = [prepared[one.name] for one in its_own if one.name in prepared]
                    prepared[need.name] = pool.submit(prepare, need, its_own, before)
        for each in prepared.values():
            each.result()
        return failed

    def _prepare_package(
        self, engine: str, package: Package, needs: Sequence[Package], failed: Failures
    ) -> None:
        name = f"{package.name} ({BROWSERS[engine]})"
        what = "compiling the libraries that other packages use"
        cmake = self._cmake(engine, counted(self._report, name, what))
        project = self._project(cmake, package, needs, failed)
        if project.is_prepared:
            return
        self._report.doing(name, what)
        try:
            self.library_sources.check(package)
            project.prepare()
        except SiteError:
            project.forget()
            raise
        finally:
            self._report.done(name)

    def _project(
        self, cmake: CMake, package: Package, needs: Sequence[Package], failed: Failures
    ) -> Project:
        return Project(
            cmake,
            package,
            needs,
            failed,
            state=f"{self._digests.of(package, needs)}{'-draft' if self._draft else ''}",
            shown=self._digests.shown(package),
            root=self._root,
            keep_going=self._keep_going,
        )

    def _configure_job(self, failed: Mapping[str, Failures], job: Job, engine: str) -> None:
        project = self._project(self._cmake(engine), job.package, job.needs, failed[engine])
        if not project.is_prepared:  # else others read what is written
            name = f"{job.package.name} ({BROWSERS[engine]})"
            with self._report.during(name, "configuring with CMake"):
                project.configure()

    def _compile_job(self, failed: Mapping[str, Failures], job: Job, engine: str) -> None:
        cmake = self._cmake(engine)
        package = job.package
        project = self._project(cmake, package, job.needs, failed[engine])
        browsers = BROWSERS[engine]
        names = {name: f"{package.name}/{name} ({browsers})" for name in job.executables}
        for name in names.values():
            self._report.doing(name, "compiling")
        outputs: dict[str, str] = {}
        what = f"{package.path} {engine} {'draft' if self._draft else ''}"
        planned, durations = plan(cmake, package, names), Durations(self._cache, what)
        progress = Progress(self._report, names, planned, durations)
        watching = self._cmake(engine, progress.watch)
        done = project.make(lambda: watching.make_programs(package, *job.executables))
        # If anything failed, build each program alone, to attribute the output to it.
        again = bool(done.returncode) and len(job.executables) > 1
        for executable, name in names.items():
            if again:
                done = cmake.make_programs(package, executable)
            if done.returncode:
                outputs[executable] = done.stdout
            else:
                program = cmake.program(package, executable)
                prefixes = [cmake.ros, *map(cmake.prefix, (*job.needs, package))]
                theirs = [
                    one for one in (*job.needs, package) if not one.path.is_relative_to(PACKAGE)
                ]
                shown = list(map(self._digests.shown, theirs))
                build = self.build(job, executable, engine)
                project.note(build)
                keep(program, prefixes, shown, build)
                progress.note(executable)
            self._report.done(name)
        if outputs:
            raise project.error(outputs)
