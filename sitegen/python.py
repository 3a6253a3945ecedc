"""Turn Python nodes into archives that their pages unpack: rclpy for all, and each package."""

from __future__ import annotations

import ast
import io
import re
import zipfile
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from sitegen import interfaces, messages, workspace
from sitegen.descriptions import described
from sitegen.messages import MessageType
from sitegen.model import Node, Package, Site

CLIENT = Path(__file__).parent / "clients" / "python"
PAGE = interfaces.ROS / "page"
KINDS = ("msg", "srv", "action")
# What every node of rclpy has in the graph, beside what its program makes.
SERVICES = (
    *("DescribeParameters", "GetParameterTypes", "GetParameters", "ListParameters"),
    *("SetParameters", "SetParametersAtomically"),
)
OF_RCLPY = {
    *("rcl_interfaces/msg/Log", "rcl_interfaces/msg/ParameterEvent"),
    *(f"rcl_interfaces/srv/{name}" for name in SERVICES),
    "type_description_interfaces/srv/GetTypeDescription",
}
# What pages need of what generators need too: of the parser only the types of slots.
SHARED = (
    *("rosidl_parser/__init__.py", "rosidl_parser/definition.py", "rpyutils/__init__.py"),
    *("rpyutils/add_dll_directories.py", "rpyutils/import_c_library.py"),
)
IMPORTED = re.compile(r"\b(\w+)\.(msg|srv|action)\b")
# Generated classes have fixed arrays of numbers in numpy's.
NUMPY = re.compile(rb"^import numpy\b", re.MULTILINE)
OUR_NUMPY = b"from rclpy_backend import fixed_array as numpy"
EPOCH = (1980, 1, 1, 0, 0, 0)


@dataclass(frozen=True)
class Bundles:
    """The archives of a site's Python nodes: one that all have in common, one of each package.

    `types` has the message types of each package's nodes.
    """

    common: bytes
    packages: Mapping[str, bytes]
    types: Mapping[str, dict[str, MessageType]]


def bundle(site: Site, nodes: Iterable[Node], *, cache: Path) -> Bundles | None:
    """Return the archives for those of `nodes` that are Python's; None if none is.

    Raises a SiteError that says what is wrong with the definitions of the workspace.
    """
    names = sorted({node.package for node in nodes if site.setup_of(node)})
    if not names:
        return None
    needs = {name: workspace.with_dependencies(site.packages, name) for name in names}
    parts = {one.name: one for packages in needs.values() for one in packages}
    prefix = described(site, parts, cache=cache)
    wanted = {"example_interfaces", *_named(parts.values()), *_named_by_rclpy()}
    classes = dict(_classes(_with_nested(wanted, prefix), prefix))
    return Bundles(
        _archive({**_rclpy(), **classes}),
        {name: _archive(dict(_installed(needs[name]))) for name in names},
        {name: _types(needs[name], prefix) for name in names},
    )


def _installed(packages: Iterable[Package]) -> Iterator[tuple[str, bytes]]:
    """Yield the files of a package and of those that it needs, by their place."""
    for package in packages:
        for place, file in (package.setup.files if package.setup else {}).items():
            yield place, file.read_bytes()


def _rclpy() -> dict[str, bytes]:
    """Return rclpy with all that it imports, by place."""
    given = {share.name for share in interfaces.shares([interfaces.ROS])}
    tops = [top for top in PAGE.iterdir() if top.name not in given]
    found = (file for top in tops for file in ([top] if top.is_file() else top.rglob("*")))
    files = {file.relative_to(PAGE).as_posix(): file for file in found if file.is_file()}
    files |= {name: interfaces.ROS / "python" / name for name in SHARED}
    files |= {file.relative_to(CLIENT).as_posix(): file for file in CLIENT.rglob("*.py")}
    files["rclpy/_rclpy_pybind11.py"] = files.pop("_rclpy_pybind11.py")
    return {f"python/{name}": file.read_bytes() for name, file in files.items()}


def _shares(prefix: Path) -> dict[str, Path]:
    return {share.name: share for share in interfaces.shares([interfaces.ROS, prefix])}


def _classes(packages: Iterable[str], prefix: Path) -> Iterator[tuple[str, bytes]]:
    """Yield the message classes of `packages`, by place."""
    for package in packages:
        for root in (prefix / "python", PAGE):
            files = sorted((root / package).rglob("*.py"))
            for file in files:
                text = NUMPY.sub(OUR_NUMPY, file.read_bytes())
                yield f"python/{file.relative_to(root).as_posix()}", text
            if files:
                break


def _named(packages: Iterable[Package]) -> Iterator[str]:
    """Yield the packages whose messages `packages` may use: declared, or imported all the same."""
    for package in packages:
        yield package.name
        yield from package.depends
        for text in _sources(package):
            yield from (match[1] for match in IMPORTED.finditer(text))


def _named_by_rclpy() -> Iterator[str]:
    for file in (PAGE / "rclpy").rglob("*.py"):
        yield from (match[1] for match in IMPORTED.finditer(file.read_text(encoding="utf-8")))


def _sources(package: Package) -> Iterator[str]:
    scripts = package.setup.scripts.values() if package.setup else ()
    for place, file in (package.setup.files if package.setup else {}).items():
        if file.suffix == ".py" or place in scripts:
            yield file.read_text(encoding="utf-8", errors="replace")


def _with_nested(names: Iterable[str], prefix: Path) -> list[str]:
    """Return those of `names` that define interfaces, and all whose messages they nest."""
    shares = _shares(prefix)
    found: set[str] = set()
    waiting = list(names)
    while waiting:
        name = waiting.pop()
        if name in found or name not in shares:
            continue
        found.add(name)
        for kind in KINDS:
            for file in (shares[name] / kind).glob("*.json"):
                nested = re.findall(r'"nested_type_name": *"(\w+)/', file.read_text())
                waiting += dict.fromkeys(nested)
    return sorted(found)


def _types(packages: Iterable[Package], prefix: Path) -> dict[str, MessageType]:
    """Return the message types that the modules of `packages` import, with all that they nest."""
    shares = _shares(prefix)
    names = set(OF_RCLPY)
    for package in packages:
        for text in _sources(package):
            names |= set(_imported(text, shares))
    parts = {"srv": ("_Request", "_Response"), "msg": ("",)}
    every = (name + part for name in names for part in parts.get(name.split("/")[1], ()))
    return messages.types(every, [prefix])


def _imported(text: str, shares: Mapping[str, Path]) -> Iterator[str]:
    """Yield the interfaces that a module imports; all of a package that it imports as a whole."""
    try:
        tree = ast.parse(text)
    except SyntaxError:
        return  # Python will say so, in the console
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module and not node.level:
            package, _, kind = node.module.partition(".")
            if package in shares and kind in KINDS:
                yield from (f"{package}/{kind}/{alias.name}" for alias in node.names)
        elif isinstance(node, ast.Import):
            for alias in node.names:
                package, _, kind = alias.name.partition(".")
                if package in shares and kind in KINDS:
                    files = (shares[package] / kind).glob("*.json")
                    yield from (f"{package}/{kind}/{file.stem}" for file in files)


def _archive(files: Mapping[str, bytes]) -> bytes:
    """Return a ZIP file, the same bytes for the same files."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(name, EPOCH)
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, files[name])
    return buffer.getvalue()
