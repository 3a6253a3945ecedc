"""The direction of imports, as docs/architecture.md draws it."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PACKAGE = ROOT / "sitegen"
RUNTIME = PACKAGE / "runtime"

# What each module of the generator may import of the others; a folder is one module here.
ALLOWED = {
    "__main__": {
        *("build", "cache", "check", "compile", "config", "deploy", "errors", "init", "new"),
        *("report", "serve", "theme", "unchanged"),
    },
    "archive": {"model"},
    "bytecode": set(),
    "cache": set(),
    "unchanged": set(),
    "build": {
        *(
            "assets",
            "cache",
            "compiled",
            "config",
            "containers",
            "cpp",
            "errors",
            "model",
            "offline",
            "pages",
        ),
        *("python", "report", "ros2wasm", "single", "unchanged", "workspace"),
    },
    "assets": {"digest", "model"},
    "compile": {"archive", "build", "cache", "cpp", "errors", "model", "report", "workspace"},
    "compiled": {"archive", "errors", "fetch", "model", "report"},
    "containers": {"model"},
    "config": {
        *("containers", "errors", "fetch", "launch", "model", "parameterfiles", "theme"),
        "workspace",
    },
    "check": {"build", "cache", "descriptions", "errors", "model", "prose", "report", "wiring"},
    "cmakelists": {"cmakescript"},
    "cmakescript": set(),
    "cmake": {"model", "toolchain"},
    "cpp": {
        *("cache", "cmake", "diagnosis", "digest", "errors", "interfaces", "messages", "model"),
        *("report", "sourcemap", "toolchain"),
    },
    "definitions": {"errors"},
    "deploy": {"build", "config", "errors", "git", "model", "report"},
    "descriptions": {"cache", "digest", "errors", "interfaces", "model", "workspace"},
    "diagnosis": {"errors", "interfaces", "model"},
    "digest": set(),
    "errors": set(),
    "fetch": set(),
    "sourcemap": set(),
    "git": {"errors"},
    "github": {"errors"},
    "init": {
        *("config", "errors", "github", "lacking", "launch", "model", "python", "report"),
        *("wheels", "workspace"),
    },
    "interfaces": {"definitions", "errors", "typesupport"},
    "imports": {"errors"},
    "lacking": {"model"},
    "launch": {"containers", "errors", "model", "parameterfiles"},
    "literals": set(),
    "messages": {"interfaces", "typesupport"},
    "model": {"errors"},
    "new": {"errors"},
    "offline": {"model"},
    "pages": {"errors", "model", "prose", "theme"},
    "parameterfiles": set(),
    "precompiled": set(),
    "prose": {"errors", "model"},
    "report": set(),
    "python": {
        *("bytecode", "descriptions", "errors", "imports", "interfaces", "messages", "model"),
        *("wheel", "wheels", "workspace"),
    },
    "requirements": {"digest", "errors", "wheel"},
    "ros2wasm": {"descriptions", "messages", "model"},
    "serve": {"build", "config", "errors", "model", "offline", "report"},
    "setupfiles": {"literals"},
    "single": {"model"},
    "theme": {"errors"},
    "toolchain": set(),
    "typesupport": set(),
    "wiring": {"errors", "model"},
    "wheel": set(),
    "wheels": {"errors", "fetch", "imports", "model", "requirements", "wheel"},
    "workspace": {"cmakelists", "errors", "model", "setupfiles"},
}

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
FOLDERS = ("config", "launch", "offline", "pages", "prose", "single", "wiring")
MODULES = sorted(file for file in RUNTIME.rglob("*.js") if file.parent.name != "vendor")


def modules() -> dict[str, list[Path]]:
    """The generator's modules by name, a package with all of its files."""
    found = {file.stem: [file] for file in PACKAGE.glob("*.py") if file.stem != "__init__"}
    for name in FOLDERS:
        found[name] = sorted((PACKAGE / name).rglob("*.py"))
    return found


def imported(files: list[Path]) -> set[str]:
    names: set[str] = set()
    for file in files:
        for node in ast.walk(ast.parse(file.read_text())):
            if isinstance(node, ast.ImportFrom) and node.module == "sitegen":
                names |= {alias.name for alias in node.names}
            elif isinstance(node, ast.ImportFrom) and (node.module or "").startswith("sitegen."):
                names.add((node.module or "").split(".")[1])
    return names - {"__version__"}


@pytest.mark.parametrize("name", sorted(modules()))
def test_modules_import_only_what_they_may(name: str) -> None:
    assert imported(modules()[name]) - {name} <= ALLOWED[name]


@pytest.mark.parametrize("file", MODULES, ids=lambda file: file.name)
def test_runtime_imports_only_what_it_may(file: Path) -> None:
    def room(path: Path) -> str:
        return path.relative_to(RUNTIME).parts[0]

    paths = re.findall(r'(?:from|import)\(?\s*"(\.[^"]+)"', file.read_text())
    used = {room((file.parent / path).resolve()) for path in paths}
    assert used <= RUNTIME_ALLOWED[room(file)]
    # Types count too: one of a comment is one that a reader has to follow.
    widgets = [path for path in paths if room(file) == "widgets" and path.startswith("./")]
    assert widgets == [], "widgets do not know one another"
