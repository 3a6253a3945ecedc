"""A managed node, which refuses its first activation."""

import contextlib

import rclpy
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn


class Managed(LifecycleNode):
    """Has a service for its loggers, too."""

    def __init__(self):
        super().__init__("managed", enable_logger_service=True)
        self._refused = False

    def on_configure(self, state):
        """Log at a level that is off."""
        self.get_logger().debug("configured in detail")
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state):
        """Fail the first time."""
        if not self._refused:
            self._refused = True
            return TransitionCallbackReturn.FAILURE
        return super().on_activate(state)


def main():
    """Be managed until stopped."""
    rclpy.init()
    node = Managed()
    with contextlib.suppress(KeyboardInterrupt):
        rclpy.spin(node)
