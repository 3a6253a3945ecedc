"""What the turtlesim of sitegen offers to programs that were written for it."""

from __future__ import annotations

from pathlib import Path

from sitegen.commands.wiring.endpoint import (
    ACTION,
    PUBLISHER,
    SERVICE,
    SUBSCRIPTION,
    Endpoint,
    Program,
)
from sitegen.errors import Location

TURTLESIM = "turtlesim"
# Its package and its executable.
KEY = (TURTLESIM, "turtlesim_node")
# The topics and services of turtles have this prefix and a number.
TURTLE = "/turtle"
_OWN = {
    "/turtle1/pose": (PUBLISHER, "msg/Pose"),
    "/turtle1/color_sensor": (PUBLISHER, "msg/Color"),
    "/spawn": (SERVICE, "srv/Spawn"),
    "/kill": (SERVICE, "srv/Kill"),
    "/turtle1/set_pen": (SERVICE, "srv/SetPen"),
    "/turtle1/teleport_absolute": (SERVICE, "srv/TeleportAbsolute"),
    "/turtle1/teleport_relative": (SERVICE, "srv/TeleportRelative"),
    "/turtle1/rotate_absolute": (ACTION, "action/RotateAbsolute"),
}


def turtlesim() -> Program:
    """Return the endpoints of its first turtle, in both packages of interfaces.

    Its sources make their names while it runs.
    """
    nowhere = Location(Path(TURTLESIM), 1)
    found = [Endpoint(SUBSCRIPTION, "/turtle1/cmd_vel", "geometry_msgs/msg/Twist", nowhere)]
    for name, (kind, type) in _OWN.items():
        for package in (TURTLESIM, "turtlesim_msgs"):
            found.append(Endpoint(kind, name, f"{package}/{type}", nowhere))
    return Program(found, namespaces={""})
