"""Find the numbers in the messages of a topic, for plots."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

from sitegen.model import Package
from sitegen.shipped import ROS

# Of messages that consist of other messages, what is worth a curve.
_CHOSEN = {
    "geometry_msgs/msg/Twist": ("linear.x", "angular.z"),
    "geometry_msgs/msg/TwistStamped": ("twist.linear.x", "twist.angular.z"),
    "nav_msgs/msg/Odometry": ("twist.twist.linear.x", "twist.twist.angular.z"),
    "sensor_msgs/msg/BatteryState": ("percentage",),
    "sensor_msgs/msg/FluidPressure": ("fluid_pressure",),
    "sensor_msgs/msg/Illuminance": ("illuminance",),
    "sensor_msgs/msg/Imu": ("angular_velocity.z", "linear_acceleration.x"),
    "sensor_msgs/msg/JointState": ("position[:]{name}",),
    "sensor_msgs/msg/Range": ("range",),
    "sensor_msgs/msg/RelativeHumidity": ("relative_humidity",),
    "sensor_msgs/msg/Temperature": ("temperature",),
}
# All numbers of these packages, and of those of the workspace, are measurements.
_PLAIN = ("geometry_msgs", "std_msgs")
# A constant has a '=' behind its name, a field may have a default.
_FIELD = re.compile(r"^[ \t]*(float|u?int)(?:8|16|32|64)[ \t]+(\w+)\b(?![ \t]*=)", re.M)
# At most so many fields of a message.
FIELDS = 3


def numbers(type: str, packages: Mapping[str, Package]) -> list[str]:
    """Return the fields of a message that are worth a curve, as in message paths."""
    if type in _CHOSEN:
        return list(_CHOSEN[type])
    package, _, name = type.partition("/")
    if package in packages:
        file = packages[package].path / f"{name}.msg"
    elif package in _PLAIN:
        file = ROS / "share" / package / f"{name}.msg"
    else:
        return []
    found = _FIELD.findall(_text(file))
    floats = [field for kind, field in found if kind == "float"]
    return (floats or [field for _, field in found])[:FIELDS]


def _text(file: Path) -> str:
    try:
        return file.read_text(encoding="utf-8-sig", errors="replace")
    except OSError:
        return ""
