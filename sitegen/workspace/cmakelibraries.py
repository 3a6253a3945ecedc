"""Find the libraries of a package, and which of its programs are linked to them."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

ADDS_LIBRARY = ("add_library", "ament_auto_add_library")
COMMANDS = {
    *(*ADDS_LIBRARY, "ament_auto_add_executable", "rclcpp_components_register_node"),
    *("target_link_libraries", "target_sources"),
}
SOURCES = (".c", ".cc", ".cpp", ".cxx")


@dataclass
class Libraries:
    """The targets of the package in `folder`: their sources, and the targets they are linked to.

    A name that is no target is of another package, or a keyword of CMake.
    """

    folder: Path
    _sources: dict[str, list[str]] = field(default_factory=dict)
    _links: dict[str, list[str]] = field(default_factory=dict)
    # Every later program of ament_cmake_auto is linked to these.
    _auto: list[str] = field(default_factory=list)

    def add(self, name: str, words: Sequence[str], here: Path) -> None:
        """Process one of COMMANDS and its values in the CMakeLists.txt of the folder `here`."""
        if name not in COMMANDS or not words:
            return
        target, *rest = words
        links = self._links.setdefault(target, [])
        if name == "rclcpp_components_register_node" and "EXECUTABLE" in rest[:-1]:
            program = rest[rest.index("EXECUTABLE") + 1]
            self._links.setdefault(program, []).append(target)
        elif name == "target_link_libraries" or "ALIAS" in rest[:1]:
            links += rest
        elif name == "ament_auto_add_executable":
            links += [] if "NO_TARGET_LINK_LIBRARIES" in rest else self._auto
        elif name in (*ADDS_LIBRARY, "target_sources"):
            self._sources.setdefault(target, []).extend(self.files(rest, here))
            self._auto += [target] if name == "ament_auto_add_library" else []

    def rename(self, target: str, name: str) -> None:
        """Note that the program of a target has another name."""
        self._links[name] = self._links.pop(target, [])

    def of(self, program: str) -> list[str]:
        """Return the sources of all libraries that a program is linked to."""
        found: dict[str, None] = {}
        waiting = [*self._links.get(program, ())]
        seen = {program}
        while waiting:
            target = waiting.pop(0)
            if target not in seen:
                seen.add(target)
                found |= dict.fromkeys(self._sources.get(target, ()))
                waiting += self._links.get(target, ())
        return list(found)

    def files(self, words: Sequence[str], here: Path) -> list[str]:
        """Return the source files among the arguments of a command, relative to the package."""
        files = [here / word for word in words if word.endswith(SOURCES) and "$" not in word]
        if "DIRECTORY" in words[:-1]:  # of ament_cmake_auto
            folder = here / words[words.index("DIRECTORY") + 1]
            files += sorted(file for file in folder.rglob("*") if file.suffix in SOURCES)
        return [Path(os.path.relpath(file, self.folder)).as_posix() for file in files]
