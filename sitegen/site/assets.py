"""Collect the files of the browser runtime that a site uses."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

from sitegen.model import Artifact, Page, Programs, Site, Widget
from sitegen.nodes.python import pyodide
from sitegen.shipped import RUNTIME, VENDOR

# Widgets that only start programs and show what they print; all others take part in the graph.
PLAIN = {"buttons", "console", "editor", "prompt"}
IMPORT = re.compile(r'^import [^;]*? from "(\.[^"]+)";', re.MULTILINE)


def takes_part(page: Page) -> bool:
    """Return whether a widget of `page` takes part in the graph."""
    return any(widget.kind not in PLAIN for widget in _widgets([page]))


def runtime(site: Site, programs: Programs, *, debug: bool = False) -> list[Artifact]:
    """Return the runtime's files, with only those widgets that a page shows and what they import.

    A site without nodes needs none of them; `debug` adds what tells where programs are.
    """
    files = {file for page in site.pages for file in _modules(site, page)}
    if not files:
        return []
    nodes = (node for page in site.pages for node in page.nodes.values())
    workers = {programs[node.program].worker for node in nodes}
    files |= set(_with_imports(RUNTIME / "workers" / f"{worker}.js" for worker in workers))
    if "cpp/cppNode" in workers:
        # Loaded by programs that use content filters.
        files |= set((RUNTIME / "messages" / "filter").iterdir())
    if debug:
        files.add(RUNTIME / "workers" / "cpp" / "stackTrace.js")
    if any(widget.kind == "console" for widget in _widgets(site.pages)):
        # Loaded by consoles whose program reads its input.
        files |= set(_with_imports([RUNTIME / "ui" / "keyboard.js"]))
    if "python/pythonNode" in workers:
        files |= set(_with_imports([RUNTIME / "workers" / "python" / "pythonSync.js"]))
        files |= set(pyodide.files())
    if any(file.is_relative_to(VENDOR) for file in files):
        files.add(VENDOR / "licenses.txt")
    return [Artifact(f"runtime/{f.relative_to(RUNTIME).as_posix()}", f) for f in sorted(files)]


def search(site: Site) -> list[Artifact]:
    """Return the modules that the search of a site needs: one that has more than one page."""
    if len(site.pages) < 2:
        return []
    files = [*_with_imports([RUNTIME / "page" / "searchIndex.js"]), VENDOR / "licenses.txt"]
    return [Artifact(f"runtime/{f.relative_to(RUNTIME).as_posix()}", f) for f in files]


def preloads(site: Site) -> dict[str, list[str]]:
    """Return, by page path, the modules that the page loads as soon as it can: all but rosMain.js.

    Named in the page's head they come at once; otherwise each would be asked for by the one before.
    """
    return {
        page.path: [
            f"runtime/{f.relative_to(RUNTIME).as_posix()}" for f in _modules(site, page)[1:]
        ]
        for page in site.pages
    }


def _modules(site: Site, page: Page) -> list[Path]:
    """Return the modules that `page` runs, rosMain.js first; none if it shows no widget."""
    widgets = list(_widgets([page]))
    if not widgets:
        return []
    files = [RUNTIME / "rosMain.js"]
    if takes_part(page):
        files.append(RUNTIME / "page" / "pageClient.js")
    files += (RUNTIME / "widgets" / f"{widget.kind}.js" for widget in widgets)
    robots = (widget for widget in widgets if widget.kind == "robot")
    files += (RUNTIME / "widgets" / "robots" / f"{robot.options['kind']}.js" for robot in robots)
    # What widgets say in the language of the page; English stands in the code.
    language = (page.language or site.language).partition("-")[0].lower()
    words = RUNTIME / "ui" / "words" / f"{language}.js"
    return _with_imports([*files, words] if words.is_file() else files)


def _with_imports(files: Iterable[Path]) -> list[Path]:
    """Return `files` and all that they import, each once."""
    found: dict[Path, None] = {}
    waiting = list(files)
    while waiting:
        file = waiting.pop(0)
        if file not in found:
            found[file] = None
            names = IMPORT.findall(file.read_text(encoding="utf-8"))
            waiting += [(file.parent / name).resolve() for name in names]
    return list(found)


def _widgets(shown: Iterable[Page]) -> Iterable[Widget]:
    return (part for page in shown for part in page.leaves if isinstance(part, Widget))
