import xacro
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    path = get_package_share_directory("arm") + "/urdf/arm.urdf.xacro"
    description = xacro.process_file(path, mappings={"height": "4"}).toxml()
    return LaunchDescription(
        [
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[{"robot_description": description}],
            )
        ]
    )
