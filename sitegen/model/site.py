"""A site and its pages, as site.yaml and Markdown files describe them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from sitegen import pagepath
from sitegen.errors import Location
from sitegen.model.content import Leaf, Markdown, Part, leaves
from sitegen.model.launch import Launch
from sitegen.model.node import Node
from sitegen.model.package import Package


@dataclass(frozen=True)
class Connect:
    """The gateways that a page can join, and what meets whom then.

    `send` and `receive` are patterns of names by "topics", "services" and "actions", None for all;
    `rates` are messages per second by pattern.
    """

    addresses: tuple[str, ...]
    autoconnect: bool = False
    namespace: str = ""
    send: Mapping[str, tuple[str, ...]] | None = None
    receive: Mapping[str, tuple[str, ...]] | None = None
    rates: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Page:
    """One page of the site; `path` is its folder in `dist/` ("demo/"), empty for the first page.

    `file` is its Markdown file, if it has one, and `front` the YAML at the top of that file.
    `theme` is None for the theme of the site. `original` is the path of the page that this one
    translates, or its own path; `date` is a day like 2026-11-21. `base` is the URL that addresses
    in the page are relative to; when empty, they are relative to the page. `layout` is "page" or
    "dashboard". `scripts` are paths of modules below the site's folder, in order.
    """

    path: str
    title: str
    description: str
    nodes: Mapping[str, Node]
    content: tuple[Part, ...]
    level: str
    location: Location
    file: Path | None = None
    front: str = ""
    theme: Path | None = None
    tags: tuple[str, ...] = ()
    date: str = ""
    language: str = ""
    original: str | None = None
    base: str = ""
    start_from_links: tuple[str, ...] = ()
    layout: str = "page"
    launch: Launch | None = None
    scripts: tuple[str, ...] = ()
    connect: Connect | None = None

    @property
    def leaves(self) -> Iterator[Leaf]:
        """The text, the widgets and the sources of the page, in order."""
        return leaves(self.content)

    @property
    def folder(self) -> str:
        """The folder of the page in `dist/`: its path, unless that is a file."""
        return "".join(self.path.rpartition("/")[:2])

    @property
    def html(self) -> str:
        """The file of the page in `dist/`."""
        return pagepath.file_of(self.path)


@dataclass(frozen=True)
class NavItem:
    """An item of `nav` in site.yaml: a page, a URL, or a group."""

    title: str
    page: str | None = None
    url: str = ""
    inside: tuple[NavItem, ...] = ()


@dataclass(frozen=True)
class Look:
    """The changes of a site to its theme; files are below the site's folder.

    `accent` is a colour like #2b4bd8; a font is a file, or the names of installed fonts; `footer`
    is Markdown.
    """

    accent: str = ""
    font: Path | str = ""
    code_font: Path | str = ""
    logo: Path | None = None
    footer: Markdown | None = None


@dataclass(frozen=True)
class Deploy:
    """Where a site is published: a remote and branch of git, and its own domain, if it has one."""

    branch: str = "gh-pages"
    remote: str = "origin"
    cname: str = ""


@dataclass(frozen=True)
class Pyodide:
    """What Python nodes need besides ROS: the Pyodide distribution, and pinned packages."""

    packages: Path | str = ""
    requirements: Path | None = None


@dataclass(frozen=True)
class Site:
    """A checked site.yaml; its files are below `root`.

    `packages` are the packages of the workspace by name; it is empty if no node needs the
    workspace. `notes` are hints about a site that has no errors. `nav` is empty if the navigation
    follows the paths of the pages; `languages` are the languages besides `language`. `offline` and
    `isolate` are None if site.yaml does not mention them, and False if it turns them off. `version`
    names this version of a site with versions; `url` is then the URL of the version.
    """

    root: Path
    title: str
    description: str
    url: str
    language: str
    theme: Path
    workspace: Path
    asyncify: bool
    pages: tuple[Page, ...]
    packages: Mapping[str, Package] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    look: Look = field(default_factory=lambda: Look())
    nav: tuple[NavItem, ...] = ()
    languages: tuple[str, ...] = ()
    repository: str = ""
    branch: str = "main"
    feed: bool = False
    levels: bool = False
    deploy: Deploy = field(default_factory=lambda: Deploy())
    offline: bool | None = None
    isolate: bool | None = None
    messages_from: tuple[str, ...] = ()
    pyodide: Pyodide = field(default_factory=lambda: Pyodide())
    version: str = ""
