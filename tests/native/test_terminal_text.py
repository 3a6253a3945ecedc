"""Messages as `ros2 topic pub` and `ros2 service call` print them, against native rclpy."""

from __future__ import annotations

import ast
import json
import re
import subprocess

from native import Native
from paths import ROOT

from sitegen.interfaces import messages

BYTE = re.compile(r"""\bb(?:'(?:[^'\\]|\\x[0-9a-f]{2}|\\[\\nrt'])'|"'")""")
SEED = "20241124"
# Fixed arrays of numbers are NumPy's, which prints eight digits over several lines; see the docs.
TYPES = [
    *("std_msgs/msg/String", "geometry_msgs/msg/Twist", "geometry_msgs/msg/PoseArray"),
    *("sensor_msgs/msg/JointState", "sensor_msgs/msg/BatteryState", "std_msgs/msg/ColorRGBA"),
    *("test_msgs/msg/BasicTypes", "test_msgs/msg/Strings", "test_msgs/msg/WStrings"),
    *("test_msgs/msg/UnboundedSequences", "test_msgs/msg/BoundedSequences", "test_msgs/msg/Empty"),
    "std_srvs/srv/SetBool_Request",
]


def test_messages_are_printed_as_by_python() -> None:
    native = Native()
    made = native.run("messages.py", "make", SEED, *TYPES)
    expected = native.run("messages.py", "show", stdin="".join(f"{line}\n" for line in made))
    given = {
        "types": messages.types(TYPES, []),
        "messages": [line.split() for line in made],
    }
    done = subprocess.run(
        ["node", str(ROOT / "tests/support/reprs.mjs")],
        input=json.dumps(given),
        text=True,
        capture_output=True,
        check=True,
    )
    found = json.loads(done.stdout)
    assert len(found) == len(expected) == 12 * len(TYPES)
    for line, ours, theirs in zip(made, found, expected, strict=True):
        # Pages know a byte as a number.
        meant = re.sub(BYTE, as_number, json.loads(theirs))
        assert ours == meant, line.split()[0]


def as_number(match: re.Match[str]) -> str:
    """Return a byte that Python prints as a number."""
    [byte] = ast.literal_eval(match[0])
    return str(byte)
