"""Packages that tests write, and that only CMake and the compiler process, without a link step."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from packages import CMAKE

from sitegen.interfaces import generator
from sitegen.model import BuildSettings
from sitegen.nodes.cpp import libraries
from sitegen.nodes.cpp.cmake import CMake
from sitegen.nodes.cpp.diagnosis import Diagnosis
from sitegen.nodes.cpp.toolchain import Toolchain
from sitegen.shipped import CLIENTS, PACKAGES, ROS
from sitegen.workspace import scan


class Configuring:
    """Configures packages in the order of `configure`; each finds those before it."""

    def __init__(self, cmake: CMake, folder: Path) -> None:
        self._cmake = cmake
        self.folder = folder
        self.settings: Mapping[str, BuildSettings] = {}

    def write(self, path: str, text: str) -> None:
        file = self.folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def package(self, name: str, body: str, *, tags: str = "", main: str = "") -> None:
        """Write a package that finds ament_cmake; a `body` with project() is the whole file."""
        whole = body if "project(" in body else CMAKE.format(name=name, body=body)
        self.write(
            f"{name}/package.xml",
            f"<package format='3'><name>{name}</name><version>1.2.3</version>{tags}</package>\n",
        )
        self.write(f"{name}/CMakeLists.txt", whole)
        self.write(f"{name}/src/main.cpp", main or "int main() {}\n")

    def configure(self, *names: str, needs: Sequence[str] = ()) -> str:
        """Return what CMake says of the first package that fails, or "".

        Each finds those before it, and `needs`, which are not configured.
        """
        packages = scan(self.folder, self.settings)
        for at, name in enumerate(names):
            before = [packages[one] for one in (*needs, *names[:at])]
            done = self._cmake.configure(packages[name], before, name)
            if done.returncode:
                return " ".join(done.stdout.split())
        return ""

    def output(self, name: str) -> str:
        """Configure one package, and return what CMake prints."""
        return self._cmake.configure(scan(self.folder, self.settings)[name], [], name).stdout

    def compile(self, name: str, program: str) -> str:
        """Compile src/main.cpp of a `program` and return the errors."""
        made = f"CMakeFiles/{program}.dir/src/main.cpp.o"
        done = self._cmake.make(scan(self.folder)[name], made)
        return done.stdout if done.returncode else ""

    def explain(self, name: str, program: str) -> list[str]:
        """Compile like compile(), and return what the build says of the errors."""
        package = scan(self.folder)[name]
        diagnosis = Diagnosis(self.folder, package)
        return diagnosis.of_build(program, self.compile(name, program), self._cmake.tree(package))

    def lacking(self, name: str, program: str) -> list[str]:
        """Compile like compile(), and return what the build says of headers that are missing."""
        package = scan(self.folder)[name]
        outputs = {program: self.compile(name, program)}
        return Diagnosis(self.folder, package).of_builds(outputs, self._cmake.tree(package), {})

    def tree(self, name: str) -> Path:
        return self._cmake.tree(scan(self.folder, self.settings)[name])


def header_folders(prefix: Path) -> list[Path]:
    """Return the folders of the headers of the page; those that are generated go to `prefix`."""
    generator.write_ros(prefix)
    generator.write_shipped(prefix)
    return [
        *(CLIENTS / "cpp" / name for name in ("system", "include")),
        *sorted(PACKAGES.glob("*/include")),
        *sorted((prefix / "include").iterdir()),
        *sorted((ROS / "include").iterdir()),
    ]


def cmake_for_tests(work: Path) -> CMake:
    """Return a CMake with the interfaces of ROS and without the rclcpp library."""
    tools = Toolchain.find()
    cmake = CMake(tools, work, "jspi")
    if not cmake.ros.exists():
        generator.write_ros(cmake.ros)
        generator.write_shipped(cmake.ros)
        libraries.write(cmake.ros)
        libraries.link(cmake.headers, tools.eigen)
        cmake.library.parent.mkdir(parents=True)
        cmake.library.touch()
    return cmake
