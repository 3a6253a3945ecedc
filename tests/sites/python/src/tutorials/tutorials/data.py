"""Files of the package: beside its modules, and in its share folder."""

import sys
from importlib import resources
from pathlib import Path

import rclpy
from ament_index_python.packages import PackageNotFoundError, get_package_share_directory


def main():
    """Read them."""
    print(resources.files("tutorials").joinpath("words.txt").read_text().split())
    share = Path(get_package_share_directory("tutorials"))
    print(sorted(path.name for path in share.iterdir()))
    try:
        get_package_share_directory("nowhere")
    except PackageNotFoundError as error:
        print(type(error).__name__)
    arguments = ["--ros-args", "--params-file", str(share / "config" / "robot.yaml")]
    rclpy.init(args=arguments)
    node = rclpy.create_node("robot", automatically_declare_parameters_from_overrides=True)
    for name in ("wheels", "arm.length", "arm.joints"):
        print(name, node.get_parameter(name).value)
    print(sys.argv[1:])
    return 3
