"""Read launch files: which nodes they start, and how."""

from sitegen.launch.evaluate import launched

__all__ = ["launched"]
