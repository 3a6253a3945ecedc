"""The shell of terminals with a graph of its own, run in Node: see shell.mjs."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Sequence

from paths import SUPPORT

from sitegen.interfaces import messages
from sitegen.shipped import ROS

LIFECYCLE = ("GetState", "GetAvailableTransitions", "ChangeState")
FIBONACCI = [
    *("Goal", "Result", "Feedback", "SendGoal_Request", "SendGoal_Response"),
    *("GetResult_Request", "GetResult_Response", "FeedbackMessage"),
]
TYPES = [
    *("std_msgs/msg/String", "geometry_msgs/msg/PointStamped", "geometry_msgs/msg/Twist"),
    *(f"std_srvs/srv/{one}" for one in ("SetBool_Request", "SetBool_Response", "SetBool_Event")),
    *(f"lifecycle_msgs/srv/{one}_{end}" for one in LIFECYCLE for end in ("Request", "Response")),
    *(f"test_msgs/action/Fibonacci_{part}" for part in FIBONACCI),
]
TEXTS = ("geometry_msgs/msg/Twist", "geometry_msgs/msg/Vector3", "std_srvs/srv/SetBool")


def shell(lines: Sequence[str | tuple[str, float]], *, wait: float = 10) -> list[tuple[str, int]]:
    """Run lines, and return what each shows and its status.

    Ctrl-C interrupts a line after `wait` seconds, or after those beside it.
    """
    types = messages.types(TYPES, [])
    hashes = {
        name.removesuffix("_Request"): one["hash"] for name, one in types.items() if "hash" in one
    }
    files = {
        name: ROS / f"share/{name.rsplit('/', 1)[0]}/{name.split('/')[2]}.{name.split('/')[1]}"
        for name in TEXTS
    }
    given = {
        "types": types,
        "hashes": hashes,
        "texts": {name: file.read_text() for name, file in files.items()},
        "lines": [
            (one, wait * 1000) if isinstance(one, str) else (one[0], one[1] * 1000) for one in lines
        ],
    }
    command = ["node", str(SUPPORT / "shell.mjs")]
    done = subprocess.run(command, input=json.dumps(given), text=True, capture_output=True)
    assert done.returncode == 0, done.stderr
    assert not done.stderr, done.stderr
    return [(shown, status) for shown, status in json.loads(done.stdout)]
