"""Environment variables for all nodes, for one, and for a group."""

from launch import LaunchDescription
from launch.actions import GroupAction, SetEnvironmentVariable
from launch.substitutions import EnvironmentVariable, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    data = PathJoinSubstitution([FindPackageShare("bringup"), "data"])
    form = "<{name}> {severity} {message} {no}\\t{function_name}:{line_number}"
    return LaunchDescription(
        [
            SetEnvironmentVariable("TEAM", "blue"),
            SetEnvironmentVariable("DATA", data),
            SetEnvironmentVariable("RCUTILS_CONSOLE_OUTPUT_FORMAT", form),
            GroupAction([SetEnvironmentVariable("TEAM", "red")]),
            Node(package="teller", executable="tell", name="one", additional_env={"LANE": "ü 4"}),
            Node(
                package="teller_py",
                executable="tell",
                name="one_py",
                additional_env={"LANE": "ü 4"},
            ),
            Node(package="teller", executable="tell", name=["of_", EnvironmentVariable("TEAM")]),
            Node(package="teller_py", executable="tell", name="alone", env={"LANE": "5"}),
        ]
    )
