"""Read launch files: which nodes they start, and how."""

from sitegen.launch.evaluate import launched
from sitegen.launch.windows import Window
from sitegen.launch.xacro import description

__all__ = ["Window", "description", "launched"]
