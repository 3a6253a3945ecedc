"""Read launch files: which nodes they start, and how."""

from sitegen.launch.descriptions import published_description
from sitegen.launch.evaluate import LaunchDescription, launched
from sitegen.launch.shares import share_path
from sitegen.launch.windows import Window
from sitegen.launch.xacro import description

__all__ = [
    "LaunchDescription",
    "Window",
    "description",
    "launched",
    "published_description",
    "share_path",
]
