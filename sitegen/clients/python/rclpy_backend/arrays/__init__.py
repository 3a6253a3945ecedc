"""The arrays of message classes: numpy's where it is on the page, else ours for want of them."""

try:
    import numpy
except ImportError:
    from rclpy_backend.arrays import fixed_array as numpy

__all__ = ["numpy"]
