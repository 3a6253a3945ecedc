"""The beginner tutorials of ROS 2 about command-line tools, line by line, with turtlesim.

These are the pages from "Using turtlesim, ros2, and rqt" to "Recording and playing back data" of
docs.ros.org, with the interfaces of turtlesim_msgs, as since Kilted. rqt has no place in a page.
"""

from __future__ import annotations

import re

import pytest
from browser import Built, Serve
from paths import SITES
from playwright.sync_api import Page as Tab
from terminal import Terminal

STAMPED = r"\[INFO\] \[\d+\.\d+\] "
TWIST = "geometry_msgs/msg/Twist"
FORWARD = (
    '"{linear: {x: 2.0, y: 0.0, z: 0.0}, angular: {x: 0.0, y: 0.0, z: 1.8}}"'  # as in the tutorial
)
SENT = (
    "geometry_msgs.msg.Twist(linear=geometry_msgs.msg.Vector3(x=2.0, y=0.0, z=0.0), "
    "angular=geometry_msgs.msg.Vector3(x=0.0, y=0.0, z=1.8))"
)
# Lines, and a pattern of what they print; the window of the page is a topic of its own.
NODES = [
    ("ros2 pkg executables turtlesim", "turtlesim turtlesim_node"),
    ("ros2 node list", "/my_turtle"),
    (
        "ros2 node info /my_turtle",
        r"/my_turtle\n  Subscribers:\n(?s:.*)    /turtle1/cmd_vel: geometry_msgs/msg/Twist\n"
        r"  Publishers:\n(?s:.*)    /turtle1/pose: turtlesim\w*/msg/Pose\n(?s:.*)"
        r"  Service Servers:\n"
        r"    /clear: std_srvs/srv/Empty\n(?s:.*)  Action Servers:\n"
        r"    /turtle1/rotate_absolute: turtlesim\w*/action/RotateAbsolute\n  Action Clients:",
    ),
]
TOPICS = [
    (
        "ros2 topic list -t",
        r"(?s:.*)/parameter_events \[rcl_interfaces/msg/ParameterEvent\]\n"
        r"/rosout \[rcl_interfaces/msg/Log\]\n(?s:.*)"
        r"/turtle1/cmd_vel \[geometry_msgs/msg/Twist\]\n"
        r"/turtle1/color_sensor \[turtlesim\w*/msg/Color\]\n"
        r"/turtle1/pose \[turtlesim\w*/msg/Pose\]",
    ),
    (
        "ros2 topic info /turtle1/cmd_vel",
        "Type: geometry_msgs/msg/Twist\nPublisher count: 0\nSubscription count: 1",
    ),
    (
        f"ros2 interface show {TWIST}",
        "# This expresses velocity in free space broken into its linear and angular parts.\n\n"
        r"Vector3  linear\n +float64 x\n +float64 y\n +float64 z\n"
        r"Vector3  angular\n +float64 x\n +float64 y\n +float64 z",
    ),
    (
        f"ros2 topic pub --once -w 1 /turtle1/cmd_vel {TWIST} {FORWARD}",
        f"publisher: beginning loop\npublishing #1: {re.escape(SENT)}",
    ),
    (
        "ros2 topic echo /turtle1/pose --once",
        r"x: \d.*\ny: \d.*\ntheta: .*\nlinear_velocity: .*\nangular_velocity: .*\n---",
    ),
    (
        "ros2 topic pub -1 -w 0 /pose geometry_msgs/msg/PoseStamped "
        "'{header: \"auto\", pose: {position: {x: 1.0, y: 2.0, z: 3.0}}}'",
        r"publisher: beginning loop\npublishing #1: geometry_msgs\.msg\.PoseStamped\("
        r"header=std_msgs\.msg\.Header\(stamp=builtin_interfaces\.msg\.Time\(sec=\d{10}, (?s:.*)",
    ),
    (
        "ros2 topic pub -1 -w 0 /reference sensor_msgs/msg/TimeReference "
        '\'{header: "auto", time_ref: "now", source: "dumy"}\'',
        r"(?s:.*)time_ref=builtin_interfaces\.msg\.Time\(sec=\d{10}, nanosec=\d+\),\s*"
        r"source='dumy'\)",
    ),
    (f"ros2 topic find {TWIST}", "/turtle1/cmd_vel"),
]
SERVICES = [
    ("ros2 service type /clear", "std_srvs/srv/Empty"),
    (
        "ros2 service list -t",
        r"/clear \[std_srvs/srv/Empty\]\n/kill \[turtlesim\w*/srv/Kill\]\n(?s:.*)"
        r"/turtle1/teleport_relative \[turtlesim\w*/srv/TeleportRelative\](?s:.*)",
    ),
    ("ros2 service find std_srvs/srv/Empty", "/clear\n/reset"),
    ("ros2 interface show std_srvs/srv/Empty", "---"),
    (
        "ros2 interface show --no-comments turtlesim_msgs/srv/Spawn",
        r"float32 x\nfloat32 y\nfloat32 theta\nstring name\n---\nstring name",
    ),
    (
        "ros2 service call /clear std_srvs/srv/Empty",
        r"requester: making request: std_srvs\.srv\.Empty_Request\(\)\n\n"
        r"response:\nstd_srvs\.srv\.Empty_Response\(\)",
    ),
    (
        "ros2 service call /spawn turtlesim_msgs/srv/Spawn \"{x: 2, y: 2, theta: 0.2, name: ''}\"",
        r"requester: making request: turtlesim_msgs\.srv\.Spawn_Request\(x=2\.0, y=2\.0, "
        r"theta=0\.2, name=''\)\n\n"
        r"response:\nturtlesim_msgs\.srv\.Spawn_Response\(name='turtle2'\)",
    ),
]
PARAMETERS = [
    (
        "ros2 param list",
        "/my_turtle:\n  background_b\n  background_g\n  background_r\n(?s:.*)  use_sim_time",
    ),
    ("ros2 param get /my_turtle background_g", "Integer value is: 86"),
    ("ros2 param set /my_turtle background_r 150", "Set parameter successful"),
    ("ros2 param dump /my_turtle > my_turtle.yaml; grep background_r my_turtle.yaml", " +.*: 150"),
    ("ros2 param load /my_turtle my_turtle.yaml", "Set parameter background_b successful(?s:.*)"),
]
ACTIONS = [
    (
        "ros2 action list -t",
        r"/turtle1/rotate_absolute \[turtlesim_msgs/action/RotateAbsolute\](?s:.*)",
    ),
    (
        "ros2 action info /turtle1/rotate_absolute",
        "Action: /turtle1/rotate_absolute\nAction clients: 0\nAction servers: 1\n    /my_turtle",
    ),
    (
        "ros2 interface show --no-comments turtlesim_msgs/action/RotateAbsolute",
        "float32 theta\n---\nfloat32 delta\n---\nfloat32 remaining",
    ),
    (
        "ros2 action send_goal /turtle1/rotate_absolute turtlesim_msgs/action/RotateAbsolute "
        '"{theta: 1.57}"',
        r"Waiting for an action server to become available\.\.\.\n"
        r"Sending goal:\n     theta: 1\.57\n\nGoal accepted with ID: [0-9a-f]{32}\n\n"
        r"Result:\n    delta: -?\d.*\n\n"
        r"Goal finished with status: SUCCEEDED",
    ),
]
BAGS = [
    (
        "ros2 bag info subset",
        r"Files:             subset\.mcap\nBag size: (?s:.*)Topic: /turtle1/pose \| Type: "
        r"turtlesim\w*/msg/Pose \| Count: \d+ \| Serialization Format: cdr\n(?s:.*)",
    ),
]
LINES = {
    "nodes": NODES,
    "topics": TOPICS,
    "services": SERVICES,
    "parameters": PARAMETERS,
    "actions": ACTIONS,
}


@pytest.fixture
def terminal(tab: Tab, serve: Serve, built: Built) -> Terminal:
    tab.goto(f"{serve(built(SITES / 'turtles'))}tutorial/")
    terminal = Terminal(tab, 260)
    terminal.run(
        "ros2 run turtlesim turtlesim_node --ros-args --remap __node:=my_turtle > log 2>&1 &"
    )
    terminal.await_names("/my_turtle", "/turtle1/pose", "/turtle1/rotate_absolute/_action/status")
    return terminal


@pytest.mark.parametrize("page", LINES)
def test_a_tutorial_works_line_by_line(terminal: Terminal, page: str) -> None:
    for line, expected in LINES[page]:
        found = terminal.run(line)
        assert re.fullmatch(expected, found), f"{line}\n{found}"


def test_rates_are_measured_as_in_the_tutorial(terminal: Terminal) -> None:
    terminal.begin("ros2 topic hz /turtle1/pose")
    terminal.wait_for("average rate: 6")
    terminal.interrupt()
    terminal.begin("ros2 topic bw /turtle1/pose")
    terminal.wait_for("Subscribed to [/turtle1/pose]")
    terminal.wait_for("KB/s from ")
    terminal.interrupt()


def test_data_are_recorded_and_played_back(terminal: Terminal) -> None:
    terminal.begin("ros2 bag record -o subset /turtle1/cmd_vel /turtle1/pose")
    terminal.wait_for("Subscribed to topic '/turtle1/pose'")
    terminal.interrupt()
    for line, expected in BAGS:
        found = terminal.run(line)
        assert re.fullmatch(expected, found.strip("\n")), f"{line}\n{found}"
    assert "Set rate to 1" in terminal.run("ros2 bag play subset")
