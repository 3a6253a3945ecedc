"""Use sitegen.gateway.native beside rclpy; print a JSON object of what was seen."""

from __future__ import annotations

import asyncio
import json
import os
import threading
import time
from typing import Any

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String
from std_srvs.srv import SetBool

from sitegen.gateway import native as gateway
from sitegen.gateway.native import Endpoint, Native, Qos, Sample

# Robots of other tests are in the domain that is given.
os.environ["ROS_DOMAIN_ID"] = str(int(os.environ["ROS_DOMAIN_ID"]) + 100)
STRING = "std_msgs/msg/String"
SET = "std_srvs/srv/SetBool"


class Robot:
    """An ordinary node of its own context, which is another participant of DDS."""

    def __init__(self) -> None:
        self.context = rclpy.Context()
        self.context.init(args=[])
        self.node = rclpy.create_node("robot", context=self.context)
        self.heard: list[str] = []
        latched = QoSProfile(depth=5, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.out = self.node.create_publisher(String, "/out", 100)
        self.map = self.node.create_publisher(String, "/map", latched)
        self.node.create_subscription(String, "/in", lambda m: self.heard.append(m.data), 10)
        self.node.create_service(SetBool, "/robot/set", self._set)
        self.client = self.node.create_client(SetBool, "/page/set")
        self.executor = SingleThreadedExecutor(context=self.context)
        self.executor.add_node(self.node)
        self.thread = threading.Thread(target=self.executor.spin, daemon=True)
        self.thread.start()

    def _set(self, request: Any, response: Any) -> Any:
        response.success, response.message = request.data, "from the robot"
        return response

    def stop(self) -> None:
        self.executor.shutdown()
        self.thread.join()
        self.node.destroy_node()
        self.context.try_shutdown()


async def until(check: Any) -> None:
    limit = time.monotonic() + 10
    while not check():
        assert time.monotonic() < limit, "timed out"
        await asyncio.sleep(0.01)


async def main() -> dict[str, Any]:
    seen: dict[str, Any] = {}
    robot = Robot()
    robot.map.publish(String(data="latched"))
    native = Native()
    await native.start()
    present: dict[str, Endpoint] = {}

    def watch(come: list[Endpoint], gone: list[Endpoint]) -> None:
        present.update({e.key: e for e in come})
        for endpoint in gone:
            del present[endpoint.key]

    def has(kind: str, node: str, name: str) -> bool:
        return any((e.kind, e.node, e.name) == (kind, node, name) for e in present.values())

    native.watch(watch)
    await until(
        lambda: has("publisher", "/robot", "/out") and has("service", "/robot", "/robot/set")
    )
    out = next(e for e in present.values() if e.name == "/out")
    seen["out"] = [out.type, out.hash == gateway.hash_of(STRING) != "", out.qos.reliable, out.owner]

    page, other = native.join("page"), native.join("other")
    await page.add_node("/x/talker")
    a: list[Sample] = []
    b: list[Sample] = []
    await page.subscribe("/out", STRING, Qos(100), a.append)
    sub_b = await other.subscribe("/out", STRING, Qos(100), b.append)
    await until(lambda: robot.out.get_subscription_count() == 1)
    seen["shared"] = robot.out.get_subscription_count()
    for n in range(50):
        robot.out.publish(String(data=str(n)))
    await until(lambda: len(a) == 50 and len(b) == 50)
    texts = [gateway.from_cdr(s.data, String).data for s in a]
    seen["order"] = texts == [str(n) for n in range(50)]
    seen["gid"] = {s.gid for s in a} == {out.gid}
    seen["sequence"] = [s.sequence for s in a] == list(range(1, 51))

    latched: list[Sample] = []
    await other.subscribe("/map", STRING, Qos(transient_local=True), latched.append)
    await until(lambda: latched)
    seen["latched"] = latched[0].latched

    publisher = await page.advertise("/in", STRING, Qos(), node="/x/talker")
    echoes: list[Sample] = []
    await other.subscribe("/in", STRING, Qos(), echoes.append)
    await until(lambda: robot.node.count_publishers("/in") == 1)
    infos = robot.node.get_publishers_info_by_topic("/in")
    await until(lambda: robot.node.get_publishers_info_by_topic("/in")[0].node_name == "talker")
    seen["gid of ours"] = bytes(infos[0].endpoint_gid) == publisher.endpoint.gid
    await asyncio.sleep(0.3)
    await publisher.publish(gateway.to_cdr(String(data="to the robot")))
    await until(lambda: robot.heard and echoes)
    seen["heard"], seen["owner"] = robot.heard, echoes[0].owner
    try:
        await publisher.publish(b"\0\1\0\0\xff\xff\xff\xff")
    except gateway.MalformedMessageError as error:
        seen["malformed"] = str(error)
    seen["nodes"] = sorted(
        {f"{ns.rstrip('/')}/{name}" for name, ns in robot.node.get_node_names_and_namespaces()}
    )
    seen["publishers"] = robot.node.get_publisher_names_and_types_by_node("talker", "/x")

    client = await page.client("/robot/set", SET, node="/x/talker")
    response = await client.call(gateway.to_cdr(SetBool.Request(data=True)))
    seen["called"] = gateway.from_cdr(response, SetBool.Response).message

    def asked(request: gateway.Request) -> None:
        request.respond(gateway.to_cdr(SetBool.Response(success=True, message="from the page")))

    await page.serve("/page/set", SET, asked, node="/x/talker")
    await until(robot.client.service_is_ready)
    future = robot.client.call_async(SetBool.Request(data=True))
    await until(future.done)
    seen["served"] = future.result().message
    await until(lambda: has("client", "/robot", "/page/set"))
    await native.refresh()
    seen["owned"] = sorted(f"{e.kind} {e.name}" for e in present.values() if e.owner == "page")

    for name, kind in (("unknown", "no_msgs/msg/A"), ("invalid", "String")):
        try:
            await page.advertise("/in", kind, Qos())
        except gateway.UnknownTypeError as error:
            seen[name] = str(error)
    try:
        await page.add_node("/a b")
    except gateway.NativeError as error:
        seen["node"] = str(error)
    seen["action"] = gateway.load_type("test_msgs/action/Fibonacci_SendGoal").Request.__name__

    await page.close()
    await sub_b.close()
    await until(lambda: robot.out.get_subscription_count() == 0)
    await until(lambda: not any(e.owner == "page" for e in present.values()))
    await until(lambda: robot.node.count_publishers("/in") == 0)
    await until(lambda: "talker" not in robot.node.get_node_names())
    robot.stop()
    await until(lambda: not any(e.node == "/robot" for e in present.values()))
    await native.stop()
    return seen


print(json.dumps(asyncio.run(main())))
