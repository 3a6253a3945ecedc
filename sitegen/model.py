"""The plain data that the stages hand to each other."""

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
    """A component container: a C++ program that is linked with its components."""

    components: tuple[Component, ...]


@dataclass(frozen=True)
class Prebuilt:
    """A C++ program from an archive, at an address or below the site's folder.

    `sha256` is the hash that the archive must have; `package` and `executable` choose one of its
    programs. All three may be empty. `location` and `key` are where the author wrote it.
    """

    source: str | Path
    sha256: str
    package: str
    executable: str
    location: Location
    key: str


@dataclass(frozen=True)
class Ros2wasm:
    """A program that the ROS2WASM project compiled: its worker script, and the files that needs.

    `types` names the interfaces of its topics and services: `package/msg/Name` or
    `package/srv/Name`.
    """

    script: Path
    files: tuple[Path, ...]
    types: Mapping[str, str]


# What a node is, which the configuration decides once.
Kind = Cpp | Python | Container | Prebuilt | Ros2wasm


@dataclass(frozen=True)
class Node:
    """A program that a page runs: which executable, and what it is started with.

    A ROS2WASM program has no package and no executable; a prebuilt one gets them when its archive
    has been read. Python nodes of a `group` share an interpreter.
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
    kind: Kind = Cpp()

    @property
    def program(self) -> tuple[str, ...]:
        """What identifies the program: nodes that agree in it share one."""
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
    """A program that is ready to be served: one class implements this for each kind."""

    @property
    def name(self) -> str:
        """What people call it."""

    @property
    def worker(self) -> str:
        """The worker of the runtime that runs it, a module below `runtime/workers/`."""

    @property
    def files(self) -> Sequence[Artifact]:
        """What it needs in `dist/`; programs may share files."""

    @property
    def kind(self) -> str:
        """What it was written in, for people: "C++", "Python" or "ROS2WASM"."""

    @property
    def sizes(self) -> Mapping[str, Mapping[str, int]]:
        """The bytes of its large files by path, for each engine; "" if it suits all engines."""

    def types(self, node: Node) -> Mapping[str, object]:
        """Return the message types that it uses as `node` (MessageType in protocol.js), by name."""

    def entry(self, node: Node, link: Callable[[str], str]) -> dict[str, object]:
        """Return how page.json describes `node` (NodeEntry in protocol.js).

        `link` turns a path inside `dist/` into an address.
        """


# By what identifies them.
Programs = Mapping[tuple[str, ...], Program]


@dataclass(frozen=True)
class Markdown:
    """Text of a page: `text` begins at `location`, links in it are relative to `folder`."""

    text: str
    folder: Path
    location: Location


@dataclass(frozen=True)
class Widget:
    """A live part of a page: its kind, the node it is about (or all, ""), its options."""

    kind: str
    target: str
    options: Mapping[str, object]
    location: Location


@dataclass(frozen=True)
class Source:
    """A file of the author's, shown as it is: that of the node `target`, or one without a node.

    `file` is as written, relative to the node's package or to `folder`; it may be left out for a
    node. `lines` are the first and the last one to show, `region` names a marked part instead.
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
    """A place of a layout, and what is there; `title` is that of a tab, or the part of a stage.

    `size` is its share of the width, beside that of the others.
    """

    content: tuple[Part, ...]
    title: str = ""
    size: int = 1


@dataclass(frozen=True)
class Layout:
    """Parts of a page that stand beside each other: `columns`, a `grid`, `tabs` or a `stage`.

    The cells of a stage are `nodes`, `show`, and `below` or `beside` for the consoles.
    """

    kind: str
    cells: tuple[Cell, ...]
    location: Location


# What the content of a page is made of.
Leaf = Markdown | Widget | Source
Part = Leaf | Layout


def leaves(content: Iterable[Part]) -> Iterator[Leaf]:
    """Yield the parts of `content` in their order, those of layouts too."""
    for part in content:
        if isinstance(part, Layout):
            for cell in part.cells:
                yield from leaves(cell.content)
        else:
            yield part


@dataclass(frozen=True)
class Page:
    """One page of the site; `path` is its folder in `dist/` ("demo/"), empty for the first page.

    `file` is the Markdown file it was written in, if it was one, and `front` the YAML at its top;
    `theme` is empty for the site's.
    `original` is the path of the page that it translates, or its own; `date` is like 2026-11-21.
    `base` is where addresses in it begin; without it they are relative to the page.
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
        """The text, the widgets and the sources of the page, in their order."""
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
    """A line of the navigation as the author ordered it: a page, an address, or a group."""

    title: str
    page: str | None = None
    url: str = ""
    inside: tuple[NavItem, ...] = ()


@dataclass(frozen=True)
class Look:
    """How a site differs from its theme: files are below the site's folder.

    `accent` is a colour like #2b4bd8; a font is a file, or names that visitors may have installed;
    `footer` is Markdown.
    """

    accent: str = ""
    font: Path | str = ""
    code_font: Path | str = ""
    logo: Path | None = None
    footer: Markdown | None = None


@dataclass(frozen=True)
class Deploy:
    """Where a site is published: a branch of a remote of git, and its own domain if it has one."""

    branch: str = "gh-pages"
    remote: str = "origin"
    cname: str = ""


@dataclass(frozen=True)
class Pyodide:
    """What Python nodes need beside ROS: where the Pyodide distribution is, and pinned packages."""

    packages: Path | str = ""
    requirements: Path | None = None


@dataclass(frozen=True)
class Site:
    """What the author wrote, checked: everything below `root`.

    `packages` are those of the workspace, by name, as far as nodes made it necessary to look;
    `notes` is what the author may want to know about a site that is right. `nav` is empty where the
    paths of the pages are the navigation; `languages` are those beside `language`. `offline` is
    None where nobody said anything, False where the site is to work without a network no more, and
    so it is with `isolate`. `version` is the name of this one, if the site has versions; `url` is
    then its address.
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
    """What a package with Python installs.

    `scripts` are its entry points ("module:function"), or the paths of its programs, by the names
    of the executables; `files` maps paths below the prefix to files, where modules are in
    `python/`. `fault` says where its setup cannot be read, and why.
    """

    scripts: Mapping[str, str]
    files: Mapping[str, Path]
    fault: tuple[Location, str] | None = None


@dataclass(frozen=True)
class Package:
    """A ROS package of the workspace, as its `package.xml` and its build files describe it.

    `executables` is None where only CMake itself can tell their names; `sources` has the files of
    those that it names, as far as they stand there. `plugins` names the packages for which it has
    plugins, and `linked` packages with whose plugins its programs are linked besides.
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


# What people call the browsers that each engine is for.
BROWSERS = {"jspi": "current browsers", "asyncify": "all browsers"}


@dataclass(frozen=True)
class Build:
    """One compiled form of a node: an ES module and its WebAssembly, for engines of `engine`.

    `types` is a file with the message types that it uses (MessageType in protocol.js), by name;
    `lines` one that tells where it is in its sources, if it was made for that.
    """

    engine: str
    script: Path
    wasm: Path
    types: Path
    lines: Path | None = None
