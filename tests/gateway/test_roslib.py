"""roslib of npm, in Node, and roslibpy of PyPI at a gateway with a native robot."""

from __future__ import annotations

import base64
import json
import subprocess
import sys
from pathlib import Path

from gateways import Gateway
from paths import ROOT, SUPPORT

PYTHON = """
import sys, time, threading
import roslibpy
ros = roslibpy.Ros("127.0.0.1", int(sys.argv[1]))
ros.run()
heard, news = [], threading.Event()
listener = roslibpy.Topic(ros, "/heard", "std_msgs/String")
listener.subscribe(lambda message: (heard.append(message["data"]), news.set()))
teller = roslibpy.Topic(ros, "/tell", "std_msgs/String")
while not heard:
    teller.publish(roslibpy.Message({"data": "from roslibpy"}))
    news.wait(0.2)
print(heard[0])
service = roslibpy.Service(ros, "/set", "std_srvs/SetBool")
print(service.call(roslibpy.ServiceRequest({"data": True}), timeout=10)["message"])
print("/robot" in ros.get_nodes(), ros.get_topic_type("/cmd_vel"))
ros.terminate()
"""


def test_roslib(opened: Gateway) -> None:
    command: list[str | Path] = ["node", SUPPORT / "gatewayroslib.mjs", opened.url]
    done = subprocess.run(command, cwd=ROOT, text=True, capture_output=True, timeout=100)
    seen = json.loads(done.stdout.splitlines()[-1])
    assert base64.b64decode(seen.pop("none")) == bytes(range(9))
    assert seen == {
        "heard": [f"n{number}" for number in range(10)],
        "publishers": ["/robot"],
        "cbor": ["Float32Array", 2.5],
        "png": "the map",
        "raw": 16,
        "called": {"success": True, "message": "from the robot"},
        "served": {"success": True, "message": "from roslib"},
        "failed": "service /none does not exist",
        "result": {"sequence": [0, 1, 1, 2, 3]},
        "feedback": 3,
        "canceled": seen["canceled"],
        "goal": {"success": True, "message": "[3, 1] after [[3]]"},
        "topics": True,
        "nodes": True,
        "services": True,
        "servers": ["/fibonacci"],
        "type": "geometry_msgs/msg/Twist",
        "serviceType": "std_srvs/srv/SetBool",
        "forType": True,
        "details": {
            "linear": {"x": "double", "y": "double", "z": "double"},
            "angular": {"x": "double", "y": "double", "z": "double"},
        },
        "request": ["data"],
        "node": True,
        "texts": True,
        "params": True,
        "speed": 2.5,
    }
    assert "cancel" in seen["canceled"].lower()


def test_roslibpy(opened: Gateway) -> None:
    command = [sys.executable, "-c", PYTHON, str(opened.port)]
    done = subprocess.run(command, text=True, capture_output=True, timeout=100)
    assert done.stdout.splitlines() == [
        "from roslibpy",
        "from the robot",
        "True geometry_msgs/msg/Twist",
    ], done.stderr
