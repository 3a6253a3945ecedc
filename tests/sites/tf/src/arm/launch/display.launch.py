from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    model = PathJoinSubstitution([FindPackageShare("arm"), "urdf", "arm.urdf.xacro"])
    description = ParameterValue(
        Command(["xacro ", LaunchConfiguration("model"), " height:=4"]), value_type=str
    )
    return LaunchDescription(
        [
            DeclareLaunchArgument("model", default_value=model),
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[{"robot_description": description}],
            ),
            Node(package="joint_state_publisher", executable="joint_state_publisher"),
            Node(package="rviz2", executable="rviz2", output="screen"),
            Node(
                package="tf2_ros",
                executable="tf2_echo",
                name="echo",
                arguments=["world", "finger"],
            ),
        ]
    )
