"""Print all names of rclpy's extension and of its classes, as JSON."""

import json

from rclpy.impl.implementation_singleton import rclpy_implementation


def main():
    """Print a line for each name."""
    for name in sorted(dir(rclpy_implementation)):
        value = getattr(rclpy_implementation, name)
        inside = sorted(dir(value)) if isinstance(value, type) else []
        number = value if isinstance(value, int) else None
        members = {k: int(v) for k, v in getattr(value, "__members__", {}).items()}
        print(json.dumps([name, inside, number, members]))
