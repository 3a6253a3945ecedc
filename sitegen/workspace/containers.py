"""Make a package for a component container: a program that its components are linked into."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from pathlib import Path

from sitegen.model import Component, Container, Package

PACKAGE = "rclcpp_components"
# The executables of upstream's package and their executors. In place of one thread for each
# component, all components share one thread.
EXECUTORS = {
    "component_container": "SingleThreadedExecutor",
    "component_container_mt": "MultiThreadedExecutor",
    "component_container_isolated": "SingleThreadedExecutor",
}
LIST = """cmake_minimum_required(VERSION 3.16)
project(container)
find_package(ament_cmake REQUIRED)
find_package(rclcpp_components REQUIRED)
{find}
sitegen_add_container({name} {executor} {components})
ament_package()
"""


def executable(container: str, components: list[Component]) -> str:
    """Return the name of the program for `container` with these components."""
    digest = hashlib.sha256("\n".join(_classes(components)).encode()).hexdigest()[:8]
    return f"{container}-{digest}"


def package(
    name: str, container: Container, packages: Mapping[str, Package], cache: Path
) -> Package:
    """Return a package with the executable `name` of `container`, written to the cache."""
    names = sorted({component.package for component in container.components})
    text = LIST.format(
        find="\n".join(f"find_package({each} REQUIRED)" for each in names),
        name=name,
        executor=EXECUTORS[name.partition("-")[0]],
        components=" ".join(f'"{item}"' for item in _classes(container.components)),
    )
    folder = cache / "containers" / hashlib.sha256(text.encode()).hexdigest()[:20]
    file = folder / "CMakeLists.txt"
    if not file.exists():
        folder.mkdir(parents=True, exist_ok=True)
        draft = file.with_suffix(".draft")
        draft.write_text(text)
        draft.replace(file)
    depends = tuple(each for each in names if each in packages)
    return Package(PACKAGE, folder, "ament_cmake", depends, (name,), ())


def _classes(components: tuple[Component, ...] | list[Component]) -> list[str]:
    return sorted({f"{each.package}@{each.plugin}" for each in components})
