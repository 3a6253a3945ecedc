"""Packages in C++ that tests write, and their site."""

from __future__ import annotations

import io
import re
from pathlib import Path
from textwrap import dedent

import pytest

from sitegen.commands.build import build
from sitegen.errors import SiteError
from sitegen.report import Report

CMAKE = """\
cmake_minimum_required(VERSION 3.8)
project({name})
find_package(ament_cmake REQUIRED)
{body}
ament_package()
"""


class Workspace:
    """A site with packages that a test writes."""

    def __init__(self, folder: Path, cache: Path) -> None:
        self.folder = folder
        self.cache = cache

    def write(self, path: str, text: str) -> None:
        file = self.folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(dedent(text))

    def package(self, name: str, body: str, *, depends: str = "", main: str = "") -> None:
        tags = "".join(f"<depend>{depend}</depend>" for depend in depends.split())
        self.write(
            f"src/{name}/package.xml",
            f"<package format='3'><name>{name}</name>{tags}</package>\n",
        )
        self.write(f"src/{name}/CMakeLists.txt", CMAKE.format(name=name, body=dedent(body)))
        if main:
            self.write(f"src/{name}/src/main.cpp", main)

    def site(self, *executables: str) -> None:
        """Write a site.yaml whose page has these nodes, `package/executable` each."""
        lines = ["site: {title: Test, asyncify: false}", "nodes:"]
        for number, executable in enumerate(executables):
            package, name = executable.split("/")
            lines.append(f"  n{number}: {{package: {package}, executable: {name}}}")
        consoles = ", ".join(f"console: n{number}" for number in range(len(executables)))
        lines.append(f"pages: [{{path: /, title: Test, content: [{consoles}]}}]")
        self.write("site.yaml", "\n".join(lines))

    def build(self) -> list[str]:
        """Build the site and return what was compiled, besides the library."""
        said = io.StringIO()
        build(self.folder, output=self.folder / "dist", report=Report(said))
        names = re.findall(r"^(\S+) \(current browsers\): compiling", said.getvalue(), re.M)
        return [name for name in names if name != "rclcpp"]

    def problems(self) -> list[str]:
        with pytest.raises(SiteError) as wrong:
            self.build()
        return wrong.value.lines

    def compiled(self) -> dict[str, int]:
        """When each object file was last written."""
        found = self.cache.glob("work/*/jspi/packages/*/**/*.o")
        return {file.name: file.stat().st_mtime_ns for file in found}

    def changed(self, before: dict[str, int]) -> set[str]:
        """The objects compiled since `before`."""
        return {name for name, time in self.compiled().items() if before.get(name) != time}
