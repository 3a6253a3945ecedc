import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription
from launch.conditions import IfCondition, UnlessCondition
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch.substitutions import EnvironmentVariable, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node, PushRosNamespace, SetParameter
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    config = os.path.join(  # noqa: PTH118, as launch files have it
        get_package_share_directory("bringup"), "config", "speakers.yaml"
    )
    loud = DeclareLaunchArgument("loud", default_value="false")
    team = LaunchConfiguration("team")
    more = PathJoinSubstitution([FindPackageShare("bringup"), "launch", "more.launch.yaml"])
    fan = EnvironmentVariable("SITEGEN_NOBODY", default_value="fan")
    return LaunchDescription(
        [
            DeclareLaunchArgument("team"),
            loud,
            Node(
                package="speaker",
                executable="speak",
                name="first",
                arguments=["--mood", "very good"],
                parameters=[{"greeting": ["Hello ", team], "limits": {"top": 2.5}}],
                remappings=[("chatter", "/shared")],
                output="screen",
            ),
            GroupAction(
                [
                    PushRosNamespace(team),
                    SetParameter("number", 7),
                    Node(
                        package="speaker",
                        executable="speak",
                        name="second",
                        namespace="left",
                        parameters=[config],
                    ),
                    IncludeLaunchDescription(
                        AnyLaunchDescriptionSource(more),
                        launch_arguments={"who": [team, "_", fan]}.items(),
                    ),
                ]
            ),
            Node(
                package="speaker",
                executable="speak",
                name="third",
                condition=IfCondition(LaunchConfiguration("loud")),
            ),
            Node(
                package="speaker",
                executable="speak",
                condition=UnlessCondition(LaunchConfiguration("loud")),
            ),
        ]
    )
