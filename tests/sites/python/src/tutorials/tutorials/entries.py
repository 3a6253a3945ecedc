"""Print all names of rclpy's extension and of its classes, as JSON."""

import json

from rclpy.impl.implementation_singleton import rclpy_implementation


def assigned(kind):
    """Return what the classes of Python assign when they are made, and no dir() shows."""
    makers = (vars(each).get("__init__") for each in kind.__mro__)
    return {n for m in makers for n in getattr(getattr(m, "__code__", None), "co_names", ())}


def main():
    """Print a line for each name."""
    for name in sorted(dir(rclpy_implementation)):
        value = getattr(rclpy_implementation, name)
        inside = sorted({*dir(value), *assigned(value)}) if isinstance(value, type) else []
        number = value if isinstance(value, int) else None
        members = {k: int(v) for k, v in getattr(value, "__members__", {}).items()}
        print(json.dumps([name, inside, number, members]))
