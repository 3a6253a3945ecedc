"""Find the meshes that descriptions of robots and sources of programs name."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from html import escape, unescape
from pathlib import Path
from urllib.parse import unquote, urlsplit
from xml.etree import ElementTree

import yaml

from sitegen.errors import nearest
from sitegen.launch.shares import PREFIX, on_page
from sitegen.model import Package
from sitegen.nodes.share import MESHES

PICTURES = (".png", ".jpg", ".jpeg", ".webp")
SCHEME = "package://"
SHARE = re.compile(rf"(?:file://)?{PREFIX}/share/")
# A URL in a source begins after a quote, a tag or a blank, and ends where that ends.
NAMED = re.compile(
    r"""(?P<quote>["'])(package://(?:(?!(?P=quote))[^\n])+)(?P=quote)"""
    r"""|>\s*(package://[^<\n]+?)\s*<|(?<![\w"'>])(package://[^\s"'<>]+)"""
)
QUOTED = re.compile(r"""(["'])((?:(?!\1)[^\n])+)\1""")
MARKUP = (".urdf", ".xacro", ".xml", ".sdf")
# What is outside of the packages has no other path in the page.
OUTSIDE = Path(f"{PREFIX}/workspace")


def canonical(url: str) -> str:
    """Return the URL of a file of a package as `package://…`; others are returned unchanged."""
    return SHARE.sub(SCHEME, url, count=1) if SHARE.match(url) else url


def published(text: str, packages: Mapping[str, Package], roots: Iterable[Path]) -> str:
    """Replace the paths of the author's computer in a description by those in the page."""
    folders = [(name, package.path) for name, package in packages.items()]
    # A package may be inside of another one, and all are below the roots.
    folders.sort(key=lambda one: -len(str(one[1])))
    for name, folder in folders:
        for path in _spellings(folder):
            text = on_page(text, {name: path})
    for root in roots:
        for path in _spellings(root):
            if path != path.parent:
                text = text.replace(f"{path}/", f"{OUTSIDE}/")
    return text


def _spellings(folder: Path) -> Iterator[Path]:
    for path in dict.fromkeys((folder.absolute(), folder.resolve())):
        yield from dict.fromkeys((path, Path(escape(str(path), quote=False))))


def of_description(text: str) -> list[str]:
    """Return the URLs of the meshes and textures of a description.

    Raises: ElementTree.ParseError if it is not well-formed.
    """
    robot = ElementTree.fromstring(text.lstrip())
    named = (one.get("filename") for kind in ("mesh", "texture") for one in robot.iter(kind))
    return list(dict.fromkeys(url for url in named if url))


def of_parameter(value: str) -> list[str]:
    """Return the URLs of the meshes in the value of a parameter, which may be a description."""
    text = value.strip()
    if text[:1] in ("'", '"'):
        try:
            text = str(yaml.safe_load(text)).strip()
        except yaml.YAMLError:
            return []
    if text.startswith("<"):
        try:
            return of_description(text)
        except ElementTree.ParseError:
            return []  # it may be something else
    text = canonical(text)
    return [text] if text.startswith(SCHEME) and _is_mesh(text) else []


def of_source(file: Path, text: str) -> Iterator[str]:
    """Yield the URLs of the meshes that a source of a program or a description names."""
    if SCHEME in text:
        for match in NAMED.finditer(text):
            url = match[2] or match[3] or match[4]
            url = unescape(url) if file.suffix in MARKUP else url
            if _is_mesh(url):
                yield url


def names_of_source(file: Path, text: str) -> Iterator[str]:
    """Yield the names of mesh files in the strings of a program that makes `file://` URLs."""
    if "file://" in text and file.suffix not in MARKUP:
        for match in QUOTED.finditer(text):
            if _is_mesh(match[2]):
                yield match[2].rpartition("/")[2]


def _is_mesh(url: str) -> bool:
    return url.lower().endswith(MESHES)


def find(url: str, packages: Mapping[str, Package]) -> tuple[Package, Path]:
    """Return the file that a URL names, and its package.

    Raises: LookupError, with the reason, if it names none.
    """
    given = canonical(url)
    name, _, rest = given.removeprefix(SCHEME).partition("/")
    if not given.startswith(SCHEME):
        raise LookupError(f"'{url}' is not in a package; write package://PACKAGE/PATH")
    if name not in packages:
        raise LookupError(f"'{url}': no package '{name}' in the workspace")
    if not given.lower().endswith((*MESHES, *PICTURES)):
        raise LookupError(f"'{url}' is not an STL, COLLADA, OBJ or glTF file")
    package = packages[name]
    folder = package.path.resolve()
    for path in dict.fromkeys((rest, unquote(rest))):
        file = package.share.get(f"share/{name}/{path}", folder / path).resolve()
        if file.is_relative_to(folder) and file.is_file():
            return package, file
    others = (one.name for one in folder.rglob("*") if _is_mesh(one.name))
    what = f"no file '{rest}' in package '{name}'"
    raise LookupError(f"'{url}': {what}; {nearest(rest.rpartition('/')[2], others)}")


def is_remote(url: str) -> bool:
    """Return whether a URL is on another server, where the page asks for it."""
    return urlsplit(url).scheme in ("http", "https", "data", "blob")
