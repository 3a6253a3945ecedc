"""The part of numpy that pages have by themselves.

It has small arrays, functions of numbers, and matrices of transforms.
"""

from rclpy_backend.arrays.fixed_array import *  # noqa: F403
from rclpy_backend.arrays.fixed_array import int8 as int8
from rclpy_backend.arrays.fixed_array import int16 as int16
from rclpy_backend.arrays.fixed_array import int32 as int32
from rclpy_backend.arrays.fixed_array import int64 as int64
from rclpy_backend.arrays.fixed_array import uint8 as uint8
from rclpy_backend.arrays.fixed_array import uint16 as uint16
from rclpy_backend.arrays.fixed_array import uint32 as uint32
from rclpy_backend.arrays.fixed_array import uint64 as uint64

from .matrices import *  # noqa: F403
from .numbers import *  # noqa: F403
