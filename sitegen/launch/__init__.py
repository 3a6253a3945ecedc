"""Turn a launch file into the nodes that it starts."""

from sitegen.launch.evaluate import launched

__all__ = ["launched"]
