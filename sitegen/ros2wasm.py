"""Turn the types that nodes of the ROS2WASM project name into what their pages need of them."""

from __future__ import annotations

import contextlib
import os
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from sitegen import interfaces, messages, workspace
from sitegen.digest import digest_of
from sitegen.errors import SiteError
from sitegen.messages import MessageType
from sitegen.model import Node, Package, Ros2wasm, Site

# On /rosout the page repeats what such a node logs.
LOG = "rcl_interfaces/msg/Log"
GENERATOR = ("definitions.py", "interfaces.py")

# The message types that each node needs, by the page's path and the node's name.
Types = Mapping[str, Mapping[str, dict[str, MessageType]]]


def types_of(site: Site, *, cache: Path) -> Types:
    """Return the message types of the site's nodes of that project, with all that they nest.

    Raises a SiteError that says what is wrong with the definitions of the workspace.
    """
    nodes = [node for page in site.pages for node in _nodes(page.nodes)]
    named = {name.partition("/")[0] for node in nodes for name in node.types.values()}
    prefixes = [_described(site, sorted(named), cache)] if nodes else []
    return {
        page.path: {
            name: messages.types(_parts(node.ros2wasm), prefixes)
            for name, node in page.nodes.items()
            if node.ros2wasm
        }
        for page in site.pages
    }


def _nodes(nodes: Mapping[str, Node]) -> Iterator[Ros2wasm]:
    return (node.ros2wasm for node in nodes.values() if node.ros2wasm)


def _parts(node: Ros2wasm) -> Iterator[str]:
    """Yield the messages that travel on the topics and services of `node`."""
    yield LOG
    for name in node.types.values():
        parts = ("_Request", "_Response") if "/srv/" in name else ("",)
        yield from (f"{name}{part}" for part in parts)


def _described(site: Site, named: Sequence[str], cache: Path) -> Path:
    """Return a prefix with the type descriptions of those packages that bring none."""
    needs: dict[str, Package] = {}
    for name in named:
        needs |= {one.name: one for one in workspace.with_dependencies(site.packages, name)}
    packages = [
        *((folder.name, folder, _files(folder)) for folder in sorted(interfaces.OWN.iterdir())),
        *((one.name, one.path, one.interfaces) for one in needs.values() if one.interfaces),
    ]
    sources = [Path(__file__).with_name(name) for name in GENERATOR]
    digest = digest_of([*sources, *(folder for _, folder, _ in packages)])
    prefix = cache / "descriptions" / digest
    if not prefix.exists():
        prefix.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=prefix.parent) as temporary:
            fresh = Path(temporary) / "new"
            for package, folder, files in packages:
                _describe(fresh, package, folder, files, site.root)
            with contextlib.suppress(OSError):  # another build was first
                fresh.rename(prefix)
    return prefix


def _files(folder: Path) -> Sequence[str]:
    return sorted(file.relative_to(folder).as_posix() for file in folder.glob("*/*.*"))


def _describe(prefix: Path, package: str, folder: Path, files: Sequence[str], root: Path) -> None:
    # rosidl says on the standard output what it does.
    with Path(os.devnull).open("w") as nowhere, contextlib.redirect_stdout(nowhere):
        try:
            interfaces.describe(prefix, [prefix], package, folder, files)
        except SiteError as error:
            lines = [line.removeprefix(f"{root}/") for line in error.lines]
            raise SiteError(lines) from None
