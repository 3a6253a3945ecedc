"""Turn a page's Markdown into HTML whose links work in the site, and name the files it needs."""

from __future__ import annotations

import functools
import html
import posixpath
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import quote, unquote, urlsplit, urlunsplit

import markdown
from markdown.extensions.admonition import AdmonitionExtension
from markdown.extensions.attr_list import AttrListExtension
from markdown.extensions.def_list import DefListExtension
from markdown.extensions.fenced_code import FencedCodeExtension
from markdown.extensions.footnotes import FootnoteExtension
from markdown.extensions.sane_lists import SaneListExtension
from markdown.extensions.tables import TableExtension
from markdown.extensions.toc import TocExtension, slugify_unicode, unique

from sitegen.errors import Place, Problems, nearest, relative
from sitegen.model import Markdown, Page, Site

# Every page's menu names every page of its branch: quoting each name once is a third of the time.
_quote = functools.cache(quote)

# Code in the output has its `<` escaped, so these find real tags, in raw HTML of the author too.
_TAG = re.compile(r"""<(a|img|source|video|audio|track)\b(?:[^>"']|"[^"]*"|'[^']*')*>""", re.I)
_ADDRESS = re.compile(r"""(\s(?:href|src|poster)\s*=\s*)(["'])(.*?)\2""", re.I | re.S)


def address(page: Page, path: str) -> str:
    """Return the relative URL of `path`, a path inside `dist/`, seen from `page`."""
    if path.startswith(page.path):
        return _quote(path[len(page.path) :]) or "./"
    return "../" * page.path.count("/") + _quote(path) or "./"


def sources(site: Site) -> dict[Path, str]:
    """Return which page shows each Markdown file, so that links to the file lead there."""
    found: dict[Path, str] = {}
    for page in site.pages:
        for place in (page.place, *(part.place for part in page.content)):
            if place.file.suffix == ".md":
                found.setdefault(place.file.resolve(), page.path)
    return found


@dataclass
class Prose:
    """The Markdown of one page: ids are unique in the page, `files` gathers what to copy."""

    site: Site
    page: Page
    sources: Mapping[Path, str]
    problems: Problems
    files: dict[str, Path] = field(default_factory=dict)

    def __post_init__(self) -> None:
        ids: set[str] = set()
        self._markdown = markdown.Markdown(
            output_format="html",
            extensions=[
                AdmonitionExtension(),
                AttrListExtension(),
                DefListExtension(),
                FencedCodeExtension(),
                FootnoteExtension(UNIQUE_IDS=True),
                SaneListExtension(),
                # The page's policy forbids the style attributes that tables align with otherwise.
                TableExtension(use_align_attribute=True),
                TocExtension(slugify=lambda text, dash: unique(slugify_unicode(text, dash), ids)),
            ],
        )

    def html(self, source: Markdown) -> str:
        """Return `source` as HTML."""
        text = self._markdown.reset().convert(source.text)
        text = text.replace("<table", '<div class="table"><table')
        text = text.replace("</table>", "</table></div>")
        return _TAG.sub(lambda tag: self._tag(tag, source), text)

    def _tag(self, tag: re.Match[str], source: Markdown) -> str:
        key = {"a": "link", "img": "image"}.get(tag[1].lower(), "media")

        def rewrite(found: re.Match[str]) -> str:
            new = self._link(html.unescape(found[3]), key, source)
            return found[0] if new is None else f'{found[1]}"{html.escape(new)}"'

        return _ADDRESS.sub(rewrite, tag[0])

    def _link(self, url: str, key: str, source: Markdown) -> str | None:
        """Return where `url` leads from this page, None if it is right as written."""
        parts = urlsplit(url)
        name = unquote(parts.path)
        if parts.scheme or parts.netloc:
            if key != "link" and parts.scheme != "data":
                where = _place(source, url)
                self.problems.add(
                    where, key, f"'{url}' is on another site; save it in this one and name the file"
                )
            return None
        if not name:
            return None
        target = self._page(name, source) if key == "link" else None
        if target is None:
            target = self._file(name, key, source, _place(source, url))
        if target is None:
            return None
        return urlunsplit(("", "", address(self.page, target), parts.query, parts.fragment))

    def _page(self, name: str, source: Markdown) -> str | None:
        """Return the path of the page that `name` means: its source file or its path."""
        file = (source.folder / name).resolve()
        if file in self.sources:
            shown_here = any(part.place.file.resolve() == file for part in self.page.content)
            return self.page.path if shown_here else self.sources[file]
        paths = {page.path for page in self.site.pages}
        here = posixpath.normpath(posixpath.join("/", self.page.path, name))
        for path in (here, posixpath.normpath("/" + name)):
            folder = path.removesuffix("/index.html").strip("/")
            candidate = f"{folder}/" if folder else ""
            if candidate in paths:
                return candidate
        return None

    def _file(self, name: str, key: str, source: Markdown, place: Place) -> str | None:
        """Note that the file `name` is to be copied, and return its path inside `dist/`."""
        root = self.site.root.resolve()
        file = (source.folder / name).resolve()
        if not file.is_relative_to(root):
            self.problems.add(
                place, key, f"'{name}' is outside the site's folder; move it beside site.yaml"
            )
            return None
        if not file.is_file():
            self.problems.add(place, key, self._missing(name, file, key))
            return None
        # Beside the page, under the name as written: a `../` would leave the page's folder.
        written = re.sub(r"^(\.\./)+", "", posixpath.normpath(name))
        path = self.page.path + written
        taken = self.files.setdefault(path, file)
        if taken != file or written in ("index.html", "page.json"):
            self.problems.add(place, key, f"'{name}' would replace another '{written}'; rename it")
            return None
        return path

    def _missing(self, name: str, file: Path, key: str) -> str:
        folder = relative(file.parent, self.site.root.resolve())
        if file.is_dir():
            return f"'{name}' is a folder and no page; name a file in it"
        beside = file.parent.glob(f"*{file.suffix}") if file.parent.is_dir() else []
        hint = nearest(file.name, (other.name for other in beside if other.is_file()))
        if key == "link" and not file.suffix:
            hint = nearest(name, (page.path for page in self.site.pages if page.path))
            return f"no page '{name}'; {hint}"
        return f"no file '{file.name}' in {folder}; {hint}"


def _place(source: Markdown, url: str) -> Place:
    """Return the line of `source` that first names `url`, as the author wrote or escaped it."""
    lines = source.text.splitlines()
    written = (url, html.escape(url), quote(url))
    for number, line in enumerate(lines):
        if any(form in line for form in written):
            return Place(source.place.file, source.place.line + number)
    return source.place
