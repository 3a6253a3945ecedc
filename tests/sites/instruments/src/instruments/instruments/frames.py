"""Frames: a robot that turned by 90 degrees, its laser, and an island."""

import contextlib
import math

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import StaticTransformBroadcaster, TransformBroadcaster


def transform(parent, child, position, rotation):
    """Return a transform; the rotation is x, y, z, w."""
    stamped = TransformStamped()
    stamped.header.frame_id = parent
    stamped.child_frame_id = child
    translation, quaternion = stamped.transform.translation, stamped.transform.rotation
    translation.x, translation.y, translation.z = position
    quaternion.x, quaternion.y, quaternion.z, quaternion.w = rotation
    return stamped


class Frames(Node):
    """Publishes them."""

    def __init__(self):
        super().__init__("frames")
        # Roll 0.1, pitch 0.2, yaw 0.3.
        tilted = (0.03427080, 0.10602051, 0.14357218, 0.98334744)
        self._fixed = StaticTransformBroadcaster(self)
        self._fixed.sendTransform(
            [
                transform("base_link", "laser", (0.5, 0.0, 0.2), tilted),
                transform("island", "palm", (0.0, 0.0, 1.0), (0.0, 0.0, 0.0, 1.0)),
            ]
        )
        self._moving = TransformBroadcaster(self)
        self.create_timer(0.1, self.move)

    def move(self):
        """Say where the robot is."""
        half = math.sqrt(0.5)
        stamped = transform("odom", "base_link", (1.0, 2.0, 0.0), (0.0, 0.0, half, half))
        stamped.header.stamp = self.get_clock().now().to_msg()
        self._moving.sendTransform(stamped)


def main():
    """Publish until stopped."""
    rclpy.init()
    node = Frames()
    with contextlib.suppress(KeyboardInterrupt):
        rclpy.spin(node)
