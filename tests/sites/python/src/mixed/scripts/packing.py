#!/usr/bin/env python3
"""A node whose messages carry what a compiled package of PyPI packs and unpacks."""

import msgpack
import rclpy
from rclpy.node import Node
from std_msgs.msg import ByteMultiArray


class Packing(Node):
    def __init__(self):
        super().__init__("packing")
        self.publisher = self.create_publisher(ByteMultiArray, "packed", 10)
        self.create_subscription(ByteMultiArray, "packed", self.unpack, 10)
        self.create_timer(0.05, self.pack)

    def pack(self):
        data = msgpack.packb({"speeds": [0.5, -1], "name": "left"})
        self.publisher.publish(ByteMultiArray(data=[bytes([byte]) for byte in data]))

    def unpack(self, message):
        print(msgpack.Packer.__module__, msgpack.unpackb(b"".join(message.data)))
        raise SystemExit


def main():
    rclpy.init()
    rclpy.spin(Packing())


if __name__ == "__main__":
    main()
