"""The direction of imports, as docs/architecture.md draws it."""

from __future__ import annotations

import subprocess
from collections.abc import Mapping
from graphlib import TopologicalSorter
from pathlib import Path

import pytest
from imports import imported_first, imported_names
from paths import ROOT

from sitegen.report import Report
from sitegen.site import bundles

PACKAGE = ROOT / "sitegen"
RUNTIME = PACKAGE / "runtime"

# The rooms of the generator. A module may import what stands before its own room, and its own.
ROOMS = (
    *("errors", "shipped", "ignored", "pagepath", "mediatype", "report", "yamlnodes", "rclyaml"),
    "rowe",
    "options",
    *("model", "cache", "workspace", "launch", "config", "interfaces", "nodes", "site", "build"),
    *("gateway", "commands", "__main__"),
)

# The same for the browser's modules. Rooms that stand together in a line do not know one another.
RUNTIME_ROOMS = (
    {
        "protocol.js",
        "budgets.js",
        "graphNames.js",
        "place.js",
        "engine.js",
        "interrupt.js",
        "vendor",
    },
    {"worker.js"},
    {"ui"},
    {"messages"},
    {"participant"},
    {"bag"},
    {"gateway"},
    {"launch"},
    {"terminal"},
    {"page", "workers", "widgets"},
    {"client"},
    {"rosbridge"},
    {"jupyter", "rosMain.js"},
)
MODULES = sorted(file for file in RUNTIME.rglob("*.js") if file.parent.name != "vendor")


def room(file: Path) -> str:
    """The room of a module: the folder at the top of the package, or the file itself."""
    return file.relative_to(PACKAGE).parts[0].removesuffix(".py")


def imported(file: Path) -> set[str]:
    """The rooms that a module imports from."""
    names = [name.split(".") for name in imported_names(file)]
    return {name[1] for name in names if name[0] == "sitegen"} - {"__version__"}


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


def test_no_modules_import_each_other() -> None:
    modules = {
        ".".join(file.relative_to(ROOT).with_suffix("").parts): file for file in generator_modules()
    }
    imports = {
        name: {
            module
            for one in imported_first(file)
            # A name may be one of a module, or the module itself.
            for module in (one, one.rpartition(".")[0])
            if module in modules
        }
        for name, file in modules.items()
    }
    assert "sitegen.nodes.cpp.libraries" in imports["sitegen.nodes.cpp.toolchain"]
    order = [*TopologicalSorter(imports).static_order()]  # an error tells a circle
    assert {*order} == {*modules}


def runtime_room(file: Path) -> str:
    """The room of a module of the browser: its folder, or the file itself."""
    return file.relative_to(RUNTIME).parts[0]


@pytest.fixture(scope="module")
def graph() -> Mapping[str, set[str]]:
    """What each module of the browser imports, types included: readers have to follow those, too.

    esbuild knows the modules, and TypeScript those that only comments name.
    """
    bundles.refresh(Report())
    found = {name: {*names} for name, names in bundles.imports().items()}
    for project in ("tsconfig.json", "tsconfig.workers.json"):
        command = ["node_modules/.bin/tsc", "--project", project, "--traceResolution"]
        done = subprocess.run(command, cwd=ROOT, text=True, capture_output=True)
        assert done.returncode == 0, done.stdout
        for line in done.stdout.splitlines():
            match line.split("'"):
                case ["======== Resolving module ", name, " from ", file, _] if name[0] == ".":
                    if Path(file).is_relative_to(RUNTIME):
                        path = (Path(file).parent / name).resolve()
                        own = Path(file).relative_to(RUNTIME).as_posix()
                        found.setdefault(own, set()).add(path.relative_to(RUNTIME).as_posix())
    return found


def test_every_module_is_in_a_bundle(graph: Mapping[str, set[str]]) -> None:
    names = {file.relative_to(RUNTIME).as_posix() for file in MODULES}
    # One may be there for its types only.
    used = set(bundles.imports()).union(*graph.values())
    assert names - used == set()
    assert "protocol.js" in graph["page/nodeProcess.js"], "whose comments name it"


@pytest.mark.parametrize("file", MODULES, ids=lambda file: file.name)
def test_runtime_imports_only_rooms_before_its_own(
    file: Path, graph: Mapping[str, set[str]]
) -> None:
    found = [RUNTIME / name for name in graph.get(file.relative_to(RUNTIME).as_posix(), ())]
    own = runtime_room(file)
    [place] = (at for at, rooms in enumerate(RUNTIME_ROOMS) if own in rooms)
    assert {runtime_room(path) for path in found} <= {own}.union(*RUNTIME_ROOMS[:place])
    widgets = RUNTIME / "widgets"
    others = [path.name for path in found if file.parent == path.parent == widgets]
    assert others == [], "widgets do not know one another"
