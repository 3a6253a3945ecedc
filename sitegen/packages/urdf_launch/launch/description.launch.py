"""Publish the description `urdf_package_path` of the package `urdf_package`."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    """Return the node that publishes the description."""
    folder = FindPackageShare(LaunchConfiguration("urdf_package"))
    path = PathJoinSubstitution([folder, LaunchConfiguration("urdf_package_path")])
    description = ParameterValue(Command(["xacro ", path]), value_type=str)
    return LaunchDescription(
        [
            DeclareLaunchArgument("urdf_package"),
            DeclareLaunchArgument("urdf_package_path"),
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[{"robot_description": description}],
            ),
        ]
    )
