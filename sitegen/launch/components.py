"""The component containers of a launch file, and what is loaded into them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from sitegen.errors import nearest
from sitegen.launch.names import joined
from sitegen.launch.scope import Scope
from sitegen.launch.texts import Texts
from sitegen.launch.tree import REFERENCE, Action
from sitegen.model import Component, Container, Node
from sitegen.workspace import containers

# Returns whether the conditions of an action hold.
Holds = Callable[[Action, Scope], bool]
# Returns whether an action is left out, because the workspace lacks the package that it names.
Lacks = Callable[[Action, str], bool]


class Components:
    """Collects the components of each container."""

    def __init__(self, texts: Texts, holds: Holds, lacks: Lacks) -> None:
        self._texts = texts
        self._holds = holds
        self._lacks = lacks
        # By the full name of a container, and by the id of its action: its node, and the components
        # loaded into it.
        self._loaded: dict[str, tuple[str, list[Component]]] = {}
        # The components of containers that lack others.
        self._incomplete: list[list[Component]] = []

    def contain(self, node: Node, action: Action, scope: Scope) -> None:
        """Note a container that `action` starts, with the components in it."""
        name = node.remap.get("__node", self._texts.needed(action, "exec", scope))
        loaded: list[Component] = []
        self._loaded[f"{node.namespace}/{name}"] = self._loaded[action.id] = (node.name, loaded)
        self._load(loaded, action, scope)

    def load(self, action: Action, scope: Scope) -> None:
        """Load the components inside `action` into the container that it names."""
        target = self._texts.needed(action, "target", scope)
        if target.startswith(REFERENCE) and target not in self._loaded:
            raise ValueError("the launch file does not start the component container before")
        # launch_ros calls the service of the container from outside of all namespaces.
        full = target if target.startswith((REFERENCE, "/")) else f"/{target}"
        if full not in self._loaded:
            known = nearest(full, [name for name in self._loaded if name.startswith("/")])
            raise ValueError(f"no component container '{full}' in this launch file; {known}")
        self._load(self._loaded[full][1], action, scope)

    def finished(self, nodes: Sequence[Node]) -> list[Node]:
        """Return the nodes, with all components loaded into their containers.

        A container whose components are all left out is left out, too.
        """
        loaded = dict(self._loaded.values())
        emptied = {
            name
            for name, components in loaded.items()
            if not components and any(components is each for each in self._incomplete)
        }
        return [
            replace(
                node,
                executable=containers.executable(node.executable, loaded[node.name]),
                kind=Container(tuple(loaded[node.name])),
            )
            if loaded.get(node.name)
            else node
            for node in nodes
            if node.name not in emptied
        ]

    def _load(self, loaded: list[Component], action: Action, scope: Scope) -> None:
        texts = self._texts
        for each in action.of_kind("composable_node"):
            if not self._holds(each, scope):
                continue
            package = texts.needed(each, "pkg", scope)
            if self._lacks(each, package):
                self._incomplete.append(loaded)
                continue
            own = texts.text(each, "name", scope)
            namespace = joined(scope.namespace, texts.text(each, "namespace", scope))
            rules = {"__node": own, "__ns": namespace, **texts.remaps(each, scope)}
            words = [w for old, new in rules.items() if new for w in ("-r", f"{old}:={new}")]
            for parameter, value in texts.rules(each, scope, namespace).items():
                words += ["-p", f"{parameter}:={value}"]
            loaded.append(
                Component(
                    package=package,
                    plugin=texts.needed(each, "plugin", scope),
                    arguments=("--ros-args", *words) if words else (),
                    location=each.location,
                )
            )
