"""The programs of ROS that open windows, and the widgets that take their places on a page."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sitegen.errors import Location
from sitegen.launch.names import joined

# By package and executable, the kind of widget.
WIDGETS = {
    ("joint_state_publisher_gui", "joint_state_publisher_gui"): "joints",
    ("rqt_action", "rqt_action"): "actions",
    ("rqt_console", "rqt_console"): "log",
    ("rqt_graph", "rqt_graph"): "graph",
    ("rqt_image_view", "rqt_image_view"): "image",
    ("rqt_plot", "rqt_plot"): "plot",
    ("rqt_publisher", "rqt_publisher"): "publish",
    ("rqt_reconfigure", "rqt_reconfigure"): "parameters",
    ("rqt_robot_steering", "rqt_robot_steering"): "teleop",
    ("rqt_robot_monitor", "rqt_robot_monitor"): "diagnostics",
    ("rqt_runtime_monitor", "rqt_runtime_monitor"): "diagnostics",
    ("rqt_service_caller", "rqt_service_caller"): "services",
    ("rqt_tf_tree", "rqt_tf_tree"): "tf",
    ("rqt_topic", "rqt_topic"): "topics",
    ("rviz2", "rviz2"): "3d",
}


@dataclass(frozen=True)
class Window:
    """A window that a launch file opens: its program, and what that is given.

    `parameters` have their values as text, as in `-p name:=value`.
    """

    executable: str
    arguments: Sequence[str]
    remap: Mapping[str, str]
    parameters: Mapping[str, str]
    namespace: str
    location: Location

    @property
    def kind(self) -> str:
        """The kind of widget that takes its place."""
        return next(kind for (_, name), kind in WIDGETS.items() if name == self.executable)

    def resolved(self, name: str) -> str:
        """Return the full name of a topic in its namespace, by its remapping rules."""
        rules = {joined(self.namespace, old): new for old, new in self.remap.items()}
        full = joined(self.namespace, name)
        return joined(self.namespace, rules.get(full, full))


def known(package: str, executable: str) -> bool:
    """Return whether a widget takes the place of a program."""
    return (package, executable) in WIDGETS
