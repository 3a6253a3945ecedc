"""The arrays of message classes: numpy's if the page has it, fixed_array's otherwise."""

try:
    import numpy
except ImportError:
    from rclpy_backend.arrays import fixed_array as numpy  # type: ignore[no-redef]

__all__ = ["numpy"]
