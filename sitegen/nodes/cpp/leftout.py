"""What a package is built without, because no page can have the libraries that it needs.

CMake configures the package again without these. A library with plugins or components is left out
as a whole, because programs load them by name. Of another library, single sources are left out: a
program that the linker completes calls none of their functions.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path

from sitegen.nodes.cpp.diagnosis import lacks_library
from sitegen.nodes.cpp.store import write

# What is wrong with each package, target or source file.
Problems = Mapping[str, Sequence[str]]


@dataclass(frozen=True)
class LeftOut:
    """The libraries that are left out, by target, and the sources of others, by path."""

    libraries: Problems = field(default_factory=dict)
    sources: Problems = field(default_factory=dict)

    @property
    def definitions(self) -> list[str]:
        """The definitions that tell CMake (optional.cmake, finish.cmake)."""
        named = {"SITEGEN_LEFT_OUT": self.libraries, "SITEGEN_LEFT_OUT_SOURCES": self.sources}
        return [f"-D{name}={';'.join(each)}" for name, each in named.items()]

    def keep(self, tree: Path) -> None:
        """Write them to the build folder `tree`."""
        tree.mkdir(parents=True, exist_ok=True)
        write(_file(tree), json.dumps(asdict(self)).encode())

    @staticmethod
    def of(tree: Path) -> LeftOut:
        """Return what the package that is built in `tree` is configured without."""
        file = _file(tree)
        return (
            LeftOut(**json.loads(file.read_text(encoding="utf-8"))) if file.exists() else LeftOut()
        )


def more(tree: Path, failed: Mapping[str, Problems]) -> LeftOut | None:
    """Return what to leave out of the package that is built in `tree`; None if it is nothing new.

    `failed` has what sources that do not compile lack, by target and path.
    """
    before = LeftOut.of(tree)
    libraries, sources = dict(before.libraries), dict(before.sources)
    whole, others = _targets(tree / "optional.txt"), _targets(tree / "partial.txt")
    for target, files in failed.items():
        lacking = {
            file: lines for file, lines in files.items() if lines and all(map(lacks_library, lines))
        }
        if target in before.libraries:
            continue  # something else links it, so that it was built nevertheless
        if target in whole and len(lacking) == len(files):
            libraries[target] = [*dict.fromkeys(line for lines in files.values() for line in lines)]
        elif target in others:
            sources |= lacking
    found = LeftOut(libraries, sources)
    return None if found == before else found


def _targets(file: Path) -> list[str]:
    """Read what CMake wrote (optional.cmake, finish.cmake)."""
    return file.read_text(encoding="utf-8").split("\n") if file.exists() else []


def _file(tree: Path) -> Path:
    return tree / "left-out.json"
