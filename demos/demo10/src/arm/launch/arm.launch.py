"""The arm, sliders for its joints, and RViz."""

from launch import LaunchDescription
from launch.substitutions import Command, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    """Return what runs on a desktop, and on a page."""
    share = FindPackageShare("arm")
    description = Command(["xacro ", PathJoinSubstitution([share, "urdf", "arm.urdf.xacro"])])
    view = PathJoinSubstitution([share, "rviz", "arm.rviz"])
    return LaunchDescription(
        [
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[{"robot_description": ParameterValue(description, value_type=str)}],
            ),
            Node(
                package="joint_state_publisher_gui",
                executable="joint_state_publisher_gui",
                parameters=[{"zeros.shoulder_lift": -0.3, "zeros.elbow": 1.1, "zeros.wrist": 0.6}],
            ),
            Node(package="arm", executable="trace"),
            Node(package="rviz2", executable="rviz2", arguments=["-d", view]),
        ]
    )
