"""Turn the Site's pages into HTML, one page.json for each that runs nodes, and their files."""

from __future__ import annotations

import base64
import hashlib
import itertools
import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import jinja2
from markupsafe import Markup

from sitegen.errors import Problems
from sitegen.model import Artifact, Markdown, Node, Page, Site, Widget
from sitegen.prose import Prose, address, sources

# Browsers start no worker in a page that was opened as a file, so the page says what to do.
FILE_NOTE = (
    'if (location.protocol === "file:") document.getElementById("file-note").hidden = false;'
)


class Link(NamedTuple):
    """A line of the menu: `depth` is how far below the top, `current` whether we are there."""

    title: str
    href: str
    depth: int = 0
    current: bool = False


@dataclass(frozen=True)
class Slot:
    """The place of a widget in the page: the `id` of its element, which page.json names too."""

    id: str
    kind: str


@dataclass(frozen=True)
class Panel:
    """Neighbouring widgets of one node, shown as one thing, or one that is about all nodes."""

    title: str
    slots: tuple[Slot, ...]


@dataclass(frozen=True)
class Block:
    """A stretch of the page: text, or a row of panels."""

    html: str = ""
    panels: tuple[Panel, ...] = ()


def render(
    site: Site,
    *,
    modules: Mapping[str, Sequence[str]] | None = None,
    types: Mapping[str, Mapping[str, object]] | None = None,
    foreign: Mapping[str, Mapping[str, Mapping[str, object]]] | None = None,
) -> list[Artifact]:
    """Return the artifacts of all pages and of the theme.

    `modules` names, by page path, the modules inside `dist/` that the page loads beside rosMain.js;
    `types` has, by page path, the message types of pages that take part in the graph; `foreign`
    has, by page path and node, those of nodes that the ROS2WASM project compiled.
    """
    problems = Problems(site.root)
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(site.theme),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    template = environment.get_template("page.html")
    shown = sources(site)
    menu = Menu(site)
    artifacts: list[Artifact] = []
    neighbours = zip((None, *site.pages), site.pages, (*site.pages[1:], None), strict=False)
    for previous, page, following in neighbours:
        prose = Prose(site, page, shown, problems)
        blocks = list(_blocks(page, prose))
        text = "".join(block.html for block in blocks)
        live = any(block.panels for block in blocks)
        html = template.render(
            site=site,
            page=page,
            blocks=blocks,
            has_heading="<h1" in text,
            live=live,
            menu=menu.seen_from(page),
            previous=_link(page, previous),
            next=_link(page, following),
            home=address(page, ""),
            theme=address(page, "theme/"),
            runtime=address(page, "runtime/"),
            modules=[address(page, path) for path in (modules or {}).get(page.path, ())],
            url=f"{site.url.rstrip('/')}/{page.path}" if site.url else "",
            policy=_policy(live=live, media="<video" in text or "<audio" in text),
            file_note=Markup(FILE_NOTE),
        )
        artifacts.append(Artifact(f"{page.path}index.html", html.encode()))
        if live:
            own = (types or {}).get(page.path), (foreign or {}).get(page.path, {})
            artifacts.append(Artifact(f"{page.path}page.json", _page_json(site, page, *own)))
        artifacts += [Artifact(path, file) for path, file in prose.files.items()]
    problems.raise_if_any()
    return artifacts + _theme_files(site)


class Menu:
    """The pages as a tree of their paths; a page sees the top, its ancestors' and its own branch.

    A menu of everything would make the size of a site grow with the square of its pages.
    """

    def __init__(self, site: Site) -> None:
        paths = {page.path for page in site.pages}
        self._above = {path: _ancestors(path, paths) for path in paths}
        self._below: dict[str, list[Page]] = {}
        for page in site.pages:
            self._below.setdefault(next(iter(self._above[page.path]), ""), []).append(page)

    def seen_from(self, page: Page) -> list[Link]:
        """Return the lines of the menu on `page`."""
        return list(self._branch("", 0, page))

    def _branch(self, parent: str, depth: int, page: Page) -> Iterator[Link]:
        for child in self._below.get(parent, ()):
            href = address(page, child.path)
            yield Link(child.title, href, depth, current=child.path == page.path)
            if child.path and child.path in (page.path, *self._above[page.path]):
                yield from self._branch(child.path, depth + 1, page)


def _ancestors(path: str, paths: set[str]) -> tuple[str, ...]:
    """Return those of `paths` that contain `path`, nearest first; the first page contains none."""
    names = path.split("/")[:-1]
    folders = ("/".join(names[:end]) + "/" for end in range(len(names) - 1, 0, -1))
    return tuple(folder for folder in folders if folder in paths)


def _link(page: Page, other: Page | None) -> Link | None:
    return Link(other.title, address(page, other.path)) if other else None


def _blocks(page: Page, prose: Prose) -> Iterator[Block]:
    """Yield the content in its order; widgets in a row stand beside each other."""
    slots = _slots(page)
    for are_widgets, parts in itertools.groupby(page.content, _is_widget):
        if are_widgets:
            row = [next(slots) for _ in parts]
            panels = itertools.groupby(row, lambda pair: pair[0].target or pair[1].id)
            yield Block(panels=tuple(_panel(list(pairs)) for _, pairs in panels))
        else:
            for part in parts:
                if isinstance(part, Markdown):
                    yield Block(Markup(prose.html(part)))


def _is_widget(part: Markdown | Widget) -> bool:
    return isinstance(part, Widget)


def _panel(pairs: Sequence[tuple[Widget, Slot]]) -> Panel:
    widget = pairs[0][0]
    return Panel(widget.target or widget.kind.capitalize(), tuple(slot for _, slot in pairs))


def _slots(page: Page) -> Iterator[tuple[Widget, Slot]]:
    widgets = (part for part in page.content if isinstance(part, Widget))
    for number, widget in enumerate(widgets, start=1):
        yield widget, Slot(f"widget-{number}", widget.kind)


def _page_json(
    site: Site,
    page: Page,
    types: Mapping[str, object] | None,
    foreign: Mapping[str, Mapping[str, object]],
) -> bytes:
    """Return the page's PageEntry, as protocol.js describes it."""
    waiting = {
        widget.target
        for widget, _ in _slots(page)
        if widget.kind == "buttons" and widget.options.get("autostart") is not True
    }
    entry: dict[str, object] = {
        "nodes": {
            name: {
                **_program(site, page, node, foreign.get(name, {})),
                "autostart": name not in waiting,
            }
            for name, node in page.nodes.items()
        },
        "widgets": [
            {
                "kind": widget.kind,
                "element": slot.id,
                "target": widget.target,
                "options": dict(widget.options),
            }
            for widget, slot in _slots(page)
        ],
    }
    if types is not None:
        entry["types"] = dict(types)
    return json.dumps(entry, sort_keys=True, separators=(",", ":"), ensure_ascii=False).encode()


def _program(site: Site, page: Page, node: Node, types: Mapping[str, object]) -> dict[str, object]:
    if node.ros2wasm is None:
        return {
            "package": node.package,
            "executable": node.executable,
            "arguments": node.command_line(),
            "builds": _builds(site, page, node),
        }
    script = node.ros2wasm.script
    path = f"ros2wasm/{script.relative_to(site.root).as_posix()}"
    worker = {"script": address(page, path), "topics": dict(node.ros2wasm.types), "types": types}
    return {"package": "ros2wasm", "executable": script.name, "arguments": [], "ros2wasm": worker}


def _builds(site: Site, page: Page, node: Node) -> dict[str, dict[str, str]]:
    engines = ("jspi", "asyncify") if site.asyncify else ("jspi",)
    stems = {engine: f"nodes/{node.package}/{node.executable}.{engine}" for engine in engines}
    return {
        engine: {"script": address(page, f"{stem}.js"), "wasm": address(page, f"{stem}.wasm")}
        for engine, stem in stems.items()
    }


def _policy(*, live: bool, media: bool) -> str:
    """Return the Content-Security-Policy: what the page needs, and nothing from elsewhere."""
    rules = ["default-src 'none'", "style-src 'self'", "img-src 'self' data:"]
    if live:
        digest = base64.b64encode(hashlib.sha256(FILE_NOTE.encode()).digest()).decode()
        rules.append(f"script-src 'self' 'wasm-unsafe-eval' 'sha256-{digest}'")
        rules += ["connect-src 'self'", "worker-src 'self'"]
    if media:
        rules.append("media-src 'self'")
    return "; ".join([*rules, "base-uri 'none'", "form-action 'none'"])


def _theme_files(site: Site) -> list[Artifact]:
    """Return everything of the theme but its templates."""
    files = (file for file in sorted(site.theme.rglob("*")) if file.is_file())
    return [
        Artifact(f"theme/{file.relative_to(site.theme).as_posix()}", file)
        for file in files
        if file.suffix != ".html" and not file.name.startswith(".")
    ]
