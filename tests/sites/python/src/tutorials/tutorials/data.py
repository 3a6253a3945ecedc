"""Files of the package: beside its modules, and in its share folder; small arrays."""

import sys
from importlib import resources
from pathlib import Path

import numpy as np
import rclpy
from ament_index_python.packages import PackageNotFoundError, get_package_share_directory


def arrays():
    """Use what pages have of numpy by themselves."""
    four = np.empty((4,))
    four[0], four[3] = 0.5, np.pi
    four[1:3] = np.zeros(2)
    print(len(four), four.dtype, float(four[0]), float(sum(four)), float(max(four)))
    print(np.array([1, 2]), np.array([1, 2]).dtype, np.array([1, 2.0]).dtype)
    for change in (lambda: four + "a", lambda: np.array([1, 2]) * None):
        try:
            change()
        except Exception as error:
            print("refused:", isinstance(error, TypeError))


def main():
    """Read them."""
    arrays()
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
