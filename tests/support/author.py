"""The author of a site, which has one page after the other."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from paths import ROOT
from rendered import render_site

from sitegen.errors import Location, SiteError
from sitegen.model import Artifact, Markdown, Node, Page, Part, Site, Widget

THEME = ROOT / "themes/default"


class Author:
    """Writes a site below `root`, one page after the other."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self.pages: list[Page] = []

    def location(self, line: int = 1) -> Location:
        return Location(self.root / "site.yaml", line)

    def node(self, name: str, **more: object) -> Node:
        return Node(name, "cpp_pubsub", name, self.location(), **more)  # type: ignore[arg-type]

    def widget(self, kind: str, target: str, **options: object) -> Widget:
        return Widget(kind, target, options, self.location())

    def text(self, text: str, file: str = "site.yaml", line: int = 1) -> Markdown:
        path = self.root / file
        return Markdown(text, path.parent, Location(path, line))

    def page(self, path: str, *content: Part | str, title: str = "", level: str = "") -> Page:
        parts = tuple(self.text(part) if isinstance(part, str) else part for part in content)
        targets = dict.fromkeys(part.target for part in parts if isinstance(part, Widget))
        nodes = {name: self.node(name) for name in targets}
        page = Page(path, title or path or "Home", "", nodes, parts, level, self.location())
        self.pages.append(page)
        return page

    def site(self, *, url: str = "", asyncify: bool = True, title: str = "Robots") -> Site:
        return Site(
            self.root,
            title,
            "About robots",
            url,
            "en",
            THEME,
            self.root,
            asyncify,
            tuple(self.pages),
        )

    def built(self, **more: object) -> dict[str, str]:
        return {
            artifact.path: artifact.source.decode()
            for artifact in render_site(self.site(**more))  # type: ignore[arg-type]
            if isinstance(artifact.source, bytes)
        }


def write(artifacts: list[Artifact], folder: Path) -> Path:
    for artifact in artifacts:
        file = folder / artifact.path
        file.parent.mkdir(parents=True, exist_ok=True)
        source = artifact.source
        file.write_bytes(source if isinstance(source, bytes) else source.read_bytes())
    return folder


def data(artifacts: list[Artifact]) -> dict[str, bytes]:
    """The bytes of those artifacts that sitegen wrote."""
    return {a.path: a.source for a in artifacts if isinstance(a.source, bytes)}


def addresses(html: str) -> list[str]:
    return re.findall(r'\b(?:href|src)="([^"]*)"', html)


def problems(author: Author) -> list[str]:
    with pytest.raises(SiteError) as raised:
        render_site(author.site())
    return raised.value.lines
