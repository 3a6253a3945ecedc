"""A node that follows when another one has ended, which has nothing else to wait for."""

from launch import LaunchDescription
from launch.actions import LogInfo, Shutdown
from launch_ros.actions import Node


def generate_launch_description():
    last = Node(
        package="acting",
        executable="act",
        name="last",
        arguments=["0.3"],
        on_exit=[LogInfo(msg="over"), Shutdown(reason="all is done")],
    )
    return LaunchDescription(
        [
            Node(
                package="acting", executable="act", name="first", arguments=["0.3"], on_exit=[last]
            ),
        ]
    )
