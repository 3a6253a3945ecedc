"""Publish a robot description and the positions of its joints."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    """Return the nodes of the simulated robot."""
    gui = LaunchConfiguration("jsp_gui")
    here = FindPackageShare("urdf_launch")
    names = ("urdf_package", "urdf_package_path")
    return LaunchDescription(
        [
            DeclareLaunchArgument("jsp_gui", default_value="true"),
            DeclareLaunchArgument("rviz_config", default_value=""),
            IncludeLaunchDescription(
                PathJoinSubstitution([here, "launch", "description.launch.py"]),
                launch_arguments=[(name, LaunchConfiguration(name)) for name in names],
            ),
            Node(
                package="joint_state_publisher",
                executable="joint_state_publisher",
                condition=UnlessCondition(gui),
            ),
            Node(
                package="joint_state_publisher_gui",
                executable="joint_state_publisher_gui",
                condition=IfCondition(gui),
            ),
            Node(
                package="rviz2",
                executable="rviz2",
                arguments=["-d", LaunchConfiguration("rviz_config")],
            ),
        ]
    )
