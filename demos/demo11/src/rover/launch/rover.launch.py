"""A rover in a room, with RViz, a joystick, a plot of its speed and its log."""

from launch import LaunchDescription
from launch.substitutions import Command, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    """Return what runs on a desktop, and on a page."""
    share = FindPackageShare("rover")
    description = Command(["cat ", PathJoinSubstitution([share, "urdf", "rover.urdf"])])
    view = PathJoinSubstitution([share, "rviz", "rover.rviz"])
    return LaunchDescription(
        [
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[{"robot_description": ParameterValue(description, value_type=str)}],
            ),
            Node(package="rover", executable="simulator", output="screen"),
            Node(package="rviz2", executable="rviz2", arguments=["-d", view]),
            Node(package="rqt_robot_steering", executable="rqt_robot_steering"),
            Node(
                package="rqt_plot", executable="rqt_plot", arguments=["/odom/twist/twist/linear/x"]
            ),
            Node(package="rqt_console", executable="rqt_console"),
        ]
    )
