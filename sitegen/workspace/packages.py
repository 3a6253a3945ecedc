"""Find the packages of a ROS workspace."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Mapping
from functools import cache
from pathlib import Path, PurePosixPath

from sitegen import shipped
from sitegen.errors import Location, Problems, nearest, relative
from sitegen.model import BuildSettings, Fault, Package, Setup
from sitegen.workspace import cmakelists, components, folders, libraries, setupfiles
from sitegen.workspace.manifest import location_of, read_manifest

# The interface packages that come with sitegen.
SHARES = [shipped.ROS / "share", shipped.INTERFACES]
KINDS = ("msg", "srv")
PYTHON, CATKIN = "ament_python", "catkin"
SHEBANG = re.compile(rb"#!.*\bpython")


def scan(
    folder: Path,
    settings: Mapping[str, BuildSettings] | None = None,
    problems: Problems | None = None,
) -> dict[str, Package]:
    """Return the packages below `folder` by name, and report (or raise) what is wrong with them.

    `settings` are those of their builds, by name.
    """
    found = Problems(folder) if problems is None else problems
    packages: dict[str, Package] = {}
    for path in folders.packages(folder, found.root):
        package = _package(path, settings or {}, found)
        if package is None:
            continue
        if package.name in packages:
            first = relative(packages[package.name].path, found.root)
            message = (
                f"package '{package.name}' is also in '{first}'; rename or remove one of the two"
            )
            found.add(location_of(path / "package.xml", "name"), "name", message)
        else:
            packages[package.name] = package
    if problems is None:
        found.raise_if_any()
    return packages


def interfaces(packages: Mapping[str, Package], kinds: Collection[str] = KINDS) -> frozenset[str]:
    """Return the names of all interfaces that ROS and `packages` define: messages and services."""
    given = (
        f"{file.parts[-3]}/{file.parts[-2]}/{file.stem}"
        for share in SHARES
        for kind in kinds
        for file in share.glob(f"*/{kind}/*.{kind}")
    )
    own = (
        f"{package.name}/{Path(name).parent.name}/{Path(name).stem}"
        for package in packages.values()
        for name in package.interfaces
        if Path(name).parent.name in kinds
    )
    return frozenset([*given, *own])


def unknown_interface(name: str, known: Collection[str]) -> str:
    """Return a message about an interface that is not among the `known` ones."""
    package = name.partition("/")[0]
    owners = {one.partition("/")[0] for one in known}
    if package not in owners:
        return f"no package '{package}' with interfaces; {nearest(package, owners)}"
    hint = nearest(name, (one for one in known if one.startswith(f"{package}/")))
    return f"no type '{name}'; {hint}"


@cache
def _shipped_names() -> frozenset[str]:
    """Return the names of the packages that come with sitegen."""
    return frozenset(path.name for path in folders.packages(shipped.PACKAGES, shipped.PACKAGES))


def _package(
    path: Path, settings: Mapping[str, BuildSettings], problems: Problems
) -> Package | None:
    manifest = read_manifest(path / "package.xml", problems)
    if manifest is None:
        return None
    name = manifest.name
    cmake = path / "CMakeLists.txt"
    its_own = settings.get(name, BuildSettings())
    listing = cmakelists.read(cmake, name, its_own)
    depends = [*manifest.depends]
    depends += (each for each in listing.finds if each in _shipped_names())
    depends += libraries.compiled([*listing.finds, *manifest.depends])
    ros1 = CATKIN in depends or not cmake.is_file()
    build_type = manifest.build_type or (CATKIN if ros1 else "ament_cmake")
    executables = listing.executables
    sources = listing.sources | components.sources(path, listing.components)
    if build_type == PYTHON:
        python = _setup(path, problems.root)
        setup: Setup | None = python
        installed = dict(python.files)
        executables, sources = [], {}
    else:
        installed = cmakelists.installed(listing, problems.root) | _by_ament(path, name)
        setup = _scripts(name, listing, installed, problems.root)
    if setup:
        executables = None if executables is None else [*executables, *setup.scripts]
        sources = sources | _modules(path, setup)
    return Package(
        name=name,
        path=path,
        build_type=build_type,
        depends=tuple(each for each in dict.fromkeys(depends) if each != name),
        executables=None if executables is None else tuple(executables),
        interfaces=tuple(dict.fromkeys(listing.interfaces)),
        version=manifest.version,
        description=manifest.description,
        sources={name: tuple(files) for name, files in sources.items()},
        libraries={
            name: tuple(files)
            for name in executables or ()
            if (files := listing.libraries.of(name))
        },
        setup=setup,
        share={to: file for to, file in installed.items() if to.startswith("share/")},
        plugins=tuple(dict.fromkeys(listing.plugins)),
        windowed=any(each.lower().startswith("qt") for each in listing.finds),
        settings=its_own,
    )


def _setup(path: Path, root: Path) -> Setup:
    listing = setupfiles.read(path, root)
    fault = listing.fault and Fault(Location(*listing.fault[:2]), "setup", listing.fault[2])
    files = {installed: path / file for installed, file in listing.files.items()}
    return Setup(listing.scripts, files, (fault,) if fault else ())


def _by_ament(path: Path, name: str) -> dict[str, Path]:
    """Return the files that ament_package() installs; of the one in the index, the name matters."""
    index = f"share/ament_index/resource_index/packages/{name}"
    return dict.fromkeys((f"share/{name}/package.xml", index), path / "package.xml")


def _scripts(
    name: str, listing: cmakelists.Listing, files: Mapping[str, Path], root: Path
) -> Setup | None:
    """Return the Python programs and modules that a package installs by CMake, if any."""
    faults = tuple(listing.faults)
    notes = (*listing.notes, *cmakelists.outside(listing, root))
    programs = {
        installed: file
        for installed, file in files.items()
        if PurePosixPath(installed).parent == PurePosixPath("lib", name) and _is_python(file)
    }
    points = dict[str, str]()
    for config in listing.configs:
        found = setupfiles.programs(config)
        points |= found.scripts
        if found.fault:
            faults += (Fault(Location(*found.fault[:2]), "setup", found.fault[2]),)
    if not programs and not any(installed.startswith("python/") for installed in files):
        return Setup({}, {}, faults, notes) if faults or notes else None
    scripts = {PurePosixPath(installed).name: installed for installed in programs}
    return Setup({**scripts, **points}, files, faults, notes)


def _is_python(file: Path) -> bool:
    if file.suffix == ".py":
        return True
    with file.open("rb") as opened:
        return bool(SHEBANG.match(opened.readline()))


def _modules(path: Path, setup: Setup) -> dict[str, list[str]]:
    """Return the file of each entry point or program."""
    found: dict[str, list[str]] = {}
    for name, target in setup.scripts.items():
        module = target.partition(":")[0].replace(".", "/")
        paths = (target, f"python/{module}.py", f"python/{module}/__init__.py")
        files = (setup.files[each] for each in paths if each in setup.files)
        found[name] = [Path(os.path.relpath(file, path)).as_posix() for file in files]
    return found
