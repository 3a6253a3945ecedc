"""Nodes: names, remapping rules and parameter overrides."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import ros_host

from rclpy_backend import log, names
from rclpy_backend.arguments import parse
from rclpy_backend.endpoint import create
from rclpy_backend.errors import RCLError
from rclpy_backend.graph import GraphQueries
from rclpy_backend.handles import Context, Destroyable
from rclpy_backend.qos import rmw_qos_profile_t
from sitegen.rclyaml import matches

if TYPE_CHECKING:
    from rclpy.parameter import Parameter


class Node(Destroyable, GraphQueries):
    """A node of the graph.

    Raises:
        RCLError: if the context has been shut down.
        ValueError: if the name or namespace is invalid.
    """

    def __init__(
        self,
        node_name: str,
        namespace_: str,
        context: Context,
        pycli_args: Sequence[str] | None,
        use_global_arguments: bool,
        enable_rosout: bool,
        rosout_qos_profile: rmw_qos_profile_t,
    ) -> None:
        super().__init__()
        if not context.ok():
            raise RCLError("error creating node: the given context is not valid")
        self.context = context
        own = parse(["--ros-args", *pycli_args] if pycli_args else [])
        self._arguments = [own, *([context.arguments] if use_global_arguments else [])]
        self._name = self._remap_self(node_name, ("__node", "__name"), node_name)
        namespace = self._remap_self(node_name, ("__ns",), namespace_)
        self._namespace = namespace if namespace.startswith("/") else f"/{namespace}"
        for fault in (
            names.rclpy_get_validation_error_for_node_name(self._name),
            names.rclpy_get_validation_error_for_namespace(self._namespace),
        ):
            if fault:
                raise ValueError(fault[0])
        self.id = self._create(rosout_qos_profile)
        self._rosout = log.Rosout(self, rosout_qos_profile) if enable_rosout else None

    def _create(self, profile: rmw_qos_profile_t) -> int:
        # The page expects QoS with every entry, although a node has none.
        return create("node", self.get_fully_qualified_name(), "", "", profile, offers=False)

    def _destroy(self) -> None:
        if self._rosout:
            self._rosout.close()
        ros_host.destroy(self.id)

    def _remap_self(self, node: str, olds: Sequence[str], name: str) -> str:
        rules = (rule for arguments in self._arguments for rule in arguments.remaps)
        fits = (rule.new for rule in rules if rule.old in olds and rule.node in ("", node))
        return next(fits, name)

    def remap(self, name: str, kind: str) -> str:
        """Return the remapped name of a topic or a service (`kind`)."""
        for rule in (rule for arguments in self._arguments for rule in arguments.remaps):
            applies = rule.node in ("", self._name) and rule.kind in ("", kind)
            if applies and not rule.old.startswith("__") and self._expand(rule.old) == name:
                return self._expand(rule.new)
        return name

    def _expand(self, name: str) -> str:
        return names.rclpy_expand_topic_name(name, self._name, self._namespace)

    def get_fully_qualified_name(self) -> str:
        """Return the name with the namespace."""
        return f"{self._namespace.removesuffix('/')}/{self._name}"

    def logger_name(self) -> str:
        """Return the name of the node's logger."""
        return self.get_fully_qualified_name()[1:].replace("/", ".")

    def get_node_name(self) -> str:
        """Return the name without the namespace."""
        return self._name

    def get_namespace(self) -> str:
        """Return the namespace."""
        return self._namespace

    def get_parameters(
        self, pyparamter_cls: Callable[..., Parameter[Any]]
    ) -> dict[str, Parameter[Any]]:
        """Return the parameter overrides; those of the node precede those of its context."""
        given = (one for arguments in reversed(self._arguments) for one in arguments.parameters)
        full = self.get_fully_qualified_name()
        values = {one.name: one.value for one in given if matches(one.pattern, full)}
        return {name: pyparamter_cls(name, value=value) for name, value in values.items()}
