"""Collect an author's modules, panels and scripts, and all that they import or name."""

from __future__ import annotations

import hashlib
import json
import posixpath
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from sitegen.errors import Location, Problems, nearest
from sitegen.interfaces.catalogue import as_artifact
from sitegen.model import Artifact, Page, Site, Widget
from sitegen.shipped import BUNDLES, RUNTIME
from sitegen.site.ownpanels.module import Reference, parsed

KIND = "own"
MOUNT = "export function mount(element, ros, options)"
MODULES = (".js", ".mjs")
# The modules of sitegen that others may import, and their files below runtime/.
ROSBRIDGE = "sitegen/rosbridge"
CLIENTS = {
    "sitegen": "client/client.js",
    ROSBRIDGE: "rosbridge/rosbridge.js",
    "sitegen/roslib": "vendor/roslib.js",
}
# The path of roslib in `dist/`.
ROSLIB = f"runtime/{CLIENTS['sitegen/roslib']}"
# What comes with them: what they load when they need it, and the licenses of libraries.
BESIDE = {
    ROSBRIDGE: ("rosbridge/encoding.js", "vendor/licenses.txt"),
    "sitegen/roslib": ("vendor/licenses.txt",),
}
# What is imported as a module: a style sheet that is adopted, and data.
SHEET = """\
const sheet = new CSSStyleSheet();
sheet.replaceSync({});
export default sheet;
"""
ADOPT = """\
import sheet from {};
document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
"""


@dataclass(frozen=True)
class OwnPanels:
    """The files of a page's own modules: the path in `dist/` of each module, by file.

    `interfaces` is the path of all definitions of interfaces, if the page needs them, and `texts`
    that of the files that define them, which only rosbridge needs.
    """

    modules: Mapping[str, str]
    artifacts: Sequence[Artifact]
    interfaces: str = ""
    texts: str = ""


def own_panels(
    site: Site,
    page: Page,
    problems: Problems,
    interfaces: Callable[[], bytes],
    texts: Callable[[], bytes],
) -> OwnPanels:
    """Return the files of the panels and the scripts of `page`, and report faulty ones.

    All of them are in a folder whose name depends on their content, so that browsers can keep them,
    and panels that import the same module share it. `interfaces` returns the definitions of all
    interfaces, which pages need that import modules of sitegen, and `texts` the files of these.
    """
    panels = [part for part in page.leaves if isinstance(part, Widget) and part.kind == KIND]
    files = {str(panel.options["file"]): panel.location for panel in panels}
    found = _Files(site.root.resolve(), problems)
    for name in files:
        found.add_panel(name)
    for name in page.scripts:
        found.add_script(name)
        files.setdefault(name, page.location)
    digest = hashlib.sha256()
    for name, content in sorted(found.contents.items()):
        digest.update(f"{name}\0{len(content)}\0".encode() + content)
    folder = f"panels/{digest.hexdigest()[:10]}/"
    artifacts = [Artifact(folder + name, content) for name, content in found.contents.items()]
    artifacts += client_artifacts(found.clients)
    described = written = ""
    if found.clients or site.messages_from:
        artifacts.append(as_artifact(interfaces()))
        described = artifacts[-1].path
    if ROSBRIDGE in found.clients or site.messages_from:
        artifacts.append(as_artifact(texts()))
        written = artifacts[-1].path
    return OwnPanels({name: folder + name for name in files}, artifacts, described, written)


def uses_client(source: bytes) -> bool:
    """Return whether a module itself imports a module of sitegen."""
    return any(one.name in CLIENTS for one in parsed(source).references)


def client_artifacts(names: Iterable[str]) -> list[Artifact]:
    """Return the files of modules of sitegen, with what comes with them."""
    files = {file for name in names for file in (CLIENTS[name], *BESIDE.get(name, ()))}
    # Libraries have a bundle already.
    folders = {name: RUNTIME if name.startswith("vendor/") else BUNDLES for name in files}
    return [Artifact(f"runtime/{name}", folders[name] / name) for name in sorted(files)]


@dataclass
class _Files:
    """Files by path below `root`, as they are served."""

    root: Path
    problems: Problems
    contents: dict[str, bytes] = field(default_factory=dict)
    # The modules that import the one that is read.
    above: list[str] = field(default_factory=list)
    # The key that names the module that is added.
    key: str = "panel"
    # The names of the modules of sitegen that they import.
    clients: set[str] = field(default_factory=set)

    def add_panel(self, name: str) -> None:
        """Add the module of a panel."""
        self._add(name)
        exports = parsed(self._read(name)).exports
        if not exports & {"mount", "*"}:
            how = "; export it by name, not as the default" if "default" in exports else ""
            message = f"exports no function 'mount'{how}; begin it with '{MOUNT}'"
            self._report(name, 1, message)

    def add_script(self, name: str) -> None:
        """Add the script of a page."""
        self.key = "script"
        self._add(name)

    def _read(self, name: str) -> bytes:
        return (self.root / name).read_bytes()

    def _report(self, name: str, line: int, message: str) -> None:
        self.problems.add(Location(self.problems.root / name, line), self.key, message)

    def _add(self, name: str) -> None:
        """Add a file and all that it refers to."""
        if name in self.contents or name in self.above:
            return
        source = self._read(name)
        if not name.endswith(MODULES):
            self.contents[name] = source
            return
        try:
            source.decode("utf-8")
        except UnicodeDecodeError as error:
            line = source.count(b"\n", 0, error.start) + 1
            self._report(name, line, "not UTF-8; save the file as UTF-8")
            return
        module = parsed(source)
        if module.fault:
            line, what = module.fault
            self._report(name, line, f"syntax error: {what}")
            return
        self.above.append(name)
        pieces, end = [], 0
        for one in module.references:
            written = self._resolved(name, one)
            if written is not None:
                pieces += [source[end : one.start], json.dumps(written).encode()]
                end = one.end
        self.above.pop()
        self.contents[name] = b"".join([*pieces, source[end:]])

    def _resolved(self, importer: str, one: Reference) -> str | None:
        """Add the file that a module refers to; return its name from there, None if as written."""
        if one.name in CLIENTS and one.kind != "url":
            self.clients.add(one.name)
            # From panels/<digest>/.
            return "../" * (importer.count("/") + 2) + f"runtime/{CLIENTS[one.name]}"
        if not one.name.startswith(("./", "../")):
            if one.kind != "url":
                self._report(importer, one.line, _foreign(one.name))
            return None
        bare, mark, query = one.name.partition("?")
        file = (self.root / importer).parent / bare
        if not file.resolve().is_relative_to(self.root):
            self._report(importer, one.line, f"'{one.name}' is outside the folder of site.yaml")
            return None
        if not file.is_file():
            beside = file.parent.iterdir() if file.parent.is_dir() else ()
            names = (posixpath.join(posixpath.dirname(bare), each.name) for each in beside)
            self._report(importer, one.line, f"no file '{one.name}'; {nearest(bare, names)}")
            return None
        name = posixpath.normpath(posixpath.join(posixpath.dirname(importer), bare))
        if one.kind == "url":
            self._add(name)
            return None
        if name in self.above:
            cycle = " → ".join([*self.above[self.above.index(name) :], name])
            self._report(importer, one.line, f"modules import each other: {cycle}")
            return None
        if mark:
            message = f"'{one.name}' has a query '?{query}'; remove it: names depend on contents"
            self._report(importer, one.line, message)
            return None
        return self._imported(importer, one, name)

    def _imported(self, importer: str, one: Reference, name: str) -> str | None:
        suffix = posixpath.splitext(name)[1].lower()
        if suffix == ".json":
            return self._data(importer, one, name)
        if suffix == ".css":
            return self._sheet(importer, one, name)
        if suffix not in MODULES:
            how = f"new URL('{one.name}', import.meta.url)"
            self._report(importer, one.line, f"'{one.name}' is not a module; name it with {how}")
            return None
        self._add(name)
        return None

    def _data(self, importer: str, one: Reference, name: str) -> str | None:
        try:
            value = json.loads(self._read(name))
        except (ValueError, RecursionError) as error:
            line = getattr(error, "lineno", 1)
            self._report(name, line, f"not valid JSON: {getattr(error, 'msg', error)}")
            return None
        self.contents[f"{name}.js"] = f"export default {json.dumps(value)};\n".encode()
        return f"{one.name}.js"

    def _sheet(self, importer: str, one: Reference, name: str) -> str | None:
        try:
            text = self._read(name).decode("utf-8-sig")
        except UnicodeDecodeError:
            self._report(name, 1, "not UTF-8; save the file as UTF-8")
            return None
        self.contents[f"{name}.js"] = SHEET.replace("{}", json.dumps(text)).encode()
        if one.kind != "effect":
            return f"{one.name}.js"
        beside = json.dumps(f"./{posixpath.basename(name)}.js")
        self.contents[f"{name}.page.js"] = ADOPT.replace("{}", beside).encode()
        return f"{one.name}.page.js"


def _foreign(name: str) -> str:
    if name.partition("/")[0] == "sitegen":
        return f"no module '{name}'; {nearest(name, CLIENTS)}"
    if "://" in name or name.startswith("//"):
        return f"'{name}' is on another site; copy the file into this one"
    like = (name.rpartition("/")[2] or name).removesuffix(".js")
    return f"'{name}' is not a path; copy the library into this site and import './{like}.js'"
