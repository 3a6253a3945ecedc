"""Collect the files of the browser runtime that a site uses."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from sitegen.config.notebooks import JAVASCRIPT
from sitegen.model import Artifact, Page, Programs, Python, Site, Widget
from sitegen.nodes.python import pyodide
from sitegen.shipped import BUNDLES, RUNTIME, VENDOR
from sitegen.site import bundles, launches

# Widgets that only start programs and show their output; all others take part in the graph.
PLAIN = {"buttons", "console", "editor", "prompt", JAVASCRIPT}
START = "rosMain.js"
# The widgets whose cells can show panels, and the panels that the module jupyros describes.
CELLS = {"jupyter", "notebook"}
IN_CELLS = (
    *("3d", "actions", "bag", "image", "joints", "parameters", "plot", "publish", "services"),
    *("tf", "topics"),
)
JAVASCRIPT_WORKER = "workers/javascript/javascriptNode.js"
# What other pages load to use the graph of one.
OUTSIDE = "rosbridge/outside.js"


def is_live(page: Page) -> bool:
    """Return whether `page` runs something."""
    return bool(page.scripts) or any(True for _ in _widgets([page]))


def takes_part(site: Site, page: Page) -> bool:
    """Return whether `page` itself is a participant of the graph."""
    if page.scripts or site.messages_from:
        return is_live(page)
    return any(widget.kind not in PLAIN for widget in _widgets([page]))


def shown_kinds(page: Page) -> set[str]:
    """Return the kinds of the widgets of `page`, and of those that cells on it may show."""
    kinds = {widget.kind for widget in _widgets([page])}
    if JAVASCRIPT in kinds:
        # It looks like those of Python.
        kinds.add("cell")
    return kinds | {*IN_CELLS} if kinds & CELLS else kinds


def isolates(site: Site, page: Page) -> bool:
    """Return whether `page` requests cross-origin isolation, which only Python nodes need."""
    return bool(site.isolate) and any(isinstance(n.kind, Python) for n in page.nodes.values())


def runtime(site: Site, programs: Programs, *, debug: bool = False) -> list[Artifact]:
    """Return the files of the runtime, with only the widgets that a page shows and their imports.

    A site without nodes needs none of them. `debug` adds the stack traces of C++ programs, and the
    modules that the bundles were made from, for the developer tools of browsers.
    """
    names = {name for page in site.pages for name in _start(site, page)}
    if not names:
        return []
    # Loaded for those who come by a shared link, or when a script of a page fails.
    names.add("page/notice.js")
    kinds = {kind for page in site.pages for kind in shown_kinds(page)}
    if kinds & CELLS:
        panels = (f"widgets/{kind}.js" for kind in IN_CELLS)
        names |= {"widgets/cell/panel.js", *bundles.with_imports([*panels])}
    nodes = [node for page in site.pages for node in page.nodes.values()]
    workers = {programs[node.program].worker for node in nodes}
    names |= {f"workers/{worker}.js" for worker in workers}
    if "cpp/cppNode" in workers:
        # Loaded by programs that use content filters, and by those that open files.
        names |= {"messages/filter/contentFilter.js", "workers/cpp/packageFiles.js"}
    if debug:
        names.add("workers/cpp/stackTrace.js")
    if kinds & {"bag", "terminal"}:
        # The player and the recorder, and what only recorders load.
        names |= {"workers/bag/bagNode.js", "bag/zstd.js"}
    if JAVASCRIPT in kinds:
        names.add(JAVASCRIPT_WORKER)
    if "connect" in kinds:
        # The second is loaded when a server speaks rosbridge.
        names |= {"workers/gateway/gatewayNode.js", "rosbridge/robot/bridge.js"}
    if "console" in kinds:
        # Loaded by consoles whose program reads its input.
        names.add("ui/keyboard.js")
    if any(widget.options.get("kind") == "vernie" for widget in _widgets(site.pages)):
        # Loaded by visitors who connect the real robot.
        names.add("widgets/robots/parts/moveHub.js")
    if "jupyter" in kinds:
        names |= {"jupyter/extension.js", "jupyter/ownGraph.js", "jupyter/panel.js"}
    if "buttons" in kinds:
        # Loaded by visitors who open the options of a node.
        names.add("widgets/buttons/options.js")
    if "parameters" in kinds:
        # Loaded by visitors who load a file of parameters.
        names.add("messages/parameters/fileReader.js")
    if "3d" in kinds:
        # Loaded when a visitor adds a camera.
        names.add("widgets/image/decode.js")
    if kinds & {"console", "prompt"}:
        # Loaded when a visitor wants to find, copy or save lines.
        names.add("ui/lineTools.js")
    if kinds & {"console", "prompt", "launch"}:
        # Loaded when a program prints colors.
        names.add("ui/escapes.js")
    if any(widget.is_docked for widget in _widgets(site.pages)):
        # Loaded when a visitor runs a command of the text.
        names.add("widgets/terminal.js")
    if site.messages_from:
        names |= {OUTSIDE, "rosbridge/rosbridge.js"}
    files: list[Path] = []
    relaunches = any(launches.reads(page) for page in site.pages)
    if relaunches:
        names.add("workers/launch/launchReader.js")
    if relaunches or any(node.environment for node in nodes):
        names.add("workers/environment.js")
    if "python/pythonNode" in workers:
        names.add("workers/python/pythonSync.js")
    if relaunches or "python/pythonNode" in workers:
        files += pyodide.files()
    if files or _libraries(names):
        files.append(VENDOR / "licenses.txt")
    own = [one for name in sorted(names) for one in _artifacts(name, debug=debug)]
    return own + [_vendored(file) for file in sorted(files)]


def search(site: Site) -> list[Artifact]:
    """Return the modules of the search, which a site with more than one page needs."""
    if len(site.pages) < 2:
        return []
    return [*_artifacts("page/searchIndex.js"), _vendored(VENDOR / "licenses.txt")]


def preloads(site: Site, page: Page) -> list[str]:
    """Return the modules that `page` loads when it starts, by path, without rosMain.js.

    The page's head names them, so that the browser requests all of them at once.
    """
    return [f"runtime/{name}" for name in _start(site, page)[1:]]


def _start(site: Site, page: Page) -> list[str]:
    """Return the bundles that `page` runs, rosMain.js first; none if it shows no widget."""
    widgets = list(_widgets([page]))
    if not is_live(page):
        return []
    names = [START]
    if takes_part(site, page):
        names.append("page/pageClient.js")
    kinds = (f"widgets/{'dock' if widget.is_docked else widget.kind}.js" for widget in widgets)
    # The other bundles came with rosMain.js.
    names += (name for name in kinds if name in bundles.bundles())
    robots = (widget for widget in widgets if widget.kind == "robot")
    names += (f"widgets/robots/{robot.options['kind']}.js" for robot in robots)
    if isolates(site, page):
        names.append("page/isolation.js")
    if any(widget.options.get("captions") for widget in widgets):
        names.append("ui/caption.js")
    # The texts of widgets in the language of the page; the English texts are in the code.
    language = (page.language or site.language).partition("-")[0].lower()
    words = f"ui/words/{language}.js"
    return bundles.with_imports([*names, words] if words in bundles.bundles() else names)


def _libraries(names: Iterable[str]) -> bool:
    """Return whether one of the bundles `names` contains a third-party library."""
    modules = (module for name in names for module in bundles.bundles()[name].modules)
    return any(module.startswith("vendor/") for module in modules)


def _artifacts(name: str, *, debug: bool = False) -> Sequence[Artifact]:
    """Return a bundle; with `debug`, browsers show the modules that it was made from."""
    path, file = f"runtime/{name}", BUNDLES / name
    if not debug:
        return [Artifact(path, file)]
    lines = f"{name}.map"
    linked = f"{file.read_text(encoding='utf-8')}//# sourceMappingURL={Path(lines).name}\n"
    return [Artifact(path, linked.encode()), Artifact(f"runtime/{lines}", BUNDLES / lines)]


def _vendored(file: Path) -> Artifact:
    return Artifact(f"runtime/{file.relative_to(RUNTIME).as_posix()}", file)


def _widgets(shown: Iterable[Page]) -> Iterable[Widget]:
    return (part for page in shown for part in page.leaves if isinstance(part, Widget))
