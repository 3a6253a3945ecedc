"""Nodes: names, remapping rules and parameter overrides."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import ros_host
import yaml

from rclpy_backend import log, names
from rclpy_backend.arguments import Arguments, Override, parse
from rclpy_backend.endpoint import create
from rclpy_backend.errors import RCLError
from rclpy_backend.graph import GraphQueries
from rclpy_backend.handles import Context, Destroyable
from rclpy_backend.qos import rmw_qos_profile_t

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
        values: dict[str, Any] = {}
        for arguments in reversed(self._arguments):
            values |= self._values(arguments)
        return {name: pyparamter_cls(name, value=value) for name, value in values.items()}

    def _values(self, arguments: Arguments) -> dict[str, Any]:
        values: dict[str, Any] = {}
        for given in arguments.parameters:
            if not isinstance(given, Override):
                text = Path(given).read_text(encoding="utf-8")
                for node, parameters in _sections("", yaml.safe_load(text) or {}):
                    if self._is_meant(node):
                        values |= dict(_flat("", parameters))
            elif not given.node or self._is_meant(given.node):
                values[given.name] = yaml.safe_load(given.value)
        return values

    def _is_meant(self, pattern: str) -> bool:
        """Return whether a name or a pattern with * and ** matches this node."""
        if pattern == self._name:
            return True
        parts = re.escape(f"/{pattern.lstrip('/')}").replace(r"/\*\*", "(/.*)?")
        return bool(re.fullmatch(parts.replace(r"\*", "[^/]+"), self.get_fully_qualified_name()))


def _sections(path: str, part: Mapping[str, Any]) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Yield the nodes of a parameter file with their parameters."""
    for key, value in part.items():
        name = f"{path}/{key.strip('/')}"
        if isinstance(value, Mapping) and "ros__parameters" in value:
            yield name, value["ros__parameters"] or {}
        elif isinstance(value, Mapping):
            yield from _sections(name, value)


def _flat(prefix: str, parameters: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    for key, value in parameters.items():
        if isinstance(value, Mapping):
            yield from _flat(f"{prefix}{key}.", value)
        else:
            yield f"{prefix}{key}", value
