"""A program without ROS 2, made with zenoh-ros2-sdk, that uses the robot of robot.py.

It takes the port of Zenoh and the domain, and prints what it got as JSON.
"""

from __future__ import annotations

import json
import os
import sys
import time
from typing import Any

from zenoh_ros2_sdk import ROS2Publisher, ROS2ServiceClient, ROS2ServiceServer, ROS2Subscriber

STRING = ("std_msgs/msg/String", "string data")
SET_BOOL = "std_srvs/srv/SetBool"
PARTS = {"request_definition": "bool data", "response_definition": "bool success\nstring message"}


def main(port: str, domain: str) -> None:
    where: dict[str, Any] = {"router_port": int(port), "domain_id": int(domain)}
    heard: list[str] = []

    def hear(message: Any) -> None:
        heard.append(message.data)

    kind, definition = STRING
    ROS2Subscriber("/heard", kind, hear, msg_definition=definition, **where)
    tell = ROS2Publisher("/tell", kind, msg_definition=definition, node_name="sdk", **where)

    def answer(request: Any) -> Any:
        return server.response_msg_class(success=request.data, message="from the sdk")

    server = ROS2ServiceServer("/of_sdk", SET_BOOL, answer, **PARTS, **where)
    end = time.monotonic() + 30
    while not heard and time.monotonic() < end:
        tell.publish(data="settled")
        time.sleep(0.1)
    for number in range(90):
        tell.publish(data=str(number))
    while heard[-1:] != ["89"] and time.monotonic() < end:
        time.sleep(0.01)
    client = ROS2ServiceClient("/set", SET_BOOL, **PARTS, **where)
    answered = client.call(data=True)
    told = [text for text in heard if text != "settled"]
    print(json.dumps({"heard": told, "set": answered and answered.message}), flush=True)
    # Until somebody has called its service.
    sys.stdin.readline()
    # Its session has threads that would keep the process.
    os._exit(0)


main(*sys.argv[1:])
