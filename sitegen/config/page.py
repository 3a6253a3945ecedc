"""Read an item of `pages`, and the Markdown files that it names."""

from __future__ import annotations

import unicodedata
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from sitegen import pagepath
from sitegen.config import launching, level, notebooks, windows
from sitegen.config.blocks import front_matter, heading
from sitegen.config.commandlines import with_terminal
from sitegen.config.connect import KIND as CONNECT
from sitegen.config.connect import connect
from sitegen.config.content import Reader
from sitegen.config.document import Value, parse, read
from sitegen.config.files import locate
from sitegen.config.folder import files, in_language
from sitegen.config.launchfile import LaunchFile
from sitegen.config.nodes import Declared, declare, present
from sitegen.config.ownpanel import own_scripts
from sitegen.config.paths import path_fault
from sitegen.config.schema import FRONT_MATTER, PAGE
from sitegen.config.section import Section, check
from sitegen.config.themes import Themes
from sitegen.errors import Location, Problems, nearest
from sitegen.model import (
    Connect,
    Markdown,
    Node,
    Package,
    Page,
    Part,
    Widget,
    leaves,
)

# Keys that site.yaml cannot set for the pages of a folder, because each file has its own.
OF_ONE = (
    *("title", "description", "level", "nodes", "launch", "launch_arguments", "environment"),
    *("tags", "date"),
)

# Keys that it can set for them.
OF_ALL = ("layout", "theme", "start_from_links", "script", "scripts", "connect")

# Keys of a page that its translations keep.
KEPT = ("level", "nodes", "layout", "theme", "start_from_links", "script", "scripts", "connect")
LAYOUTS = ("page", "dashboard")


@dataclass(frozen=True)
class Written:
    """The content of a page's file: its front matter, parsed and as YAML, and its text."""

    front: Section
    yaml: str = ""
    body: Markdown | None = None


class PageReader:
    """Reads pages, and remembers the paths and nodes of the previous ones."""

    def __init__(
        self,
        problems: Problems,
        nodes: Mapping[str, Declared],
        themes: Themes,
        languages: Sequence[str],
        packages: Callable[[], Mapping[str, Package]],
        joined: Connect | None = None,
    ) -> None:
        self.problems = problems
        self.nodes = nodes
        self.themes = themes
        self.languages = languages
        self.packages = packages
        # What pages can join that do not say so themselves.
        self.joined = joined
        self.declared = list(nodes.values())
        self.paths: dict[str, Value] = {}
        self.notes = Problems(problems.root)

    def pages(self, item: Value) -> Iterator[Page]:
        """Yield the page or the pages of an item; invalid values are left out."""
        page = check(item, PAGE, self.problems)
        before = len(self.problems.found)
        file, content, folder = map(page.get, ("file", "content", "folder"))
        given = [value for value in (content, file, folder) if value]
        if len(given) > 1:
            message = (
                f"cannot be combined with '{given[0].key.rpartition('.')[2]}'; keep one of the two"
            )
            self.problems.add(given[1].location, given[1].key, message)
        if not given and not page.value.has("file", "content", "folder", "launch", "jupyter"):
            message = "missing; write it like 'content: [{console: talker}]', or give a 'file'"
            self.problems.add(item.location, page.label("content"), message)
        path = self._path(page, registered=not folder)
        if folder:
            yield from self._folder(page, path, folder)
            return
        located = locate(file, self.problems) if file else None
        yield from self._translated(page, path, located, before)

    def _folder(self, page: Section, path: str, given: Value) -> Iterator[Page]:
        """Yield a page for every Markdown file of a folder, at any depth."""
        for name in OF_ONE:
            if value := page.get(name):
                message = (
                    "cannot be combined with 'folder'; write it in the front matter of each file"
                )
                self.problems.add(value.location, value.key, message)
        folder = locate(given, self.problems, folder=True)
        found = list(files(folder, self.languages, self.problems.root)) if folder else []
        if folder and not found:
            message = f"no Markdown file in '{given.text}'; add 'index.md'"
            self.problems.add(given.location, given.key, message)
        for below, file in found:
            if taken := self.paths.get(path + below):
                message = (
                    f"'{path + below}' from {file.name} is already used by {taken.key}; rename it"
                )
                self.problems.add(given.location, given.key, message)
            self.paths[path + below] = given
            kept = {k: v for k, v in page.entries.items() if k in OF_ALL}
            bare = Section(page.value, PAGE, kept)
            yield from self._translated(bare, path + below, file, len(self.problems.found))

    def _translated(
        self, page: Section, path: str, file: Path | None, before: int
    ) -> Iterator[Page]:
        """Yield a page and its translations, whose files are beside its own.

        `before` is the number of problems before anything of the page was read.
        """
        empty = Section(page.value, FRONT_MATTER, {})
        written = self._page_file(file, empty) if file else Written(empty)
        yield self._page(page, written, path, file, before)
        for language in self.languages if file else ():
            other = in_language(file, language) if file else None
            if other and other.is_file():
                before = len(self.problems.found)
                own = self._page_file(other, empty)
                # A problem that is the same in all languages is reported once.
                said = {
                    key: value
                    for key, value in written.front.entries.items()
                    if key not in ("title", "description")
                }
                both = Section(own.front.value, FRONT_MATTER, {**said, **own.front.entries})
                kept = {k: v for k, v in page.entries.items() if k in KEPT}
                bare = Section(page.value, PAGE, kept)
                at = f"{language.lower()}/{path}"
                its_own = replace(own, front=both)
                yield self._page(bare, its_own, at, other, before, language, path)

    def _page(
        self,
        page: Section,
        written: Written,
        path: str,
        file: Path | None,
        before: int,
        language: str = "",
        original: str | None = None,
    ) -> Page:
        front, body = written.front, written.body
        known = self._declare(front, self._declare(page, self.nodes))
        folder = file.parent if file else self.problems.root
        section = _giver("launch", page, front)
        environment = _giver("environment", page, front).get("environment")
        launch = LaunchFile(section, environment, folder, self.packages, self.problems, self.notes)
        started = launch.started(known)
        self.declared += started.values()
        known |= started
        nodes = {name: node for name, (node, _) in known.items()}
        reader = Reader(nodes, self.problems, self.notes, folder)
        content = page.get("content")
        parts = [*reader.items(content)] if content else []
        if body:
            parts += reader.markdown(body.text, body.location, body.folder)
        if lab := page.get("jupyter"):
            parts += reader.jupyter(lab)
        parts = notebooks.numbered(parts)
        is_bare = not any(isinstance(part, Widget) for part in leaves(parts))
        opened, panels = list[Part](), list[Part]()
        if is_bare:
            described = launch.described.windows
            opened = windows.shown(described, [*started], self.problems, self.notes)
            opened, panels = launching.panels(opened, started)
        parts += opened
        handlers = launch.described.handlers
        parts = launching.with_panel(parts, section.get("launch"), handlers, self.problems)
        parts += panels
        joined = self._connect(_giver("connect", page, front), parts)
        for kernel in notebooks.kernels(parts):
            if kernel.name in nodes:
                message = f"the notebooks of this page need the name '{kernel.name}'"
                self.problems.add(
                    nodes[kernel.name].location, "nodes", f"{message}; choose another"
                )
            nodes[kernel.name] = kernel
            self.declared.append(Declared(kernel, None))
        if len(self.problems.found) == before:
            # Content that could not be read completely has no reliable level.
            self._check_title(page, front, parts, body)
            self._check_level(_giver("level", page, front), parts)
        placed = [part for part in leaves(parts) if isinstance(part, Widget)]
        own = [*_declared(page), *_declared(front)]
        parts = with_terminal(parts, known, own, self.problems)
        others = launch.others(parts, nodes)
        self.declared += others.values()
        nodes |= {name: node for name, (node, _) in others.items()}
        widgets = [part for part in leaves(parts) if isinstance(part, Widget)]
        shown = [name for widget in widgets for name in (widget.target, *widget.runs) if name]
        theme = _giver("theme", page, front)
        tags = _giver("tags", page, front).option("tags")
        one, several = (_giver(key, page, front).get(key) for key in ("script", "scripts"))
        scripts = own_scripts(one, several, self.problems, folder)
        # Scripts may use them without a widget.
        scripted = own if scripts else []
        links = _giver("start_from_links", page, front)
        used = _with_needed([*started, *others, *shown, *scripted], nodes)
        return Page(
            path=path,
            title=_title(page, front, parts),
            description=_giver("description", page, front).text("description"),
            nodes=used,
            content=tuple(parts),
            level=level.offered(placed),
            location=Location(file, 1) if file else page.value.location,
            file=file,
            front=written.yaml,
            theme=self.themes.find(theme, self.problems) if theme.get("theme") else None,
            tags=tuple(dict.fromkeys(tags)) if isinstance(tags, list) else (),
            date=_giver("date", page, front).text("date"),
            language=language,
            original=path if original is None else original,
            start_from_links=present(links.get("start_from_links"), used, self.problems),
            layout=self._layout(_giver("layout", page, front)),
            launch=launch.launch(others) if started else None,
            scripts=scripts,
            connect=joined,
        )

    def _connect(self, section: Section, parts: list[Part]) -> Connect | None:
        """Return what a page can join, and add the widget for it to one that has none."""
        widgets = [part for part in leaves(parts) if isinstance(part, Widget)]
        shown = [widget for widget in widgets if widget.kind == CONNECT]
        given = section.get("connect")
        joined = connect(given, self.problems) if given else self.joined
        if not joined:
            for widget in shown:
                message = "needs 'connect' on the page or in site.yaml, with the addresses"
                self.problems.add(widget.location, CONNECT, message)
        elif given and not shown:
            parts.append(Widget(CONNECT, "", {}, given.location))
        elif widgets and not shown:
            # A page of text alone has nothing that could join.
            parts.append(Widget(CONNECT, "", {}, widgets[0].location))
        return joined if given or widgets else None

    def _page_file(self, file: Path, empty: Section) -> Written:
        text = read(file, self.problems)
        if text is None:
            return Written(empty)
        front, body = front_matter(text)
        before = len(self.problems.found)
        if not front.closed:
            message = "this front matter is not closed; close it with ---"
            self.problems.add(Location(file, 1), "yaml", message)
        top = (
            parse(front.text, Location(file, 1 + front.line), self.problems) if front.text else None
        )
        if len(self.problems.found) > before:
            return Written(empty)
        section = check(top, FRONT_MATTER, self.problems) if top else empty
        return Written(
            section, front.text, Markdown(body.text, file.parent, Location(file, 1 + body.line))
        )

    def _declare(self, section: Section, taken: Mapping[str, Declared]) -> dict[str, Declared]:
        given = section.get("nodes")
        declared = declare(given, taken, self.problems) if given else {}
        self.declared += declared.values()
        return {**taken, **declared}

    def _layout(self, section: Section) -> str:
        text = section.text("layout")
        if text not in LAYOUTS:
            message = f"unknown layout '{text}'; {nearest(text, LAYOUTS)}"
            self.problems.add(section.location("layout"), section.label("layout"), message)
        return text

    def _path(self, page: Section, *, registered: bool) -> str:
        given = page.get("path")
        if given is None:
            return ""
        text = unicodedata.normalize("NFC", given.text)
        fault = path_fault(text)
        path = pagepath.normalized(text)
        if registered and not fault and (first := self.paths.get(path)):
            where = self.problems.where(first.location)
            fault = f"'{text}' is already used by {first.key} ({where}); choose another"
        if fault:
            self.problems.add(given.location, given.key, fault)
        elif registered:
            self.paths[path] = given
        return path

    def _check_title(
        self, page: Section, front: Section, parts: list[Part], body: Markdown | None
    ) -> None:
        given = page.value.has("title") or front.value.has("title")
        if not given and not _title(page, front, parts):
            message = (
                "missing; write it like 'title: My robot', or start the text with '# My robot'"
            )
            in_folder = body and page.value.has("folder")
            location = body.location if body and in_folder else page.value.location
            self.problems.add(location, "title" if in_folder else page.label("title"), message)

    def _check_level(self, section: Section, parts: list[Part]) -> None:
        declared = section.get("level")
        offers = level.offered(part for part in leaves(parts) if isinstance(part, Widget))
        fault = level.fault(declared.text, offers) if declared else ""
        if fault:
            self.problems.add(section.location("level"), section.label("level"), fault)


def _declared(section: Section) -> list[str]:
    """Return the names of the nodes that a section declares."""
    given = section.get("nodes")
    return [*given.entries(Problems(Path()))] if given else []


def _with_needed(names: Iterable[str], nodes: Mapping[str, Node]) -> dict[str, Node]:
    """Return the nodes by `names`, those that they need, those that these need, and so on."""
    found: dict[str, Node] = {}
    left = deque(names)
    while left:
        name = left.popleft()
        if name in nodes and name not in found:
            found[name] = nodes[name]
            left += nodes[name].needs
    return found


def _title(page: Section, front: Section, parts: Sequence[Part]) -> str:
    found = page.text("title") or front.text("title") or first_heading(parts)
    return found or ("JupyterLab" if page.get("jupyter") else "")


def first_heading(parts: Iterable[Part]) -> str:
    """Return the first heading of the first level in the text of a page, or nothing."""
    texts = (part.text for part in leaves(parts) if isinstance(part, Markdown))
    return next(filter(None, map(heading, texts)), "")


def _giver(name: str, page: Section, front: Section) -> Section:
    """Return the section that sets `name`: site.yaml takes precedence over the front matter."""
    return page if page.get(name) else front
