"""Read `nav` of site.yaml."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from sitegen import pagepath
from sitegen.config.document import Value
from sitegen.errors import Problems, nearest
from sitegen.model import NavItem, Page


@dataclass(frozen=True)
class NavReader:
    """Reads the navigation of `pages`, which are given by path."""

    pages: Mapping[str, Page]
    problems: Problems

    def items(self, value: Value) -> Iterator[NavItem]:
        """Yield the items of a list: pages, URLs, and titles with items below them."""
        for item in value.items():
            if item.kind == "text":
                yield from self._target("", item)
            elif item.kind == "mapping" and len(entries := item.entries(self.problems)) == 1:
                title, inside = next(iter(entries.items()))
                yield from self._titled(title, inside)
            else:
                message = f"expected the path of a page or a title, found {item.found}"
                way = "write it like 'demo01/' or 'Demos: [demo01/, demo02/]'"
                self.problems.add(item.location, item.key, f"{message}; {way}")

    def _titled(self, title: str, value: Value) -> Iterator[NavItem]:
        if value.kind == "list" and value.items():
            yield NavItem(title, inside=tuple(self.items(value)))
        elif value.kind == "text":
            yield from self._target(title, value)
        else:
            message = f"expected a path, an address or a list of them, found {value.found}"
            self.problems.add(
                value.location, value.key, f"{message}; write it like '{title}: demo01/'"
            )

    def _target(self, title: str, value: Value) -> Iterator[NavItem]:
        text = value.text
        path = pagepath.normalized(text)
        if text.startswith(("https://", "http://")) and title:
            yield NavItem(title, url=text)
        elif path in self.pages:
            yield NavItem(title or self.pages[path].title, page=path)
        else:
            names = [page or "/" for page in self.pages]
            self.problems.add(
                value.location, value.key, f"no page '{text}'; {nearest(text, names)}"
            )
