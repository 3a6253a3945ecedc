"""Define the keys of nodes in site.yaml."""

from __future__ import annotations

from sitegen.config.schema import Key

_NEEDS = Key(
    "needs", "list of text", "nodes that this one depends on, by name", "needs: [turtlesim]"
)

# Keys of all nodes.
_HOW = (
    Key("namespace", "text", "namespace of the node, starting with `/`", "namespace: /demo"),
    Key(
        "remap",
        "mapping of texts",
        "remapping rules, as with `-r from:=to`",
        "remap: {chatter: /demo/chatter}",
    ),
    Key("parameters", "parameters", "parameter values or files", "parameters: {speed: 2.5}"),
    Key("arguments", "list of text", "further arguments of `main()`", "arguments: [--foo]"),
    Key("environment", "mapping of texts", "environment variables", "environment: {MODEL: fox}"),
)

NODE = (
    Key("package", "text", "package in the workspace", "package: cpp_pubsub", True),
    Key("executable", "text", "executable or component of the package", "executable: talker", True),
    *_HOW,
    Key("urdf", "path", "parameter `robot_description`: URDF or xacro", "urdf: src/arm/arm.urdf"),
    Key("group", "text", "Python nodes of a group share an interpreter", "group: robot"),
    _NEEDS,
)

COMPILED = (
    Key(
        "compiled", "text", "archive: a file or an `https://` address", "compiled: nodes.zip", True
    ),
    Key(
        "sha256",
        "digest",
        "SHA-256 of the archive; required for an address",
        "sha256: 72a66436beb4c95047286bc22bc7295cd1168bc8b3309ef35897a6802a22a2fb",
    ),
    Key("package", "text", "package, if the archive has several", "package: cpp_pubsub"),
    Key("executable", "text", "executable, if the archive has several", "executable: talker"),
    *_HOW,
    _NEEDS,
)

ROS2WASM = (
    Key(
        "ros2wasm", "path", "worker script written by Emscripten", "ros2wasm: nodes/talker.js", True
    ),
    Key(
        "types",
        "mapping of interfaces",
        "types of its topics and services",
        "types: {/chatter: std_msgs/msg/String}",
        True,
    ),
    _NEEDS,
)
