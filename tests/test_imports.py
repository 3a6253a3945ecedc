"""The direction of imports, as docs/architecture.md draws it."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PACKAGE = ROOT / "sitegen"
RUNTIME = PACKAGE / "runtime"

# The rooms of the generator. A module may import what stands before its own room, and its own.
ROOMS = (
    *("errors", "shipped", "ignored", "report", "options", "model", "cache", "workspace"),
    *("launch", "config", "interfaces", "nodes", "site", "build", "commands", "__main__"),
)

# The same for the browser's modules; a folder stands for all that is in it.
RUNTIME_ALLOWED = {
    "rosMain.js": {
        *{"graph.js", "isolation.js", "nodeProcess.js", "pageClient.js", "place.js", "protocol.js"},
        *{"sharing.js", "workerGroup.js"},
    },
    "interrupt.js": set(),
    "isolation.js": {"elements.js", "place.js", "words.js"},
    "place.js": set(),
    "sharing.js": {"elements.js", "protocol.js", "words.js"},
    "words.js": {"place.js"},
    "words": set(),
    "filter": {"filter"},
    "pageClient.js": {"graph.js", "messages", "participant", "protocol.js", "words.js"},
    "messages": {"elements.js", "messages", "protocol.js", "vendor", "words.js"},
    "participant": {"participant", "protocol.js"},
    "nodeProcess.js": {
        *{"graph.js", "interrupt.js", "isolation.js", "place.js", "protocol.js", "workerGroup.js"},
    },
    "workerGroup.js": {"interrupt.js", "place.js", "protocol.js"},
    "graph.js": {"protocol.js"},
    "protocol.js": set(),
    "workers": {
        "filter",
        "interrupt.js",
        "messages",
        "participant",
        "place.js",
        "protocol.js",
        "vendor",
        "workers",
    },
    "codeView.js": {"vendor"},
    "drawing.js": {"elements.js", "words.js"},
    "elements.js": set(),
    "looking.js": set(),
    "keyboard.js": {"elements.js", "protocol.js", "words.js"},
    "lines.js": {"elements.js", "protocol.js", "words.js"},
    "searchIndex.js": {"vendor"},
    "robots": {"drawing.js", "elements.js", "protocol.js", "robots", "words.js"},
    "widgets": {
        *{
            "codeView.js",
            "drawing.js",
            "elements.js",
            "lines.js",
            "looking.js",
            "messages",
            "place.js",
            "protocol.js",
            "robots",
        },
        *{"vendor", "words.js"},
    },
}
MODULES = sorted(file for file in RUNTIME.rglob("*.js") if file.parent.name != "vendor")


def room(file: Path) -> str:
    """The room of a module: the folder at the top of the package, or the file itself."""
    return file.relative_to(PACKAGE).parts[0].removesuffix(".py")


def imported(file: Path) -> set[str]:
    """The rooms that a module imports from."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.ImportFrom) and node.module == "sitegen":
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and (node.module or "").startswith("sitegen."):
            names.add((node.module or "").split(".")[1])
    return names - {"__version__"}


def generator_modules() -> list[Path]:
    """The modules of the generator, without those that run in pages or are templates."""
    rooms = (file for name in ROOMS for file in (PACKAGE / name).rglob("*.py"))
    files = [*PACKAGE.glob("*.py"), *(file for file in rooms if "templates" not in file.parts)]
    return sorted(file for file in files if file != PACKAGE / "__init__.py")


@pytest.mark.parametrize("name", ROOMS)
def test_rooms_import_only_those_before_them(name: str) -> None:
    allowed = {*ROOMS[: ROOMS.index(name) + 1]}
    wrong = {
        file.relative_to(PACKAGE).as_posix(): extra
        for file in generator_modules()
        if room(file) == name and (extra := imported(file) - allowed)
    }
    assert wrong == {}


def test_every_module_is_in_a_room() -> None:
    assert {room(file) for file in generator_modules()} == {*ROOMS}


@pytest.mark.parametrize("file", MODULES, ids=lambda file: file.name)
def test_runtime_imports_only_what_it_may(file: Path) -> None:
    def runtime_room(path: Path) -> str:
        return path.relative_to(RUNTIME).parts[0]

    paths = re.findall(r'(?:from|import)\(?\s*"(\.[^"]+)"', file.read_text())
    used = {runtime_room((file.parent / path).resolve()) for path in paths}
    assert used <= RUNTIME_ALLOWED[runtime_room(file)]
    # Types count too: one of a comment is one that a reader has to follow.
    widgets = [path for path in paths if runtime_room(file) == "widgets" and path.startswith("./")]
    assert widgets == [], "widgets do not know one another"
