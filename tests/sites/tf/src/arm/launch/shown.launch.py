from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    ld = LaunchDescription()
    ld.add_action(
        DeclareLaunchArgument(name="gui", default_value="true", choices=["true", "false"])
    )
    model = PathJoinSubstitution(["urdf", "arm.urdf.xacro"])
    ld.add_action(DeclareLaunchArgument(name="model", default_value=model))
    ld.add_action(
        IncludeLaunchDescription(
            PathJoinSubstitution([FindPackageShare("urdf_launch"), "launch", "display.launch.py"]),
            launch_arguments={
                "urdf_package": "arm",
                "urdf_package_path": LaunchConfiguration("model"),
                "jsp_gui": LaunchConfiguration("gui"),
            }.items(),
        )
    )
    return ld
