"""Lets the turtle draw a star."""

import math
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_srvs.srv import Empty
from turtlesim.srv import SetPen, TeleportAbsolute, TeleportRelative

POINTS = 5
SIDE = 6.0  # metres; the window has eleven
COLOR = (255, 221, 51)  # red, green, blue
WIDTH = 4  # pixels


class Artist(Node):
    """Tells a turtle where to go, by its services."""

    def __init__(self):
        super().__init__("artist")
        self.clearing = self.create_client(Empty, "clear")
        self.pen = self.create_client(SetPen, "turtle1/set_pen")
        self.place = self.create_client(TeleportAbsolute, "turtle1/teleport_absolute")
        self.moves = self.create_client(TeleportRelative, "turtle1/teleport_relative")

    def call(self, client, request):
        """Call a service, and wait for its answer."""
        while not client.wait_for_service(timeout_sec=5.0):
            self.get_logger().warning(f"No {client.srv_name} yet. Is turtlesim running?")
        rclpy.spin_until_future_complete(self, client.call_async(request))

    def begin(self, x, y, angle):
        """Lift the pen, go to a place, and put it down on a clean window."""
        self.call(self.pen, SetPen.Request(off=1))
        self.call(self.place, TeleportAbsolute.Request(x=x, y=y, theta=angle))
        red, green, blue = COLOR
        self.call(self.pen, SetPen.Request(r=red, g=green, b=blue, width=WIDTH))
        self.call(self.clearing, Empty.Request())

    def turn(self, degrees):
        """Turn to the left."""
        self.call(self.moves, TeleportRelative.Request(angular=math.radians(degrees)))

    def forward(self, distance, steps=30):
        """Draw a line, in steps so small that one can watch it."""
        for _ in range(steps):
            self.call(self.moves, TeleportRelative.Request(linear=distance / steps))
            time.sleep(0.02)


def main():
    """Draw, and say so."""
    rclpy.init()
    artist = Artist()
    try:
        artist.begin(x=2.5, y=6.5, angle=0.0)
        for number in range(POINTS):
            artist.get_logger().info(f"Line {number + 1} of {POINTS}")
            artist.forward(SIDE)
            artist.turn(-720 / POINTS)
        artist.get_logger().info("There is a star")
    except (KeyboardInterrupt, ExternalShutdownException):
        print("Stopped")
