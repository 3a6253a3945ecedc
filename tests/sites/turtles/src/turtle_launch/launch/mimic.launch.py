"""Two turtles; the second does what the first does."""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    """Describe the nodes."""
    two = [
        Node(package="turtlesim", executable="turtlesim_node", namespace=each, name="sim")
        for each in ("first", "second")
    ]
    mimic = Node(
        package="turtlesim",
        executable="mimic",
        remappings=[
            ("input/pose", "/first/turtle1/pose"),
            ("output/cmd_vel", "/second/turtle1/cmd_vel"),
        ],
    )
    keys = Node(package="turtlesim", executable="turtle_teleop_key", prefix="xterm -e")
    return LaunchDescription([*two, mimic, keys])
