"""JSON objects over WebSocket, for programs without ROS: messages that expire, and remote calls.

    from sitegen.rowe import Endpoint

    with Endpoint() as endpoint:
        robot = endpoint.connect("ws://robot.local:9090/rowe")
        endpoint.send({"topic": "speed", "linear": {"x": 0.2}}, ttl=0.5)
        answer = endpoint.invoke({"service": "add-two-numbers", "a": 38, "b": 4})
        print(answer.body["sum"])

`docs/rowe.md` describes it.
"""

from sitegen.rowe.blocking import Endpoint, open_local_endpoint, open_remote_endpoint
from sitegen.rowe.expiring import QueueFull
from sitegen.rowe.message import InvalidMessage, Message

__all__ = [
    "Endpoint",
    "InvalidMessage",
    "Message",
    "QueueFull",
    "open_local_endpoint",
    "open_remote_endpoint",
]
