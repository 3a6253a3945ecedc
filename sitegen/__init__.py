"""Package a ROS 2 workspace into a static web page that runs it."""

__version__ = "0.1.0"
