"""Read launch files: which nodes they start, and how."""

from sitegen.launch.descriptions import published_description
from sitegen.launch.evaluate import launched
from sitegen.launch.windows import Window
from sitegen.launch.xacro import description

__all__ = ["Window", "description", "launched", "published_description"]
