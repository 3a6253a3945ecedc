"""Prints the parameters that it is given, a line each: name, type, value."""

from __future__ import annotations

import rclpy
from rclpy.node import Node

TYPES = {
    **{"BOOL": "bool", "INTEGER": "integer", "DOUBLE": "double", "STRING": "string"},
    **{"BOOL_ARRAY": "bool_array", "INTEGER_ARRAY": "integer_array"},
    **{"DOUBLE_ARRAY": "double_array", "STRING_ARRAY": "string_array"},
}


def text(value: object) -> str:
    if isinstance(value, float):
        return f"{value:.17g}"
    return value if isinstance(value, str) else str(value)


def main() -> None:
    rclpy.init()
    node = Node("probe", namespace="/q", start_parameter_services=False)
    for name, parameter in sorted(node._parameter_overrides.items()):
        value, kind = parameter.value, TYPES[parameter.type_.name]
        written = "|".join(map(text, value)) if kind.endswith("_array") else text(value)
        print(name, kind, written)
    node.destroy_node()
    rclpy.shutdown()
