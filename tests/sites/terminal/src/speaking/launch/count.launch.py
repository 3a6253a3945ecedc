from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def talkers(context):
    count = int(LaunchConfiguration("count").perform(context))
    return [
        Node(
            package="speaking",
            executable="talker",
            name=f"talker_{number}",
            parameters=[{"greeting": f"{number} of {count}"}],
        )
        for number in range(1, count + 1)
    ]


def generate_launch_description():
    return LaunchDescription(
        [
            DeclareLaunchArgument("count", default_value="1"),
            OpaqueFunction(function=talkers),
            Node(
                package="speaking",
                executable=LaunchConfiguration("other", default="talker"),
                name="last",
            ),
        ]
    )
