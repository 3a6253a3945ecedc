"""Turn an item of `pages`, and the Markdown file that it may name, into a Page."""

from __future__ import annotations

import re
from collections.abc import Mapping

from sitegen.config import level
from sitegen.config.blocks import front_matter, heading
from sitegen.config.content import Part, Reader
from sitegen.config.document import Value, parse, read
from sitegen.config.location import locate
from sitegen.config.nodes import Declared, declare
from sitegen.config.schema import FRONT_MATTER, PAGE
from sitegen.config.section import Section, check
from sitegen.errors import Place, Problems
from sitegen.model import Markdown, Page, Widget

SEGMENT = re.compile(r"[a-z0-9_~-][a-z0-9._~-]*")


class PageReader:
    """Reads pages, and remembers which paths and nodes the earlier ones took."""

    def __init__(self, problems: Problems, nodes: Mapping[str, Declared]) -> None:
        self.problems = problems
        self.nodes = nodes
        self.declared = list(nodes.values())
        self.paths: dict[str, Value] = {}

    def page(self, item: Value) -> Page:
        """Return the page, as sound as what was written."""
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
        reader = Reader({name: node for name, (node, _) in known.items()}, self.problems)
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
            nodes={w.target: reader.nodes[w.target] for w in widgets if w.target},
            content=tuple(parts),
            level=level.offered(widgets),
            place=item.place,
        )

    def _page_file(self, value: Value, empty: Section) -> tuple[Section, Markdown | None]:
        file = locate(value, self.problems)
        text = read(file, self.problems) if file else None
        if file is None or text is None:
            return empty, None
        front, body = front_matter(text)
        before = len(self.problems.found)
        if not front.closed:
            message = "this front matter has no end; close it with ---"
            self.problems.add(Place(file, 1), "yaml", message)
        top = parse(front.text, Place(file, 1 + front.line), self.problems)
        if len(self.problems.found) > before:
            return empty, None
        section = check(top, FRONT_MATTER, self.problems) if top else empty
        return section, Markdown(body.text, file.parent, Place(file, 1 + body.line))

    def _declare(self, section: Section, taken: Mapping[str, Declared]) -> dict[str, Declared]:
        given = section.get("nodes")
        declared = declare(given, taken, self.problems) if given else {}
        self.declared += declared.values()
        return {**taken, **declared}

    def _path(self, page: Section) -> str:
        given = page.get("path")
        if given is None:
            return ""
        text = given.text
        fault = _path_fault(text)
        path = f"{text.strip('/')}/".removeprefix("/")
        if not fault and (first := self.paths.get(path)):
            where = self.problems.where(first.place)
            fault = f"'{text}' is taken by {first.key} ({where}); choose another"
        if fault:
            self.problems.add(given.place, given.key, fault)
        else:
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
