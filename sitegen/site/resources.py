"""Find the files that a 3D view loads: meshes with what they need, and descriptions of robots."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from html import unescape
from pathlib import Path
from urllib.parse import unquote
from xml.etree import ElementTree

from sitegen import workspace
from sitegen.errors import Location, Problems, SiteError
from sitegen.ignored import is_ignored
from sitegen.launch import description
from sitegen.model import Artifact, Node, Package, Page, Site, Widget
from sitegen.site import meshes

KIND = "3d"
# Files that programs and descriptions are written in; longer ones are data.
TEXTS = {".cpp", ".hpp", ".h", ".py", ".urdf", ".xacro", ".xml", ".yaml", ".rviz", ".sdf"}
LONGEST = 1_000_000
# What meshes name inside: textures and libraries of materials.
INSIDE = {
    ".dae": re.compile(rb"<init_from>\s*([^<]+?\.\w+)\s*</init_from>"),
    ".obj": re.compile(rb"^mtllib[ \t]+(.+?)\s*$", re.M),
    ".mtl": re.compile(rb"^\s*(?:map_\w+|bump|norm)[ \t]+(?:-.*[ \t])?(.+?)\s*$", re.M),
    ".gltf": re.compile(rb'"uri"\s*:\s*"([^"]+)"'),
}
# A file and its text.
Source = tuple[Path, str]


@dataclass(frozen=True)
class Resources:
    """What the 3D views of a page load: the paths in `dist/` by URL, and all files.

    `notes` say which meshes the site does not have.
    """

    paths: Mapping[str, str]
    artifacts: Sequence[Artifact]
    notes: Sequence[str] = ()


def resources(site: Site, page: Page) -> Resources:
    """Return the meshes and descriptions that the 3D views of a page load.

    Which meshes a program names is known when it runs; those that its sources and parameters
    mention are taken.

    Raises: SiteError if a description cannot be read.
    """
    views = [part for part in page.leaves if isinstance(part, Widget) and part.kind == KIND]
    if not views:
        return Resources({}, ())
    packages = {**workspace.shipped_packages(), **(site.packages or workspace.scan(site.workspace))}
    sources = list(_sources(page.nodes.values(), packages))
    notes = Problems(site.root)
    found: dict[str, Artifact] = {}
    urls: dict[str, None] = {}
    for name in sorted(
        {str(one["file"]) for view in views for one in _displays(view) if "file" in one}
    ):
        text, named = _description(site, page, name, packages)
        found[name] = _described(name, text)
        urls |= dict.fromkeys(named)
        file = site.root / name
        own = [(file, _text(file)), *_texts(_package_of(file, packages))]
        _note(named, own, Location(file, 1), packages, notes)
    for node in page.nodes.values():
        given = (*node.parameters.values(), *node.arguments)
        named = [url for value in given for url in meshes.of_parameter(value)]
        urls |= dict.fromkeys(named)
        _note(named, sources, node.location, packages, notes)
    urls |= dict.fromkeys(url for source in sources for url in meshes.of_source(*source))
    urls |= dict.fromkeys(_by_name(sources, page.nodes.values(), packages))
    files = {meshes.canonical(url): one for url in urls if (one := _mesh(url, packages))}
    inside = _inside(files.values(), packages)
    paths = {url: one.path for url, one in {**found, **files}.items()}
    return Resources(paths, [*found.values(), *files.values(), *inside], notes.lines)


def _description(
    site: Site, page: Page, name: str, packages: Mapping[str, Package]
) -> tuple[str, list[str]]:
    """Return the description in a file, as it is published, and the meshes that it names."""
    try:
        folders = {each.name: each.path for each in packages.values()}
        text = description(site.root / name, folders)
        text = meshes.published(text, packages, (site.workspace, site.root))
        return text, meshes.of_description(text)
    except ElementTree.ParseError as error:
        line, column = error.position
        what = f"not well-formed XML (column {column + 1})"
        raise SiteError([f"{name}:{line}: {what}: {error.msg.partition(':')[0]}"]) from error
    except ValueError as error:
        raise SiteError([f"{page.path or '/'}: 3d: {name}: {error}"]) from error


def _used(nodes: Iterable[Node], packages: Mapping[str, Package]) -> Mapping[str, Package]:
    """Return the packages of nodes, and those that they depend on."""
    used: dict[str, Package] = {}
    left = [node.package for node in nodes]
    while left:
        package = packages.get(left.pop())
        if package and package.name not in used:
            used[package.name] = package
            left += package.depends
    return used


def _by_name(
    sources: Sequence[Source], nodes: Iterable[Node], packages: Mapping[str, Package]
) -> Iterator[str]:
    """Yield the meshes whose names are in programs that join them with the folder of a package."""
    names = {name for source in sources for name in meshes.names_of_source(*source)}
    for package in _used(nodes, packages).values() if names else ():
        for file in sorted(package.path.rglob("*")):
            if file.name in names:
                yield f"{meshes.SCHEME}{package.name}/{file.relative_to(package.path).as_posix()}"


def _note(
    urls: Iterable[str],
    sources: Sequence[Source],
    otherwise: Location,
    packages: Mapping[str, Package],
    notes: Problems,
) -> None:
    """Say which of `urls` name no file, and where a source names it."""
    for url in urls:
        if meshes.is_remote(url):
            continue
        try:
            meshes.find(url, packages)
        except LookupError as error:
            name = url.rpartition("/")[2]
            places = (
                Location(file, number)
                for wanted in (f"/{name}", name, "<mesh")
                for file, text in sources
                for number, line in enumerate(text.splitlines(), 1)
                if wanted in unescape(line)
            )
            notes.add(next(places, otherwise), "mesh", str(error.args[0]))


def _mesh(url: str, packages: Mapping[str, Package]) -> Artifact | None:
    try:
        package, file = meshes.find(url, packages)
    except LookupError:
        return None
    path = file.relative_to(package.path.resolve()).as_posix()
    return Artifact(f"meshes/{package.name}/{path}", file)


def _inside(found: Iterable[Artifact], packages: Mapping[str, Package]) -> Iterator[Artifact]:
    """Yield the files of the same package that meshes name, and those that these name."""
    left = list(found)
    seen = {one.path for one in left}
    while left:
        one = left.pop()
        assert isinstance(one.source, Path)
        package = one.path.split("/")[1]
        folder = packages[package].path.resolve()
        pattern = INSIDE.get(one.source.suffix.lower())
        for name in pattern.findall(one.source.read_bytes()) if pattern else ():
            text = unescape(name.decode("utf-8", "replace").replace("\\", "/"))
            places = [one.source.parent / each for each in (text, unquote(text))]
            file = next((each.resolve() for each in places if each.is_file()), folder)
            if text.startswith("data:") or file == folder or not file.is_relative_to(folder):
                continue
            path = f"meshes/{package}/{file.relative_to(folder).as_posix()}"
            if path not in seen:
                seen.add(path)
                left.append(Artifact(path, file))
                yield left[-1]


def _displays(view: Widget) -> list[dict[str, object]]:
    shown = view.options.get("displays")
    return shown if isinstance(shown, list) else []


def _described(name: str, text: str) -> Artifact:
    digest = hashlib.sha256(text.encode()).hexdigest()[:10]
    stem = re.sub(r"[^\w-]+", "-", Path(name).name.partition(".")[0])
    return Artifact(f"meshes/{stem}.{digest}.urdf", text.encode())


def _package_of(file: Path, packages: Mapping[str, Package]) -> Path:
    """Return the folder of the package that a file is in, or the folder of the file."""
    folders = {package.path for package in packages.values()}
    return next((folder for folder in file.parents if folder in folders), file.parent)


def _sources(nodes: Iterable[Node], packages: Mapping[str, Package]) -> Iterator[Source]:
    """Yield the texts of the packages that could name a mesh."""
    for package in _used(nodes, packages).values():
        yield from _texts(package.path)


def _texts(folder: Path) -> Iterator[Source]:
    """Yield the texts of a folder."""
    for file in sorted(folder.rglob("*")):
        inside = file.relative_to(folder).parts
        if file.suffix not in TEXTS or any(is_ignored(name, at_root=False) for name in inside):
            continue
        if file.is_file() and file.stat().st_size <= LONGEST:
            yield file, _text(file)


def _text(file: Path) -> str:
    return file.read_text(encoding="utf-8-sig", errors="replace")
