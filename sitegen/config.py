"""Turn site.yaml, and the Markdown that it names, into a Site."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import urlsplit

from sitegen import level, nodes, workspace
from sitegen.blocks import front_matter, heading
from sitegen.content import Reader
from sitegen.document import Value, parse, read
from sitegen.errors import Place, Problems, SiteError, nearest, relative
from sitegen.location import locate
from sitegen.model import Markdown, Package, Page, Site, Widget
from sitegen.nodes import Declared
from sitegen.schema import FILE, FRONT_MATTER, PAGE, SITE
from sitegen.section import Section, check

THEMES = Path(__file__).with_name("themes")
SEGMENT = re.compile(r"[a-z0-9_~-][a-z0-9._~-]*")
Part = Markdown | Widget
LANGUAGE = re.compile(r"[A-Za-z]{2,3}(-[A-Za-z0-9]{2,8})*")


def load(file: Path) -> Site:
    """Return the site that `file` describes, or raise one SiteError with all that is wrong."""
    root = file.parent.resolve()
    file = root / file.name
    problems = Problems(root)
    if not file.exists():
        raise SiteError([f"{file.name}: no such file in this folder; name the folder that has one"])
    text = read(file, problems)
    empty = "the file is empty; begin with 'site: {title: My robot}'"
    top = None if text is None else parse(text, Place(file, 1), problems, empty=empty)
    if top is None:
        raise SiteError(problems.lines)
    site = _Draft(root, problems).site(check(top, FILE, problems))
    problems.raise_if_any()
    return site


@dataclass
class _Draft:
    """A site while it is read: what its parts need to know of each other."""

    root: Path
    problems: Problems
    nodes: dict[str, Declared] = field(default_factory=dict)
    declared: list[Declared] = field(default_factory=list)
    paths: dict[str, Value] = field(default_factory=dict)

    def site(self, file: Section) -> Site:
        """Return the site, as sound as what was written."""
        given = file.get("site")
        site = check(given, SITE, self.problems) if given else Section(file.value, SITE, {})
        self.nodes = self._declare(file, {})
        pages = tuple(self._page(item) for item in self._page_items(file))
        folder = self._workspace(file)
        return Site(
            root=self.root,
            title=site.text("title"),
            description=site.text("description"),
            url=self._url(site),
            language=self._language(site),
            theme=self._theme(site),
            workspace=folder or self.root,
            asyncify=bool(site.option("asyncify")),
            pages=pages,
            packages=self._packages(folder) if folder else {},
            notes=self._notes(pages),
        )

    def _url(self, site: Section) -> str:
        url = site.text("url")
        try:
            parts = urlsplit(url)
            sound = parts.scheme in ("http", "https") and parts.hostname and parts.port != 0
        except ValueError:
            sound = False
        if url and not (sound and re.fullmatch(r"[^\s?#]+", url)):
            message = f"'{url}' is not an http address; write it like 'https://me.github.io/robot/'"
            self.problems.add(site.place("url"), site.label("url"), message)
        return url if not url or url.endswith("/") else f"{url}/"

    def _language(self, site: Section) -> str:
        language = site.text("language")
        if not LANGUAGE.fullmatch(language):
            message = f"'{language}' is not a language tag; write it like 'en' or 'pt-BR'"
            self.problems.add(site.place("language"), site.label("language"), message)
        return language

    def _theme(self, site: Section) -> Path:
        name = site.text("theme")
        own = self.root / "themes"
        packaged = THEMES if THEMES.is_dir() else THEMES.parents[1] / "themes"
        found = {
            page.parent.name: page.parent
            for folder in (packaged, own)
            for page in folder.glob("*/page.html")
        }
        theme = found.get(name)
        if theme is None:
            message = f"no theme named '{name}'; {nearest(name, found)}"
            self.problems.add(site.place("theme"), site.label("theme"), message)
        elif theme.parent == own and not theme.resolve().is_relative_to(self.root):
            message = f"'themes/{name}' leads out of the site's folder; copy the theme there"
            self.problems.add(site.place("theme"), site.label("theme"), message)
        return theme or own

    def _workspace(self, file: Section) -> Path | None:
        given = file.get("workspace")
        return locate(given, self.root, self.problems, folder=True) if given else self.root

    def _packages(self, folder: Path) -> Mapping[str, Package]:
        if not self.declared:
            return {}
        packages = workspace.scan(folder, problems=self.problems)
        for declared in self.declared:
            nodes.check_package(declared, packages, self.problems)
        return packages

    def _notes(self, pages: tuple[Page, ...]) -> tuple[str, ...]:
        used = {(node.name, node.place) for page in pages for node in page.nodes.values()}
        notes = Problems(self.root)
        for node, section in self.declared:
            if (node.name, node.place) not in used:
                message = "no page uses this node; give it a console or buttons, or remove it"
                notes.add(node.place, section.value.key, message)
        return tuple(notes.lines)

    def _declare(self, section: Section, taken: Mapping[str, Declared]) -> dict[str, Declared]:
        given = section.get("nodes")
        declared = nodes.declare(given, taken, self.problems) if given else {}
        self.declared += declared.values()
        return {**taken, **declared}

    def _page_items(self, file: Section) -> list[Value]:
        given = file.get("pages")
        if given and not given.items():
            message = "a site needs a page; write it like 'pages: [{path: /, file: index.md}]'"
            self.problems.add(given.place, given.key, message)
        return given.items() if given else []

    def _page(self, item: Value) -> Page:
        page = check(item, PAGE, self.problems)
        path = self._path(page)
        front, body = Section(item, FRONT_MATTER, {}), None
        before = len(self.problems.found)
        file, content = page.get("file"), page.get("content")
        if file and content:
            message = "given beside 'content'; keep one of the two"
            self.problems.add(file.place, file.key, message)
        if not file and not content and not page.value.has("file", "content"):
            message = "missing; write it like 'content: [{console: talker}]', or name a 'file'"
            self.problems.add(item.place, page.label("content"), message)
        if file:
            front, body = self._page_file(file, front)
        known = self._declare(front, self._declare(page, self.nodes))
        reader = Reader(self.root, {name: node for name, (node, _) in known.items()}, self.problems)
        parts = [*reader.items(content)] if content else []
        if body:
            parts += reader.markdown(body.text, body.place, body.folder)
        if len(self.problems.found) == before:
            # What is missing from half-read content is no news.
            self._check_title(page, front, parts)
            self._check_level(_giver("level", page, front), parts)
        widgets = [part for part in parts if isinstance(part, Widget)]
        return Page(
            path=path,
            title=_title(page, front, parts),
            description=_giver("description", page, front).text("description"),
            nodes={widget.target: reader.nodes[widget.target] for widget in widgets},
            content=tuple(parts),
            level=level.offered(widgets),
            place=item.place,
        )

    def _page_file(self, value: Value, empty: Section) -> tuple[Section, Markdown | None]:
        file = locate(value, self.root, self.problems)
        text = read(file, self.problems) if file else None
        if file is None or text is None:
            return empty, None
        front, body, line = front_matter(text)
        markdown = Markdown(body, file.parent, Place(file, line))
        before = len(self.problems.found)
        top = parse(front, Place(file, 2), self.problems) if front else None
        if len(self.problems.found) > before:
            return empty, None
        return (check(top, FRONT_MATTER, self.problems) if top else empty), markdown

    def _path(self, page: Section) -> str:
        text = page.text("path")
        fault = _path_fault(text) if text else ""
        path = f"{text.strip('/')}/".removeprefix("/")
        if not fault and (first := self.paths.get(path)):
            where = f"{relative(first.place.file, self.root)}:{first.place.line}"
            fault = f"'{text}' is taken by {first.key} ({where}); choose another"
        if fault:
            self.problems.add(page.place("path"), page.label("path"), fault)
        elif given := page.get("path"):
            self.paths[path] = given
        return path

    def _check_title(self, page: Section, front: Section, parts: list[Part]) -> None:
        given = page.value.has("title") or front.value.has("title")
        if not given and not _title(page, front, parts):
            message = (
                "missing; write it like 'title: My robot', or begin the text with '# My robot'"
            )
            self.problems.add(page.value.place, page.label("title"), message)

    def _check_level(self, section: Section, parts: list[Part]) -> None:
        declared = section.get("level")
        offers = level.offered(part for part in parts if isinstance(part, Widget))
        fault = level.fault(declared.text, offers) if declared else ""
        if fault:
            self.problems.add(section.place("level"), section.label("level"), fault)


def _title(page: Section, front: Section, parts: list[Part]) -> str:
    texts = (part.text for part in parts if isinstance(part, Markdown))
    headings = filter(None, map(heading, texts))
    return page.text("title") or front.text("title") or next(headings, "")


def _giver(name: str, page: Section, front: Section) -> Section:
    """Return the section that decides about `name`: site.yaml goes before the page's own file."""
    return page if page.get(name) else front


def _path_fault(text: str) -> str:
    segments = text.removesuffix("/").split("/")
    plain = [re.sub(r"[^a-z0-9._~-]+", "-", part.lower()).lstrip(".") for part in segments]
    way = "/".join(filter(None, plain))
    hint = f"write '{way}/'" if way else "write '/' for the first page"
    if text == "/":
        return ""
    if "\\" in text:
        return f"'{text}' has a backslash; write '{text.replace(chr(92), '/')}'"
    if text.startswith("/"):
        return f"'{text}' is absolute; {hint}"
    if ".." in segments:
        return f"'{text}' leads out of the site; {hint}"
    if not all(map(SEGMENT.fullmatch, segments)):
        return f"'{text}' must be of lower-case letters, digits, '-', '_', '.' and '~'; {hint}"
    return ""
