"""Answers as rosbridge_server 2.1.0 and its rosapi have been seen to, which no registry has.

The graph behind it has a robot that publishes, a service and an action; nothing of it is ROS.
"""

from __future__ import annotations

import asyncio
import json
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import cbor2
from aiohttp import WSMsgType, web

Message = dict[str, Any]

SERVER = "/rosbridge_websocket"
CLIENTS = "rosbridge_msgs/msg/ConnectedClients"
STRING, SCAN, ODOMETRY = "std_msgs/msg/String", "robot_msgs/msg/Scan", "robot_msgs/msg/Odometry"
TEXTS = {
    STRING: "string data\n",
    SCAN: "float32[] ranges\n",
    ODOMETRY: "robot_msgs/Pose pose\n"
    + "=" * 80
    + "\nMSG: robot_msgs/Pose\nfloat64[2] covariance\n",
    CLIENTS: "# failed to get full definition text for it: no such file\n",
}
TOPICS = {
    "/robot/chatter": STRING,
    "/robot/scan": SCAN,
    "/robot/odom": ODOMETRY,
    "/connected_clients": CLIENTS,
}
VALUES: dict[str, Message] = {
    "/robot/chatter": {"data": "robot"},
    # 1.5, infinity.
    "/robot/scan": {"ranges": cbor2.CBORTag(85, bytes.fromhex("0000c03f0000807f"))},
    "/robot/odom": {"pose": {"covariance": [0.25, None]}},
}
SERVICES = {"/robot/set": "std_srvs/srv/SetBool", "/robot/slow": "std_srvs/srv/SetBool"}


class OlderBridge:
    """Listens on `port`; `heard` is what clients have sent, and `silent` lets it stand still."""

    def __init__(self) -> None:
        self.port = 0
        self.heard: list[Message] = []
        self.silent = False
        self.has_rosapi = True
        self._released = threading.Event()
        self.advertised: dict[str, str] = {}
        self.subscribed: list[tuple[web.WebSocketResponse, str, str]] = []

    def operations(self, op: str, **fields: object) -> list[Message]:
        """Return what clients have sent of this kind."""
        wanted = {"op": op, **fields}.items()
        return [
            one
            for one in [*self.heard]
            if wanted <= {k: v for k, v in one.items() if k in dict(wanted)}.items()
        ]

    def release(self) -> None:
        """Let the slow service answer."""
        self._released.set()

    async def serve(self, request: web.Request) -> web.StreamResponse:
        """Handle what one connection sends, one after another, as it does by default."""
        socket = web.WebSocketResponse()
        await socket.prepare(request)
        async for message in socket:
            if message.type != WSMsgType.TEXT:
                break
            while self.silent:
                await asyncio.sleep(0.05)
            said = json.loads(message.data)
            self.heard.append(said)
            await self._handle(socket, said)
        self.subscribed = [one for one in self.subscribed if one[0] is not socket]
        return socket

    async def _handle(self, socket: web.WebSocketResponse, said: Message) -> None:
        match said["op"]:
            case "call_service":
                result, values = await self._call(said["service"], said["args"])
                answer = {"op": "service_response", "service": said["service"]}
                await socket.send_json({**answer, "values": values, "result": result})
            case "advertise" if said["type"] in TEXTS or said["type"].startswith("rcl_interfaces"):
                self.advertised[said["topic"]] = said["type"]
            case "subscribe":
                self.subscribed.append((socket, said["topic"], said["compression"]))
            case "unsubscribe":
                self.subscribed = [one for one in self.subscribed if one[1] != said["topic"]]
            case "publish" if said["topic"] in self.advertised:
                await self.publish(said["topic"], said["msg"])

    async def publish(self, topic: str, msg: Message) -> None:
        """Send a message to all who have subscribed, who may have sent it themselves."""
        for socket, name, compression in [*self.subscribed]:
            if name != topic:
                continue
            message = {"op": "publish", "topic": topic, "msg": msg}
            if compression == "cbor":
                await socket.send_bytes(cbor2.dumps(message))
            else:
                await socket.send_json(message)

    async def tell(self) -> None:
        """Let the robot publish."""
        while True:
            await asyncio.sleep(0.1)
            if self.silent:
                continue
            for topic, values in VALUES.items():
                # It cannot write arrays of a fixed size as CBOR.
                if topic == "/robot/odom" and any(
                    one[1:] == (topic, "cbor") for one in self.subscribed
                ):
                    continue
                await self.publish(topic, values)

    async def _call(self, service: str, args: Message) -> tuple[bool, Any]:
        if service.startswith("/rosapi/"):
            found = self._ask(service.removeprefix("/rosapi/"), args) if self.has_rosapi else None
            return (False, f"Service {service} does not exist") if found is None else (True, found)
        if service.endswith("/_action/send_goal"):
            text = "Unable to import srv class Count_SendGoal from package robot_msgs. Caused by it"
            return False, text
        if service == "/robot/slow":
            await asyncio.to_thread(self._released.wait, 60)
        if service in SERVICES:
            return True, {"success": args["data"], "message": "from the robot"}
        return False, f"Service {service} does not exist"

    def _ask(self, what: str, args: Message) -> Message | None:
        topics = {**TOPICS, **self.advertised}
        details = {
            "/robot": ({*VALUES}, {"/shared"}, {*SERVICES}),
            SERVER: (
                {*self.advertised, "/connected_clients"},
                {one[1] for one in self.subscribed},
                set(),
            ),
        }
        match what:
            case "topics":
                return {"topics": [*topics], "types": [*topics.values()]}
            case "topics_and_raw_types":
                texts = [TEXTS.get(kind, "# failed to get it\n") for kind in topics.values()]
                return {
                    "topics": [*topics],
                    "types": [*topics.values()],
                    "typedefs_full_text": texts,
                }
            case "services":
                return {"services": [*SERVICES, "/rosapi/topics"]}
            case "service_type":
                return {"type": SERVICES.get(args["service"], "")}
            case "nodes":
                return {"nodes": [*details]}
            case "node_details":
                publishing, subscribing, services = details[args["node"]]
                names = {"publishing": publishing, "subscribing": subscribing, "services": services}
                return {side: sorted(found) for side, found in names.items()}
            case "action_servers":
                return {"action_servers": ["/robot/count"]}
            case "get_ros_version":
                return {"version": 2, "distro": "jazzy"}
            case "get_time":
                return {"time": {"sec": 0, "nanosec": 0}}
        return None


@contextmanager
def older_bridge() -> Iterator[OlderBridge]:
    """Run one on a free port, in a thread."""
    bridge = OlderBridge()
    listening, stop = threading.Event(), threading.Event()

    async def run() -> None:
        app = web.Application()
        app.router.add_get("/", bridge.serve)
        runner = web.AppRunner(app, shutdown_timeout=0.1)
        await runner.setup()
        await web.TCPSite(runner, "127.0.0.1", 0).start()
        bridge.port = runner.addresses[0][1]
        listening.set()
        telling = asyncio.create_task(bridge.tell())
        await asyncio.to_thread(stop.wait)
        telling.cancel()
        bridge.release()
        await runner.cleanup()

    thread = threading.Thread(target=asyncio.run, args=(run(),))
    thread.start()
    listening.wait(10)
    try:
        yield bridge
    finally:
        stop.set()
        thread.join()
