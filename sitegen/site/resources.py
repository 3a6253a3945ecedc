"""Find the files that a 3D view loads: meshes with what they need, and descriptions of robots."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from sitegen import workspace
from sitegen.errors import SiteError
from sitegen.ignored import is_ignored
from sitegen.launch import description
from sitegen.model import Artifact, Node, Package, Page, Site, Widget

KIND = "3d"
MESH = re.compile(
    r"package://([A-Za-z]\w*)/([\w./+@ -]+?\.(?:stl|dae|obj|gltf|glb))\b", re.I | re.A
)
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


@dataclass(frozen=True)
class Resources:
    """What the 3D views of a page load: the paths in `dist/` by URL, and all files."""

    paths: Mapping[str, str]
    artifacts: Sequence[Artifact]


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
    files = sorted({str(one["file"]) for view in views for one in _displays(view) if "file" in one})
    descriptions = {name: _description(site, page, name, packages) for name in files}
    texts = [*descriptions.values(), *_texts(page.nodes.values(), packages)]
    named = {match[0]: (match[1], match[2]) for text in texts for match in MESH.finditer(text)}
    found = {name: _described(name, text) for name, text in descriptions.items()}
    meshes = {url: one for url, place in named.items() if (one := _mesh(*place, packages))}
    inside = _inside(meshes.values(), packages)
    paths = {url: one.path for url, one in {**found, **meshes}.items()}
    return Resources(paths, [*found.values(), *meshes.values(), *inside])


def _description(site: Site, page: Page, name: str, packages: Mapping[str, Package]) -> str:
    try:
        folders = {each.name: each.path for each in packages.values()}
        return description(site.root / name, folders)
    except ValueError as error:
        raise SiteError([f"{page.path or '/'}: 3d: {name}: {error}"]) from error


def _texts(nodes: Collection[Node], packages: Mapping[str, Package]) -> Iterator[str]:
    """Yield what could name a mesh: values of parameters, and the sources of the programs."""
    for node in nodes:
        yield from node.parameters.values()
        yield from node.arguments
    used: dict[str, Package] = {}
    left = [node.package for node in nodes]
    while left:
        package = packages.get(left.pop())
        if package and package.name not in used:
            used[package.name] = package
            left += package.depends
    for package in used.values():
        yield from _sources(package.path)


def _mesh(package: str, path: str, packages: Mapping[str, Package]) -> Artifact | None:
    """Return a mesh of a package; the page says which one it does not find."""
    folder = packages[package].path.resolve() if package in packages else None
    file = (folder / path).resolve() if folder else None
    if not folder or not file or not file.is_relative_to(folder) or not file.is_file():
        return None
    return Artifact(f"meshes/{package}/{file.relative_to(folder).as_posix()}", file)


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
            text = name.decode("utf-8", "replace").replace("\\", "/")
            file = (one.source.parent / text).resolve()
            if text.startswith("data:") or not file.is_relative_to(folder) or not file.is_file():
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


def _sources(folder: Path) -> Iterator[str]:
    """Yield the texts of a package."""
    for file in sorted(folder.rglob("*")):
        inside = file.relative_to(folder).parts
        if file.suffix not in TEXTS or any(is_ignored(name, at_root=False) for name in inside):
            continue
        if file.is_file() and file.stat().st_size <= LONGEST:
            yield file.read_text(encoding="utf-8-sig", errors="replace")
