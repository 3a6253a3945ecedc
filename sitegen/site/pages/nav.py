"""Build the navigation: menus, breadcrumbs, and links to the previous and the next page."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from sitegen.model import NavItem, Page, Site
from sitegen.site.pages import discovery
from sitegen.site.prose import address

# Up to this many lines, the menu of every page has all groups with what they contain.
WHOLE = 200


class Link(NamedTuple):
    """A link; in a menu, `inside` has the items below it and `current` marks the page itself.

    `open` marks the page and the items above it. A group without its own page has no `href`.
    """

    title: str
    href: str
    current: bool = False
    open: bool = False
    inside: tuple[Link, ...] = ()


class Form(NamedTuple):
    """A page in one of its languages; `url` is absolute, or empty."""

    language: str
    href: str
    url: str
    current: bool


@dataclass
class _Entry:
    """An item of the navigation; one without a page and a URL is a group."""

    title: str
    page: str | None = None
    url: str = ""
    inside: list[_Entry] = field(default_factory=list)
    above: _Entry | None = None

    def pages(self) -> Iterator[str]:
        """Yield the pages of this item and below, in order."""
        if self.page is not None:
            yield self.page
        for entry in self.inside:
            yield from entry.pages()


class Navigation:
    """The tree of pages; a menu has the top, the branches above a page, its own, and all groups.

    If each page of a large site showed all others, its size would grow with the square of its
    pages, so there, closed groups are links to their first page.
    """

    def __init__(self, site: Site) -> None:
        originals = {page.path: page for page in site.pages if page.original in (None, page.path)}
        self._translated = {(p.language, p.original): p for p in site.pages if p.language}
        self._originals = originals
        self._top = _given(site.nav) if site.nav else _by_path(originals)
        self._entries: dict[str, _Entry] = {}
        self._index(self._top, None)
        self._order = list(self._entries)
        self._whole = len(self._order) <= WHOLE
        self._places = {path: index for index, path in enumerate(self._order)}

    def menu(self, page: Page) -> list[Link]:
        """Return the items of the menu on `page`."""
        above = {id(entry) for entry in self._above(page)}
        return [self._link(entry, page, above) for entry in self._top]

    def trail(self, page: Page) -> list[Link]:
        """Return the breadcrumbs: the links from the top to `page`, without itself."""
        return [self._alone(entry, page) for entry in reversed(self._above(page)[1:])]

    def around(self, page: Page) -> tuple[Link | None, Link | None]:
        """Return the pages before and after `page`."""
        index = self._places.get(_original(page))
        if index is None:
            return None, None
        sides = (index - 1, index + 1)
        before, after = (self._order[s] if 0 <= s < len(self._order) else None for s in sides)
        return self._to(before, page), self._to(after, page)

    def languages(self, page: Page, site: Site) -> list[Form]:
        """Return all forms of `page`, or nothing if there is only one."""
        path = _original(page)
        forms = [(site.language, self._originals[path])] if path in self._originals else []
        for language in site.languages:
            if translated := self._translated.get((language, path)):
                forms.append((language, translated))
        return [
            Form(
                language,
                address(page, other.path),
                discovery.url(site, other) if site.url else "",
                current=other.path == page.path,
            )
            for language, other in (forms if len(forms) > 1 else ())
        ]

    def home(self, page: Page) -> Page | None:
        """Return the first page of the site in the language of `page`."""
        return self._translated.get((page.language, "")) or self._originals.get("")

    def _index(self, entries: Iterable[_Entry], above: _Entry | None) -> None:
        for entry in entries:
            entry.above = above
            if entry.page is not None:
                self._entries.setdefault(entry.page, entry)
            self._index(entry.inside, entry)

    def _above(self, page: Page) -> list[_Entry]:
        """Return the item of a page and the items above it, nearest first."""
        way, entry = [], self._entries.get(_original(page))
        while entry:
            way.append(entry)
            entry = entry.above
        return way

    def _link(self, entry: _Entry, page: Page, above: set[int]) -> Link:
        link, is_open = self._alone(entry, page), id(entry) in above
        if not is_open and (link.href or not self._whole):
            return link if link.href else link._replace(href=self._first(entry, page))
        inside = tuple(self._link(each, page, above) for each in entry.inside)
        current = entry.page is not None and entry.page == _original(page)
        return link._replace(current=current, open=is_open, inside=inside)

    def _alone(self, entry: _Entry, page: Page) -> Link:
        """Return the link to an entry, without what is below it."""
        if entry.page is None:
            return Link(entry.title, entry.url)
        shown = self._shown(entry.page, page)
        return Link(shown.title if shown.language else entry.title, address(page, shown.path))

    def _first(self, group: _Entry, page: Page) -> str:
        path = next(group.pages(), None)
        return "" if path is None else address(page, self._shown(path, page).path)

    def _to(self, path: str | None, page: Page) -> Link | None:
        return None if path is None else self._alone(self._entries[path], page)

    def _shown(self, path: str, page: Page) -> Page:
        """Return the page with that path in the language of `page`, or the original."""
        return self._translated.get((page.language, path)) or self._originals[path]


def _original(page: Page) -> str:
    return page.path if page.original is None else page.original


def _given(sections: Iterable[NavItem]) -> list[_Entry]:
    return [_Entry(s.title, s.page, s.url, _given(s.inside)) for s in sections]


def _by_path(pages: Mapping[str, Page]) -> list[_Entry]:
    """Return the tree of the paths; a folder of several pages without its own is a group."""
    entries = {path: _Entry(page.title, path) for path, page in pages.items()}
    pages_in = Counter(folder for path in pages for folder in _folders(path))
    top: list[_Entry] = []
    for path in pages:
        entry = entries[path]
        for folder in _folders(path):
            known = folder in entries
            if not known and pages_in[folder] < 2:
                continue
            parent = entries.setdefault(folder, _Entry(_named(folder)))
            parent.inside.append(entry)
            if known:
                break
            entry = parent
        else:
            top.append(entry)
    return top


def _folders(path: str) -> list[str]:
    """Return the folders that contain a path, nearest first; the first page contains none."""
    names = path.split("/")[:-1]
    return ["/".join(names[:end]) + "/" for end in range(len(names) - 1, 0, -1)]


def _named(folder: str) -> str:
    name = folder.rstrip("/").rpartition("/")[2]
    return name.replace("-", " ").replace("_", " ").capitalize()
