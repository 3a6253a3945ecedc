"""The commands of `ros2` in a terminal, with compiled nodes: what each prints, and its status.

The texts are those of the Python sources of ros2cli; `tests/runtime/native.txt` says where each of
them is. `ros2cli` is in no registry to run it here.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from browser import Built, Serve
from paths import SITES
from playwright.sync_api import Page as Tab
from terminal import Terminal

pytestmark = pytest.mark.firefox

# What is different each time.
STAMP = r"header:\n  stamp:\n    sec: \d+\n    nanosec: \d+\n  frame_id: map\n"
POINT = rf"{STAMP}point:\n  x: 1.5\n  y: 0.0\n  z: 0.0\n---"
PARAMETERS = [
    *("describe_parameters", "get_parameter_types", "get_parameters", "list_parameters"),
    *("set_parameters", "set_parameters_atomically"),
]
INFO = """/talker
  Subscribers:
    /said: std_msgs/msg/String
  Publishers:
    /chatter: std_msgs/msg/String
    /parameter_events: rcl_interfaces/msg/ParameterEvent
    /points: geometry_msgs/msg/PointStamped
    /rosout: rcl_interfaces/msg/Log
  Service Servers:
    /mute: std_srvs/srv/SetBool
    /talker/describe_parameters: rcl_interfaces/srv/DescribeParameters
    /talker/get_parameter_types: rcl_interfaces/srv/GetParameterTypes
    /talker/get_parameters: rcl_interfaces/srv/GetParameters
    /talker/list_parameters: rcl_interfaces/srv/ListParameters
    /talker/set_parameters: rcl_interfaces/srv/SetParameters
    /talker/set_parameters_atomically: rcl_interfaces/srv/SetParametersAtomically
  Service Clients:

  Action Servers:

  Action Clients:
"""
# The bytes of the GID are the page's own.
VERBOSE = r"""Type: std_msgs/msg/String

Publisher count: 1

Node name: talker
Node namespace: /
Topic type: std_msgs/msg/String
Topic type hash: RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18
Endpoint type: PUBLISHER
GID: ([0-9a-f]{2}\.){15}[0-9a-f]{2}
QoS profile:
  Reliability: RELIABLE
  History \(Depth\): KEEP_LAST \(10\)
  Durability: VOLATILE
  Lifespan: Infinite
  Deadline: Infinite
  Liveliness: AUTOMATIC
  Liveliness lease duration: Infinite

Subscription count: 0
"""

# Lines, and what they print; a pattern where it is no plain text.
PRINTED: dict[str, list[tuple[str, str | re.Pattern[str]]]] = {
    "node": [
        ("ros2 node list", "/talker"),
        ("ros2 node list -c", "1"),
        ("ros2 node info /talker", INFO.rstrip("\n")),
        ("ros2 node info /nobody; echo $?", "Unable to find node '/nobody'\n1"),
    ],
    "topic": [
        ("ros2 topic list", "/chatter\n/parameter_events\n/points\n/rosout\n/said"),
        (
            "ros2 topic list -t | grep s/msg/S",
            "/chatter [std_msgs/msg/String]\n/said [std_msgs/msg/String]",
        ),
        ("ros2 topic list -c", "5"),
        (
            "ros2 topic list -v | tail -3",
            "Subscribed topics:\n * /said [std_msgs/msg/String] 1 subscriber",
        ),
        ("ros2 topic type /points", "geometry_msgs/msg/PointStamped"),
        ("ros2 topic type /nothing; echo $?", "1"),
        ("ros2 topic find std_msgs/msg/String", "/chatter\n/said"),
        (
            "ros2 topic info /chatter",
            "Type: std_msgs/msg/String\nPublisher count: 1\nSubscription count: 0",
        ),
        ("ros2 topic info /chatter -v", re.compile(VERBOSE.rstrip("\n"))),
        ("ros2 topic info /nothing; echo $?", "Unknown topic '/nothing'\n1"),
    ],
    "echo": [
        ("ros2 topic echo /points --once", re.compile(POINT)),
        # A relative name is one of the root namespace.
        ("ros2 topic echo --once chatter", re.compile(r"data: hello \d+\n---")),
        ("ros2 topic echo --once /chatter --field data", re.compile(r"hello \d+\n---")),
        ("ros2 topic echo --once /points --field point", "x: 1.5\ny: 0.0\nz: 0.0\n---"),
        ("ros2 topic echo --once /points --field point.x", "1.5\n---"),
        ("ros2 topic echo --once /points --csv", re.compile(r"\d+,\d+,map,1\.5,0\.0,0\.0")),
        ("ros2 topic echo --once /chatter -l 3", "data: hel...\n---"),
        (
            "ros2 topic echo --once /chatter --no-str",
            re.compile(r"data: '<string length: <\d+>>'\n---"),
        ),
        (
            "ros2 topic echo --once /points --flow-style | tail -2",
            re.compile(r"\{header: \{stamp: \{.*point: \{x: 1\.5, y: 0\.0, z: 0\.0\}\}\n---"),
        ),
        (
            "ros2 topic echo --once /chatter --raw",
            re.compile(r"b'\\x00\\x01\\x00\\x00\\\w+\\x00\\x00\\x00hello \d+\\x00.*'\n---"),
        ),
        ("ros2 topic echo --timeout 0.3 /chatter > a; grep -c data a", re.compile("[1-9]")),
        (
            "ros2 topic echo /nothing; echo $?",
            "WARNING: topic [/nothing] does not appear to be published yet\n"
            "Could not determine the type for the passed topic\n1",
        ),
        (
            "ros2 topic echo /chatter nonsense/msg/None; echo $?",
            "The passed message type is invalid\n1",
        ),
        (
            "ros2 topic echo /chatter --field datum; echo $?",
            "Invalid field 'datum': 'String' object has no attribute 'datum'\n1",
        ),
    ],
    "service": [
        ("ros2 service list | head -1", "/mute"),
        ("ros2 service list -t | head -n1", "/mute [std_srvs/srv/SetBool]"),
        ("ros2 service list -c", str(1 + len(PARAMETERS))),
        ("ros2 service type /mute", "std_srvs/srv/SetBool"),
        ("ros2 service find std_srvs/srv/SetBool", "/mute"),
        (
            "ros2 service info /mute",
            "Type: std_srvs/srv/SetBool\nClients count: 0\nServices count: 1",
        ),
        (
            "ros2 service call /mute std_srvs/srv/SetBool '{data: true}'",
            "requester: making request: std_srvs.srv.SetBool_Request(data=True)\n\n"
            "response:\nstd_srvs.srv.SetBool_Response(success=True, message='muted')",
        ),
        (
            "ros2 service call /mute std_srvs/srv/SetBool | tail -2",
            'std_srvs.srv.SetBool_Response(success=False, message="it\'s on")',
        ),
        (
            "ros2 service call /mute std_srvs/srv/None; echo $?",
            "The passed service type is invalid\n1",
        ),
        (
            "ros2 service call /mute std_srvs/srv/SetBool true; echo $?",
            "Failed to populate field: Value 'True' is expected to be a dictionary but is "
            "a bool\n1",
        ),
    ],
    "param": [
        ("ros2 param list /talker", "  greeting\n  speed\n  use_sim_time\n  volume"),
        ("ros2 param list --filter gree", "/talker:\n  greeting"),
        # As Python's match(), from the first letter.
        ("ros2 param list --filter reet", ""),
        (
            "ros2 param list /talker --param-type | head -2",
            "  greeting (type: string)\n  speed (type: double)",
        ),
        ("ros2 param get /talker volume", "Integer value is: 5"),
        ("ros2 param get /talker greeting", "String value is: hello"),
        ("ros2 param get /talker speed --hide-type", "1.0"),
        ("ros2 param get /talker use_sim_time", "Boolean value is: False"),
        ("ros2 param get /talker nothing; echo $?", "Parameter not set\n1"),
        ("ros2 param get /nobody volume; echo $?", "Node not found\n1"),
        ("ros2 param set /talker volume 7", "Set parameter successful"),
        ("ros2 param get /talker volume", "Integer value is: 7"),
        (
            "ros2 param set /talker volume 12",
            "Setting parameter failed: Parameter {volume} doesn't comply with integer range.",
        ),
        (
            "ros2 param describe /talker volume",
            "Parameter name: volume\n  Type: integer\n  Description: How loud it is\n"
            "  Constraints:\n    Min value: 0\n    Max value: 11",
        ),
        (
            "ros2 param dump /talker",
            "/talker:\n  ros__parameters:\n    greeting: hello\n    speed: 1.0\n"
            "    use_sim_time: false\n    volume: 7",
        ),
        (
            "ros2 param dump /talker | grep -v use_sim > p.yaml; ros2 param load /talker p.yaml",
            "Set parameter greeting successful\nSet parameter speed successful\n"
            "Set parameter volume successful",
        ),
        ("ros2 param load /talker q.yaml; echo $?", "q.yaml: No such file or directory\n1"),
    ],
    "interface": [
        (
            "ros2 interface show geometry_msgs/msg/PointStamped",
            "# This represents a Point with reference coordinate frame and timestamp\n\n"
            "std_msgs/Header header\n\tbuiltin_interfaces/Time stamp\n\t\tint32 sec\n"
            "\t\tuint32 nanosec\n\tstring frame_id\nPoint point\n\tfloat64 x\n\tfloat64 y\n"
            "\tfloat64 z".expandtabs(8),
        ),
        (
            "ros2 interface show std_srvs/srv/SetBool --no-comments",
            "bool data\n---\nbool success\nstring message",
        ),
        ("ros2 topic type /chatter | ros2 interface show --no-comments -", "string data"),
        # Also of a type that no node of the page has.
        (
            "ros2 interface show geometry_msgs/msg/Twist",
            "# This expresses velocity in free space broken into its linear and angular parts."
            "\n\nVector3  linear\n\tfloat64 x\n\tfloat64 y\n\tfloat64 z\n"
            "Vector3  angular\n\tfloat64 x\n\tfloat64 y\n\tfloat64 z".expandtabs(8),
        ),
        (
            "ros2 interface package std_srvs",
            "std_srvs/srv/Empty\nstd_srvs/srv/SetBool\nstd_srvs/srv/Trigger",
        ),
        ("ros2 interface packages -s | grep std", "std_srvs"),
        ("ros2 interface list -s | grep std.*SetB", "    std_srvs/srv/SetBool"),
        ("ros2 interface proto geometry_msgs/msg/Point", '"x: 0.0\ny: 0.0\nz: 0.0\n"'),
        ("ros2 interface package none; echo $?", "Unknown package 'none'\n1"),
    ],
    "others": [
        ("ros2 pkg list", "speaking"),
        (
            "ros2 pkg executables speaking",
            "speaking flood\nspeaking talker\nspeaking typist",
        ),
        ("ros2 run nothing here; echo $?", re.compile(".*\nPackage 'nothing' not found\n1")),
        ("ros2 run speaking here; echo $?", re.compile(".*\nNo executable found\n1")),
        (
            "ros2 doctor",
            "UserWarning: Publisher without subscriber detected on /chatter.\n"
            "UserWarning: Publisher without subscriber detected on /points.\n"
            "UserWarning: Subscriber without publisher detected on /said.\n\n"
            "All 4 checks passed",
        ),
        ("ros2 wtf -iw 2>&1 | tail -3", "1/4 check(s) failed\n\nFailed modules: topic"),
        ("ros2 daemon stop", "The daemon has been stopped"),
        ("ros2 daemon status", "The daemon is not running"),
        ("ros2 topic | grep Output | wc -l", "3"),
        (
            "ros2 nodes | wc -l; ros2 frob 2>&1 | tail -1",
            re.compile(r"(?s).*\n0\n.*'wtf'\)"),
        ),
        (
            "ros2 topic list --nope 2>&1 | tail -n 1; ros2 topic list --nope > a 2>&1; echo $?",
            "ros2: error: unrecognized arguments: --nope\n2",
        ),
    ],
}


@pytest.fixture
def terminal(tab: Tab, serve: Serve, built: Built) -> Iterator[Terminal]:
    tab.goto(serve(built(SITES / "terminal")))
    terminal = Terminal(tab, 120)
    terminal.await_names("/talker", "/mute", "/chatter", "/points", "/said")
    yield terminal


@pytest.mark.parametrize("group", PRINTED)
def test_commands_print_what_ros2_prints(terminal: Terminal, group: str) -> None:
    for line, expected in PRINTED[group]:
        found = terminal.run(line)
        if isinstance(expected, str):
            assert found == expected, line
        else:
            assert expected.fullmatch(found), f"{line}: {found}"


def test_rates_and_sizes_are_measured(terminal: Terminal) -> None:
    for line, pattern in [
        (
            "ros2 topic hz /chatter",
            r"average rate: (9|10)\.\d{3}\n\s+min: 0\.\d{3}s max: 0\.\d{3}s "
            r"std dev: 0\.\d{5}s window: \d+",
        ),
        (
            "ros2 topic bw /chatter",
            r"Subscribed to \[/chatter\]\n\d{2,3} B/s from \d+ messages\n"
            r"\s+Message size mean: \d{2} B min: \d{2} B max: \d{2} B",
        ),
        (
            "ros2 topic delay /points",
            # The clocks of a program and of the page differ by less than a millisecond.
            r"average delay: (-0\.000|0\.\d{3})\n\s+min: -?0\.\d{3}s max: 0\.\d{3}s "
            r"std dev: 0\.\d{5}s window: \d+",
        ),
    ]:
        terminal.begin(line)
        terminal.wait_for("window: " if "bw" not in line else "max: ")
        terminal.interrupt()
        assert re.match(pattern, terminal.output(line)), terminal.text()
        # As ros2cli: the number of the signal, which hz catches.
        assert terminal.status() == (0 if " hz " in line else 2)
    assert terminal.run("ros2 topic delay /chatter; echo $?") == "msg does not have header\n1"


def test_messages_are_published(terminal: Terminal) -> None:
    found = terminal.run("ros2 topic pub -1 /said std_msgs/msg/String '{data: hi there}'")
    assert found == (
        "publisher: beginning loop\npublishing #1: std_msgs.msg.String(data='hi there')"
    )
    line = "ros2 topic echo /rosout --timeout 1 --field msg | grep -A1 heard"
    assert terminal.run(line) == "heard 'hi there'\n---"
    line = "ros2 topic pub -r 50 -t 3 --print 2 /new geometry_msgs/msg/Point '{x: 1, z: -2.5}'"
    terminal.begin(f"{line} &")
    terminal.wait_for("Waiting for at least 1 matching subscription(s)...")
    found = terminal.run("ros2 topic echo /new --once")
    assert "x: 1.0\ny: 0.0\nz: -2.5\n---" in found
    terminal.wait_for("publishing #2: geometry_msgs.msg.Point(x=1.0, y=0.0, z=-2.5)")
    terminal.run("wait")
    for values, error in [
        ("'{datum: x}'", "Failed to populate field: 'String' object has no attribute 'datum'"),
        ("hello", "The passed value needs to be a dictionary in YAML format"),
    ]:
        line = f"ros2 topic pub --once /said std_msgs/msg/String {values}; echo $?"
        assert terminal.run(line) == f"{error}\n1"
    line = "ros2 topic pub /said nothing/msg/None; echo $?"
    assert terminal.run(line) == "The passed message type is invalid\n1"
