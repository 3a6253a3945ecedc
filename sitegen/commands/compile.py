"""Compile nodes into an archive for sites that are built without a compiler."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from pathlib import Path

from sitegen import workspace
from sitegen.cache.folder import cache_folder
from sitegen.config.builds import packages_of
from sitegen.errors import Problems, SiteError, nearest
from sitegen.model import Package
from sitegen.nodes import share
from sitegen.nodes.cpp import compiler
from sitegen.nodes.cpp.jobs import Builds, Job
from sitegen.nodes.prebuilt import archive
from sitegen.report import Report, count, size


def compile_to(output: Path, names: Sequence[str], folder: Path, report: Report) -> None:
    """Compile the packages `names` (or package/executable) of a workspace into one archive.

    Raises: SiteError if names cannot be compiled, or with the output of a failed compiler.
    """
    root = folder.resolve()
    problems = Problems(root)
    packages: Mapping[str, Package] = packages_of(root, problems)
    problems.raise_if_any()
    packages = workspace.with_shipped(packages, (name.partition("/")[0] for name in names))
    wanted = _wanted(names, packages)
    jobs = []
    for name, executables in wanted.items():
        *needs, package = workspace.with_plugins(packages, packages[name])
        jobs.append(Job(package, tuple(executables), tuple(needs)))
    engines = archive.ENGINES
    compiled = compiler.compile_nodes(
        jobs, engines, root=root, workspace=root, cache=cache_folder(), report=report
    )
    builds = compiled.builds
    opening = [job.package.name for job in jobs if _opens_files(job, builds)]
    archive.pack(builds, share.files_of(packages, opening), output)
    data = output.read_bytes()
    report.say(f"wrote {output}: {count(len(builds), 'node')}, {size(len(data))}; in site.yaml:")
    digest = hashlib.sha256(data).hexdigest()
    report.say("nodes:")
    for package_name, executable in builds:
        report.say(f"  {executable}:")
        report.say(f"    compiled: {output.name}")
        report.say(f"    sha256: {digest}")
        if len(builds) > 1:
            report.say(f"    package: {package_name}")
            report.say(f"    executable: {executable}")


def _opens_files(job: Job, builds: Builds) -> bool:
    return any(share.opens_files(builds[job.package.name, name]) for name in job.executables)


def _wanted(names: Sequence[str], packages: Mapping[str, Package]) -> dict[str, list[str]]:
    """Return the executables to compile, by package."""
    wanted: dict[str, list[str]] = {}
    problems = []
    for name in names:
        package_name, _, executable = name.partition("/")
        package = packages.get(package_name)
        fault = _fault(package_name, executable, package, packages)
        if fault:
            problems.append(fault)
        elif package:
            chosen = [executable] if executable else _programs(package)
            known = wanted.setdefault(package_name, [])
            known += (one for one in chosen if one not in known)
    if problems:
        raise SiteError(problems)
    return wanted


def _fault(
    name: str, executable: str, package: Package | None, packages: Mapping[str, Package]
) -> str:
    if package is None:
        return f"no package '{name}' in the workspace; {nearest(name, packages)}"
    setup = package.setup
    python = setup and (setup.scripts or package.build_type == "ament_python")
    if setup and python and (not _programs(package) or executable in setup.scripts):
        what = f"'{name}/{executable}'" if executable else f"package '{name}'"
        return (
            f"{what} is written in Python, which is not compiled; "
            "add the package to the site's workspace"
        )
    if package.build_type != "ament_cmake":
        return (
            f"package '{name}' is of build type '{package.build_type}'; "
            "only ament_cmake packages can be compiled"
        )
    if package.executables is None:
        told = f"the executables of '{name}' are known only to CMake; name one: {name}/…"
        return "" if executable else told
    if executable and executable not in package.executables:
        hint = nearest(executable, package.executables)
        return f"package '{name}' has no executable '{executable}'; {hint}"
    return "" if package.executables else f"package '{name}' has no executables"


def _programs(package: Package) -> list[str]:
    """Return the executables of a package that are compiled."""
    scripts = package.setup.scripts if package.setup else {}
    return [name for name in package.executables or () if name not in scripts]
