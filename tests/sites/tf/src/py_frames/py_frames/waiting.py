"""Waits for a transform that another node tells of, in a callback and in a coroutine."""

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.duration import Duration
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from rclpy.time import Time

# Messages can be had from these, too, as official programs have them.
from tf2_geometry_msgs import PointStamped, do_transform_point
from tf2_ros import TransformBroadcaster, TransformStamped
from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener


class Waiting(Node):
    def __init__(self):
        super().__init__("waiting_py")
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.broadcaster = TransformBroadcaster(self)
        # Of another group: that of `ask` is busy as long as it waits.
        self.create_timer(0.1, self.send, callback_group=ReentrantCallbackGroup())
        self.once = self.create_timer(0.05, self.ask)

    def send(self):
        message = TransformStamped()
        message.header.stamp = self.get_clock().now().to_msg()
        message.header.frame_id = "map"
        message.child_frame_id = "robot"
        message.transform.translation.x = 2.0
        self.broadcaster.sendTransform(message)

    async def ask(self):
        self.once.cancel()
        found = await self.buffer.lookup_transform_async("world", "robot", Time())
        point = PointStamped()
        point.point.x = 1.0
        moved = do_transform_point(point, found)
        self.get_logger().info(f"point in world: {moved.point.x:.3f} {moved.point.y:.3f}")
        waited = self.buffer.can_transform("world", "nowhere", Time(), Duration(seconds=0.05))
        self.get_logger().info(f"nowhere: {waited}")
        rclpy.shutdown()


def main():
    rclpy.init()
    executor = MultiThreadedExecutor()
    executor.add_node(Waiting())
    executor.spin()
