"""Turn the links of an author into URLs that work in the site, from any folder."""

from __future__ import annotations

import functools
import html
import os
import posixpath
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple
from urllib.parse import quote, unquote, urlsplit, urlunsplit

from sitegen import pagepath
from sitegen.errors import Location, Problems, nearest, relative
from sitegen.model import Markdown, Page, Site
from sitegen.site.prose.media import lasting_name

# Every menu links to many pages: quoting each name once saves a third of the time.
_quote = functools.cache(quote)


def address(page: Page, path: str) -> str:
    """Return the URL of `path`, a path inside `dist/`, seen from `page`."""
    if page.base:
        return page.base + _quote(path)
    if path.startswith(page.path):
        return _quote(path[len(page.path) :]) or "./"
    return "../" * page.path.count("/") + _quote(path) or "./"


class Anchor(NamedTuple):
    """A link to an id in a page: the page's path, the id, and where the link was written."""

    path: str
    id: str
    location: Location


@dataclass(frozen=True)
class Library:
    """The possible targets of links: pages by path, and by the Markdown file that they show."""

    site: Site
    pages: Mapping[str, Page]
    sources: Mapping[str, Page]

    @classmethod
    def of(cls, site: Site) -> Library:
        """Return the library of a site."""
        sources: dict[str, Page] = {}
        for page in site.pages:
            for location in (page.location, *(part.location for part in page.leaves)):
                if location.file.suffix in (".md", ".ipynb"):
                    sources.setdefault(os.path.realpath(location.file), page)
        return cls(site, {page.path: page for page in site.pages}, sources)


@dataclass
class Links:
    """The links of one page; `files` collects files to copy, `anchors` targets to check."""

    library: Library
    page: Page
    problems: Problems
    files: dict[str, Path] = field(default_factory=dict)
    anchors: list[Anchor] = field(default_factory=list)

    def __post_init__(self) -> None:
        files = {part.location.file for part in self.page.leaves}
        self._own = {os.path.realpath(file) for file in files if file.suffix == ".md"}

    def resolve(self, url: str, key: str, source: Markdown) -> tuple[str | None, Path | None]:
        """Return the URL and the file for the link `url`; no URL if it is right as written.

        `key` is the kind of link in messages: "link", "frame", "image" or "media".
        """
        try:
            parts = urlsplit(url)
        except ValueError:
            self.problems.add(
                line_of(source, url), key, f"'{url}' is not a valid address; correct it"
            )
            return None, None
        if parts.scheme == "javascript":
            self.problems.add(line_of(source, url), key, "a link cannot run a script; use a widget")
            return None, None
        if parts.scheme or parts.netloc:
            if key != "link" and parts.scheme != "data":
                message = f"'{url}' is on another site; copy the file into this site"
                self.problems.add(line_of(source, url), key, message)
            return None, None
        name, target, file = unquote(parts.path), None, None
        if not name:
            target = self.page.path
        elif key in ("link", "frame"):
            target = self._page(name, source)
        if target is not None:
            # A text fragment (`#:~:text=`) has no id.
            if parts.fragment and not parts.fragment.startswith(":~:"):
                location = line_of(source, url)
                self.anchors.append(Anchor(target, unquote(parts.fragment), location))
            if not name:
                return None, None
        else:
            target, file = self._file(name, key, source, url)
        if target is None:
            return None, None
        found = address(self.page, target)
        return urlunsplit(("", "", found, parts.query, parts.fragment)), file

    def _page(self, name: str, source: Markdown) -> str | None:
        """Return the path of the page that `name` refers to, by its source file or its path."""
        written = os.path.normpath(source.folder / name)
        known = self.library.sources
        shown = known.get(written) or (known.get(os.path.realpath(written)) if known else None)
        if shown:
            return self.page.path if written in self._own else shown.path
        here_on = posixpath.normpath(posixpath.join("/", self.page.folder, name))
        for path in (here_on, posixpath.normpath("/" + name)):
            candidate = pagepath.normalized(pagepath.path_of(path.strip("/")))
            if candidate in self.library.pages:
                return candidate
        return None

    def _file(
        self, name: str, key: str, source: Markdown, url: str
    ) -> tuple[str | None, Path | None]:
        """Record that the file `name` is to be copied; return its path in `dist/` and itself."""
        root = self.library.site.root.resolve()
        file = (source.folder / name).resolve()
        fault = ""
        if not file.is_relative_to(root):
            fault = f"'{name}' is outside the site's folder; move it below the folder of site.yaml"
        elif not file.is_file():
            fault = self._missing(name, file, key)
        else:
            # The link keeps the name relative to the page's source: a `../` would leave its folder.
            written = re.sub(r"^(\.\./)+", "", posixpath.normpath(name))
            linked = key in ("link", "frame")
            path = self.page.folder + written if linked else lasting_name(file)
            taken = self.files.setdefault(path, file)
            if not linked or (taken == file and written not in ("index.html", "page.json")):
                return path, file
            fault = f"'{name}' would replace another '{written}'; rename it"
        self.problems.add(line_of(source, url), key, fault)
        return None, None

    def _missing(self, name: str, file: Path, key: str) -> str:
        folder = relative(file.parent, self.library.site.root.resolve())
        if file.is_dir():
            return f"'{name}' is a folder, not a page; link to a file in it"
        beside = file.parent.glob(f"*{file.suffix}") if file.parent.is_dir() else []
        hint = nearest(file.name, (other.name for other in beside if other.is_file()))
        if key in ("link", "frame") and not file.suffix:
            hint = nearest(name, (path for path in self.library.pages if path))
            return f"no page '{name}'; {hint}"
        return f"no file '{file.name}' in {folder}; {hint}"


def line_of(source: Markdown, text: str) -> Location:
    """Return the line of `source` that first contains `text`, plain or escaped."""
    written = (text, html.escape(text), quote(text))
    for number, line in enumerate(source.text.split("\n")):
        if any(form in line for form in written):
            return Location(source.location.file, source.location.line + number)
    return source.location
