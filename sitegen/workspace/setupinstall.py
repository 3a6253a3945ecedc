"""Find the files that setuptools installs for the arguments of setup()."""

from __future__ import annotations

import glob
import os
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path, PurePosixPath
from typing import Any

from sitegen.workspace import manifestin
from sitegen.workspace.setupnames import Files

NOT_MODULES = {"test", "tests", "build", "install", "log", "launch", "config", "resource"}


class MissingError(Exception):
    """A file of an argument is not there, or cannot be used; the message says which and why."""

    def __init__(self, key: str, name: str, why: str) -> None:
        super().__init__(f"{key}: {why}")
        self.key, self.name = key, name


class Installation:
    """The files of a package, which may use those below `within`."""

    def __init__(self, folder: Path, within: Path, given: Mapping[str, Any]) -> None:
        self._folder, self._within, self._given = folder, within.resolve(), given
        self._roots: Mapping[str, str] = given.get("package_dir") or {}
        packages, modules = given.get("packages"), given.get("py_modules")
        if packages is None and modules is None:
            packages, modules = self._discovered()
        self._packages: Iterable[str] = packages or ()
        self._modules: Iterable[str] = modules or ()

    def files(self) -> Iterator[tuple[str, str]]:
        """Yield the path below the prefix of each file, and its path relative to the package.

        Raises: MissingError if a file that an argument names is not there.
        """
        for name in self._packages:
            yield from self._package(name)
        if self._given.get("include_package_data"):
            yield from self._included()
        for module in self._modules:
            file = self._source(module).with_suffix(".py")
            installed = PurePosixPath("python", *module.split("."))
            yield from self.placed(f"{installed}.py", file, "py_modules")
            if "." in module and (init := file.with_name("__init__.py")).is_file():
                yield from self.placed(f"{installed.parent}/__init__.py", init, "py_modules")
        for target, names in self._given.get("data_files") or ():
            for name in names:
                path = f"{target}/{PurePosixPath(name).name}"
                yield from self.placed(path, self._folder / name, "data_files")

    def placed(self, installed: str, file: Path, key: str) -> Iterator[tuple[str, str]]:
        """Yield a file of the argument `key`, unless it is installed outside of the prefix.

        Raises: MissingError if it is not there.
        """
        path, name = PurePosixPath(installed), os.path.relpath(file, self._folder)
        if path.is_absolute() or ".." in path.parts:
            return
        if not file.is_file():
            why = f"'{name}' is a folder" if file.is_dir() else f"no file '{name}' in the package"
            raise MissingError(key, name, why)
        if not file.resolve().is_relative_to(self._within):
            raise MissingError(key, name, f"'{name}' leads outside the folder of site.yaml")
        yield path.as_posix(), name

    def _source(self, name: str) -> Path:
        """Return where a package or module is, by the longest name that has a folder."""
        parts = name.split(".")
        for end in range(len(parts), 0, -1):
            root = self._roots.get(".".join(parts[:end]))
            if root is not None:
                return self._folder.joinpath(root, *parts[end:])
        return self._folder.joinpath(self._roots.get("", "."), *parts)

    def _package(self, name: str) -> Iterator[tuple[str, str]]:
        source = self._source(name)
        if not source.is_dir():
            shown = os.path.relpath(source, self._folder)
            raise MissingError("packages", name, f"no folder '{shown}' of '{name}'")
        patterns = ["*.py", *self._patterns("package_data", name)]
        without = set(_matching(source, self._patterns("exclude_package_data", name)))
        for file in sorted({*_matching(source, patterns)} - without):
            installed = f"python/{name.replace('.', '/')}/{file}"
            yield from self.placed(installed, source / file, "package_data")

    def _patterns(self, key: str, package: str) -> list[str]:
        data = self._given.get(key) or {}
        return [*data.get("", data.get("*", ())), *data.get(package, ())]

    def _included(self) -> Iterator[tuple[str, str]]:
        """Yield the files in packages that MANIFEST.in names."""
        paths = (file for file in self._folder.rglob("*") if file.is_file())
        files = (file.relative_to(self._folder).as_posix() for file in paths)
        folders = {self._source(name): name for name in self._packages}
        for path in sorted(manifestin.included(self._folder / "MANIFEST.in", files)):
            file = self._folder / path
            owner = next((each for each in file.parents if each in folders), None)
            if owner is None:
                continue
            inside, name = file.relative_to(owner).as_posix(), folders[owner]
            if inside not in _matching(owner, self._patterns("exclude_package_data", name)):
                installed = f"python/{name.replace('.', '/')}/{inside}"
                yield from self.placed(installed, file, "include_package_data")

    def _discovered(self) -> tuple[list[str], list[str]]:
        """Return the packages and modules that setuptools discovers if none are named."""
        source = self._folder / "src"
        if self._roots or not source.is_dir():
            top = self._folder / self._roots.get("", ".")
            return list(_regular_packages(top)), []
        self._roots = {"": "src"}
        packages = Files(self._folder, self._folder).packages("src", namespaces=True)
        return packages, [file.stem for file in sorted(source.glob("*.py"))]


def _matching(folder: Path, patterns: Iterable[str]) -> set[str]:
    """Return the files in `folder` that match a pattern."""
    found = {
        name
        for pattern in patterns
        for name in glob.glob(pattern, root_dir=folder, recursive=True, include_hidden=True)  # noqa: PTH207
    }
    return {os.path.normpath(name) for name in found if (folder / name).is_file()}


def _regular_packages(top: Path) -> Iterator[str]:
    for file in sorted(top.rglob("__init__.py")):
        parts = file.relative_to(top).parts[:-1]
        if parts and parts[0] not in NOT_MODULES and not any(p.startswith(".") for p in parts):
            yield ".".join(parts)
