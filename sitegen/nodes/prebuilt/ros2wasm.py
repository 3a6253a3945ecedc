"""Turn the types that nodes of the ROS2WASM project name into what their pages need of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

from sitegen.interfaces import messages
from sitegen.interfaces.descriptions import described
from sitegen.interfaces.messages import MessageType
from sitegen.model import Node, Ros2wasm, Site

# On /rosout the page repeats what such a node logs.
LOG = "rcl_interfaces/msg/Log"

# The message types that each node needs, by the page's path and the node's name.
Types = Mapping[str, Mapping[str, dict[str, MessageType]]]


def types_of(site: Site, *, cache: Path) -> Types:
    """Return the message types of the site's nodes of that project, with all that they nest.

    Raises a SiteError that says what is wrong with the definitions of the workspace.
    """
    nodes = [node for page in site.pages for node in _nodes(page.nodes)]
    named = {name.partition("/")[0] for node in nodes for name in node.types.values()}
    prefixes = [described(site, sorted(named), cache=cache)] if nodes else []
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
