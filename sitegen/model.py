"""The data types that the stages of a build pass to each other."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Protocol

from sitegen import pagepath
from sitegen.errors import Location


@dataclass(frozen=True)
class Artifact:
    """One file of the site: its path inside `dist/` and where its bytes come from."""

    path: str
    source: Path | bytes


@dataclass(frozen=True)
class Cpp:
    """A C++ executable of the workspace."""


@dataclass(frozen=True)
class Python:
    """A Python executable of the workspace: `setup` says what its package installs."""

    setup: Setup


@dataclass(frozen=True)
class Component:
    """A component that a container loads: its class, and the arguments of the node it becomes."""

    package: str
    plugin: str
    arguments: tuple[str, ...]
    location: Location

    @property
    def words(self) -> list[str]:
        """Return what the container's command line says about it."""
        return ["--component", self.plugin, str(len(self.arguments)), *self.arguments]


@dataclass(frozen=True)
class Container:
    """A component container: a C++ program that its components are linked into."""

    components: tuple[Component, ...]


@dataclass(frozen=True)
class Prebuilt:
    """A C++ program from an archive, which is at a URL or below the site's folder.

    `sha256` is the expected hash of the archive; `package` and `executable` choose one of its
    programs. All three may be empty. `location` and `key` say where the author wrote it.
    """

    source: str | Path
    sha256: str
    package: str
    executable: str
    location: Location
    key: str


@dataclass(frozen=True)
class Ros2wasm:
    """A program compiled by the ROS2WASM project: its worker script and the files it loads.

    `types` maps the names of its topics and services to interfaces: `package/msg/Name` or
    `package/srv/Name`.
    """

    script: Path
    files: tuple[Path, ...]
    types: Mapping[str, str]


# The kinds of nodes. The configuration decides once which kind a node is.
Kind = Cpp | Python | Container | Prebuilt | Ros2wasm


@dataclass(frozen=True)
class Node:
    """A node of a page: an executable and how it is started.

    A ROS2WASM program has no package and no executable; a prebuilt program gets them when its
    archive has been read. Python nodes with the same `group` share an interpreter. `needs` names
    the nodes without which it only waits.
    """

    name: str
    package: str
    executable: str
    location: Location
    namespace: str = ""
    remap: Mapping[str, str] = field(default_factory=dict)
    parameters: Mapping[str, str] = field(default_factory=dict)
    arguments: tuple[str, ...] = ()
    group: str = ""
    needs: tuple[str, ...] = ()
    kind: Kind = Cpp()

    @property
    def program(self) -> tuple[str, ...]:
        """A key that identifies the program; nodes with the same key share one program."""
        if isinstance(self.kind, Ros2wasm):
            types = (f"{name} {kind}" for name, kind in sorted(self.kind.types.items()))
            return ("ros2wasm", str(self.kind.script), *types)
        return (self.package, self.executable)

    def command_line(self) -> list[str]:
        """Return the arguments that `ros2 run` would be given for this node."""
        rules = [f"{old}:={new}" for old, new in self.remap.items()]
        if self.namespace:
            rules.append(f"__ns:={self.namespace}")
        ros = [word for rule in rules for word in ("-r", rule)]
        for name, value in self.parameters.items():
            ros += ["-p", f"{name}:={value}"]
        own = [*self.arguments, *(["--ros-args", *ros] if ros else [])]
        components = self.kind.components if isinstance(self.kind, Container) else ()
        return [*own, *(word for component in components for word in component.words)]


class Program(Protocol):
    """A program that is ready to be served; each kind of node has a class that implements this."""

    @property
    def name(self) -> str:
        """Its name in messages and summaries."""

    @property
    def worker(self) -> str:
        """The worker script of the runtime that runs it, a module below `runtime/workers/`."""

    @property
    def files(self) -> Sequence[Artifact]:
        """The files that it needs in `dist/`; programs may share files."""

    @property
    def kind(self) -> str:
        """What it was written in, for people: "C++", "Python" or "ROS2WASM"."""

    @property
    def fault(self) -> str:
        """Why it cannot start, in one line; "" if it can."""

    @property
    def sizes(self) -> Mapping[str, Mapping[str, int]]:
        """The sizes of its large files in bytes, by engine and path; "" stands for all engines."""

    def types(self, node: Node) -> Mapping[str, object]:
        """Return the message types that it uses as `node`, by name (MessageType in protocol.js)."""

    def entry(self, node: Node, link: Callable[[str], str]) -> dict[str, object]:
        """Return the description of `node` in page.json (NodeEntry in protocol.js).

        `link` turns a path inside `dist/` into a URL.
        """


# By the key that Node.program returns.
Programs = Mapping[tuple[str, ...], Program]


@dataclass(frozen=True)
class Markdown:
    """Text of a page, written at `location`; links in it are relative to `folder`."""

    text: str
    folder: Path
    location: Location


@dataclass(frozen=True)
class Widget:
    """A live part of a page: its kind, the node that it is about ("" for all), its options."""

    kind: str
    target: str
    options: Mapping[str, object]
    location: Location


@dataclass(frozen=True)
class Source:
    """A source file that a page shows: one of the node `target`, or one without a node.

    `file` is the path as written, relative to the node's package or to `folder`; for a node, it may
    be empty. `lines` are the first and the last line to show; `region` names a marked part instead.
    """

    target: str
    file: str
    folder: Path
    location: Location
    lines: tuple[int, int] | None = None
    region: str = ""
    node: Node | None = None


@dataclass(frozen=True)
class Cell:
    """One cell of a layout and its content; `title` is that of a tab, or the part of a stage.

    `size` is its share of the width, relative to the sizes of the other cells.
    """

    content: tuple[Part, ...]
    title: str = ""
    size: int = 1


@dataclass(frozen=True)
class Layout:
    """Parts of a page arranged as `columns`, a `grid`, `tabs` or a `stage`.

    The cells of a stage are `nodes`, `show`, and `below` or `beside` for the consoles.
    """

    kind: str
    cells: tuple[Cell, ...]
    location: Location


# The types that the content of a page consists of.
Leaf = Markdown | Widget | Source
Part = Leaf | Layout


def leaves(content: Iterable[Part]) -> Iterator[Leaf]:
    """Yield the parts of `content` in order, with layouts replaced by what they contain."""
    for part in content:
        if isinstance(part, Layout):
            for cell in part.cells:
                yield from leaves(cell.content)
        else:
            yield part


@dataclass(frozen=True)
class Page:
    """One page of the site; `path` is its folder in `dist/` ("demo/"), empty for the first page.

    `file` is its Markdown file, if it has one, and `front` the YAML at the top of that file.
    `theme` is None for the theme of the site. `original` is the path of the page that this one
    translates, or its own path; `date` is a day like 2026-11-21. `base` is the URL that addresses
    in the page are relative to; when empty, they are relative to the page.
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
    levels: bool = True
    deploy: Deploy = field(default_factory=lambda: Deploy())
    offline: bool | None = None
    isolate: bool | None = None
    pyodide: Pyodide = field(default_factory=lambda: Pyodide())
    version: str = ""


@dataclass(frozen=True)
class Setup:
    """What a Python package installs.

    `scripts` maps the names of executables to entry points ("module:function") or to paths of
    programs. `files` maps paths below the prefix to files; modules are in `python/`. `fault` says
    where and why its setup files cannot be read.
    """

    scripts: Mapping[str, str]
    files: Mapping[str, Path]
    fault: tuple[Location, str] | None = None


@dataclass(frozen=True)
class Package:
    """A ROS package of the workspace, as described by its `package.xml` and its build files.

    `executables` is None if only CMake can tell their names; `sources` maps executables to their
    source files, where these are known. `plugins` names the packages that it provides plugins for,
    and `linked` the packages whose plugins are linked into its programs.
    """

    name: str
    path: Path
    build_type: str
    depends: tuple[str, ...]
    executables: tuple[str, ...] | None
    interfaces: tuple[str, ...]
    version: str = ""
    sources: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    setup: Setup | None = None
    plugins: tuple[str, ...] = ()
    linked: tuple[str, ...] = ()


# The names of engines in messages.
BROWSERS = {"jspi": "current browsers", "asyncify": "all browsers"}


@dataclass(frozen=True)
class Build:
    """One compiled form of a node: an ES module and its WebAssembly, for one engine.

    `types` is a file with the message types that it uses, by name (MessageType in protocol.js);
    `lines` is a file that maps its code to source lines, or None if it was built without.
    """

    engine: str
    script: Path
    wasm: Path
    types: Path
    lines: Path | None = None
