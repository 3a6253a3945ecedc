"""Component containers of Python launch files, and what is loaded into them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from sitegen.launch.describe_actions import Described, node
from sitegen.launch.describe_actions import parameters as described_parameters


def composable(
    *,
    package: Any,
    plugin: Any,
    name: Any = None,
    namespace: Any = None,
    parameters: Iterable[Any] | None = None,
    remappings: Iterable[tuple[Any, Any]] | None = None,
    condition: Any = None,
    **_: Any,
) -> Described:
    """Describe a component."""
    inside = described_parameters(parameters or ())
    inside += (Described("remap", **{"from": old, "to": new}) for old, new in remappings or ())
    return Described(
        "composable_node",
        inside,
        pkg=package,
        plugin=plugin,
        name=name,
        namespace=namespace,
        condition=condition,
    )


def container(*, composable_node_descriptions: Iterable[Any] | None = None, **of: Any) -> Described:
    """Describe a component container, a node with components."""
    described = node(**of)
    described.kind = "node_container"
    described.inside += composable_node_descriptions or ()
    return described


def load(
    *, composable_node_descriptions: Iterable[Any], target_container: Any, condition: Any = None
) -> Described:
    """Describe components for a container that is described elsewhere, by its name or action."""
    is_action = isinstance(target_container, Described)
    return Described(
        "load_composable_node",
        composable_node_descriptions,
        target=target_container.id if is_action else target_container,
        condition=condition,
    )


ROS: dict[str, Any] = {
    "ComposableNode": composable,
    "ComposableNodeContainer": container,
    "LoadComposableNodes": load,
}
