"""Names of nodes, topics and services: validation, expansion and remapping."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from rclpy_backend.errors import RCLError

if TYPE_CHECKING:
    from rclpy_backend.node import Node

LONGEST_NODE = 255
# Middlewares add a prefix or suffix of up to eight characters.
LONGEST_TOPIC = 255 - 8

# The reason why a name is invalid, and the position of the fault.
Fault = tuple[str, int]

WORD = re.compile(r"\w", re.ASCII)
DIGIT_FIRST = re.compile(r"(?:^|(?<=/))[0-9]")
BRACES = re.compile(r"\{\w*\}", re.ASCII)


def _first_other(name: str, allowed: str) -> int | None:
    """Return the position of the first character that is not alphanumeric, `_` or in `allowed`."""
    odd = (i for i, c in enumerate(name) if not WORD.match(c) and c not in allowed)
    return next(odd, None)


def rclpy_get_validation_error_for_node_name(node_name: str) -> Fault | None:
    """Return why the name of a node is invalid, or None."""
    if not node_name:
        return "node name must not be empty", 0
    if (at := _first_other(node_name, "")) is not None:
        return "node name must not contain characters other than alphanumerics or '_'", at
    if node_name[0] in "0123456789":
        return "node name must not start with a number", 0
    if len(node_name) > LONGEST_NODE:
        return f"node name length should not exceed '{LONGEST_NODE}'", LONGEST_NODE - 1
    return None


def rclpy_get_validation_error_for_namespace(namespace_: str) -> Fault | None:
    """Return why a namespace is invalid, or None."""
    if namespace_ == "/":
        return None
    if not namespace_:
        return "namespace must not be empty", 0
    if namespace_[0] != "/":
        return "namespace must be absolute, it must lead with a '/'", 0
    if namespace_[-1] == "/":
        return "namespace must not end with a '/', unless only a '/'", len(namespace_) - 1
    if (at := _first_other(namespace_, "/")) is not None:
        return "namespace must not contain characters other than alphanumerics, '_', or '/'", at
    if "//" in namespace_:
        return "namespace must not contain repeated '/'", namespace_.index("//") + 1
    if digit := DIGIT_FIRST.search(namespace_):
        return "namespace must not have a token that starts with a number", digit.start()
    if len(namespace_) > LONGEST_TOPIC - 2:
        return "namespace should not exceed 'RMW_NAMESPACE_MAX_NAME_LENGTH'", LONGEST_TOPIC - 3
    return None


def rclpy_get_validation_error_for_topic_name(topic_name: str) -> Fault | None:
    """Return why a name is invalid before expansion, or None."""
    if not topic_name:
        return "topic name must not be empty string", 0
    if topic_name[-1] == "/":
        return "topic name must not end with a forward slash", len(topic_name) - 1
    brace: int | None = None
    for i, c in enumerate(topic_name):
        if c == "}" and brace is None:
            return "topic name must not have unmatched (unbalanced) curly braces '{}'", i
        if c == "}":
            brace = None
        elif brace is not None and not WORD.match(c):
            others = "characters other than alphanumerics or '_'"
            return f"substitution name must not contain {others}", i
        elif c == "{":
            brace = i
        elif c == "~" and i > 0:
            return "topic name must not have tilde '~' unless it is the first character", i
        elif not WORD.match(c) and c not in "/~":
            others = "characters other than alphanumerics, '_', '~', '{', or '}'"
            return f"topic name must not contain {others}", i
    if brace is not None:
        return "topic name must not have unmatched (unbalanced) curly braces '{}'", brace
    if digit := DIGIT_FIRST.search(topic_name):
        return "topic name token must not start with a number", digit.start()
    return None


def rclpy_get_validation_error_for_full_topic_name(topic_name: str) -> Fault | None:
    """Return why an expanded name is invalid, or None."""
    if not topic_name:
        return "topic name must not be empty", 0
    if topic_name[0] != "/":
        return "topic name must be absolute, it must lead with a '/'", 0
    if topic_name[-1] == "/":
        return "topic name must not end with a '/'", len(topic_name) - 1
    if (at := _first_other(topic_name, "/")) is not None:
        return "topic name must not contain characters other than alphanumerics, '_', or '/'", at
    if "//" in topic_name:
        return "topic name must not contain repeated '/'", topic_name.index("//") + 1
    if digit := DIGIT_FIRST.search(topic_name):
        return "topic name must not have a token that starts with a number", digit.start()
    if len(topic_name) > LONGEST_TOPIC:
        return "topic length should not exceed '255U - 8U'", LONGEST_TOPIC - 1
    return None


def rclpy_expand_topic_name(topic: str, node: str, node_namespace: str) -> str:
    """Return the expanded name of a topic or service, before remapping.

    Raises:
        ValueError: if the name is invalid.
    """
    fault = rclpy_get_validation_error_for_topic_name(topic)
    if fault:
        raise ValueError(f"topic name '{topic}' is invalid: {fault[0]}")
    before = node_namespace if node_namespace.endswith("/") else f"{node_namespace}/"
    known = {"{node}": node, "{ns}": node_namespace, "{namespace}": node_namespace}

    def fill(match: re.Match[str]) -> str:
        if match[0] not in known:
            raise ValueError(f"topic name '{topic}' is invalid: unknown substitution: {match[0]}")
        return known[match[0]]

    full = BRACES.sub(fill, topic)
    if full[0] == "~":
        return before + node + full[1:]
    return full if full[0] == "/" else before + full


def rclpy_resolve_name(node: Node, topic_name: str, only_expand: bool, is_service: bool) -> str:
    """Return the name in the graph: expanded, and remapped unless `only_expand`.

    Raises:
        RCLError: if the name is invalid.
    """
    try:
        full = rclpy_expand_topic_name(topic_name, node.get_node_name(), node.get_namespace())
    except ValueError as error:
        raise RCLError(f"failed to resolve name: {error}") from None
    name = full if only_expand else node.remap(full, "service" if is_service else "topic")
    fault = rclpy_get_validation_error_for_full_topic_name(name)
    if fault:
        raise RCLError(f"failed to resolve name: topic name '{name}' is invalid: {fault[0]}")
    return name


def rclpy_remap_topic_name(node: Node, topic_name: str) -> str:
    """Return the name after the remapping rules of the arguments."""
    return node.remap(topic_name, "topic")
