"""rosbridge v2 as a raw client speaks it, with a native robot behind the gateway."""

from __future__ import annotations

import asyncio
import base64
import io
import json
import math
import struct
from typing import Any

import cbor2
import pytest
from gateways import Gateway, client, run
from PIL import Image


def test_messages_go_both_ways(opened: Gateway) -> None:
    async def work() -> None:
        async with client(opened) as page:
            await page.settle()
            for number in range(20):
                await page.send(op="publish", topic="/tell", msg={"data": f"n{number}"})
            heard = [(await page.until("publish"))["msg"]["data"] for _ in range(20)]
            assert heard == [f"n{number}" for number in range(20)]

    run(work())


def test_a_type_may_be_left_out(opened: Gateway) -> None:
    async def work() -> None:
        async with client(opened) as page:
            await page.send(op="subscribe", topic="heard")
            await page.send(op="publish", topic="/tell", msg={"data": "without type"})
            assert (await page.until("publish", topic="/heard"))["msg"] == {"data": "without type"}

    run(work())


@pytest.mark.parametrize("topic", ["/map", "/lossy"])
def test_the_quality_of_service_follows_the_publishers(opened: Gateway, topic: str) -> None:
    async def work() -> None:
        async with client(opened) as page:
            await page.send(op="subscribe", topic=topic)
            message = await page.until("publish", topic=topic)
            assert message["msg"]["data"] in ("the map", "lossy")

    run(work())


def test_values_are_those_of_json(opened: Gateway) -> None:
    async def work() -> None:
        async with client(opened) as page:
            await page.send(op="subscribe", topic="/image")
            image = (await page.until("publish", topic="/image"))["msg"]
            assert base64.b64decode(image["data"]) == bytes(range(9))
            assert set(image["header"]["stamp"]) == {"sec", "nanosec"}
            await page.send(op="subscribe", topic="/scan")
            scan = (await page.until("publish", topic="/scan"))["msg"]
            assert scan["ranges"] == [1.0, None, None, 2.5]

    run(work())


def test_compressions(opened: Gateway) -> None:
    async def work() -> None:
        async with client(opened) as page:
            await page.send(op="subscribe", topic="/scan", compression="cbor")
            message = cbor2.loads((await page.until("binary"))["data"])
            assert message["topic"] == "/scan"
            ranges = message["msg"]["ranges"]
            assert ranges.tag == 85
            values = struct.unpack("<4f", ranges.value)
            assert values[0] == 1 and math.isnan(values[1]) and math.isinf(values[2])
        async with client(opened) as page:
            await page.send(op="subscribe", topic="/map", compression="cbor-raw")
            message = cbor2.loads((await page.until("binary"))["data"])
            assert message["msg"]["bytes"] == b"\0\1\0\0\x08\0\0\0the map\0"
        async with client(opened) as page:
            await page.send(op="subscribe", topic="/map", compression="png")
            data = base64.b64decode((await page.until("png"))["data"])
            pixels = Image.open(io.BytesIO(data)).tobytes()
            assert json.loads(pixels)["msg"] == {"data": "the map"}

    run(work())


def test_fragments_in_both_directions(opened: Gateway) -> None:
    async def work() -> None:
        async with client(opened) as page:
            await page.send(op="subscribe", topic="/heard", fragment_size=40)
            text = json.dumps({"op": "publish", "topic": "/tell", "msg": {"data": "x" * 200}})
            parts = [text[i : i + 50] for i in range(0, len(text), 50)]
            # In any order.
            for number, part in reversed(list(enumerate(parts))):
                total = len(parts)
                await page.send(op="fragment", id="f", num=number, total=total, data=part)
            first = await page.until("fragment")
            found = [first, *[await page.until("fragment") for _ in range(first["total"] - 1)]]
            whole = json.loads("".join(part["data"] for part in found))
            assert whole["msg"] == {"data": "x" * 200}

    run(work())


def test_throttled_topics_end_with_the_newest(opened: Gateway) -> None:
    async def work() -> None:
        async with client(opened) as page:
            await page.send(op="subscribe", topic="/heard", throttle_rate=300)
            for number in range(10):
                await page.send(op="publish", topic="/tell", msg={"data": str(number)})
            seen: list[str] = []
            while not seen or seen[-1] != "9":
                seen.append((await page.until("publish"))["msg"]["data"])
            assert len(seen) < 5

    run(work())


def test_services_of_the_robot(opened: Gateway) -> None:
    async def work() -> None:
        async with client(opened) as page:
            answer = await page.call("/set", {"data": True}, type="std_srvs/SetBool")
            assert answer["values"] == {"success": True, "message": "from the robot"}
            assert answer["result"] is True
            assert (await page.call("/set", [False]))["values"]["success"] is False
            wrong = await page.call("/set", {"data": "yes"})
            assert wrong["result"] is False
            assert wrong["values"] == "data: expected true or false, found 'yes'"

    run(work())


def test_services_of_a_client(opened: Gateway) -> None:
    async def work() -> None:
        async with client(opened) as page:
            await page.send(op="advertise_service", service="/of_client", type="std_srvs/Trigger")
            await page.send(op="call_service", service="/call_back", id="1")
            request = await page.until("call_service", service="/of_client")
            values = {"success": True, "message": "from the client"}
            answer = {"service": "/of_client", "id": request["id"], "values": values}
            await page.send(op="service_response", result=True, **answer)
            assert (await page.until("service_response", id="1"))["values"] == values

    run(work())


def test_goals_of_a_client(opened: Gateway) -> None:
    goal = {"action": "/fibonacci", "action_type": "test_msgs/Fibonacci", "feedback": True}

    async def work() -> None:
        async with client(opened) as page:
            await page.send(op="send_action_goal", id="g", args={"order": 3}, **goal)
            feedback = [await page.until("action_feedback", id="g") for _ in range(3)]
            assert feedback[0]["values"] == {"sequence": [0, 1, 1]}
            result = await page.until("action_result", id="g")
            assert (result["status"], result["result"]) == (4, True)
            assert result["values"] == {"sequence": [0, 1, 1, 2, 3]}
            await page.send(op="send_action_goal", id="h", args={"order": 1000}, **goal)
            await page.until("action_feedback", id="h")
            await page.send(op="cancel_action_goal", id="h", action="/fibonacci")
            assert (await page.until("action_result", id="h"))["status"] == 5

    run(work())


def test_a_goal_ends_with_its_client(opened: Gateway) -> None:
    async def work() -> None:
        async with client(opened) as watcher:
            await watcher.send(op="subscribe", topic="/heard")
            async with client(opened) as page:
                goal = {"action": "/fibonacci", "action_type": "test_msgs/action/Fibonacci"}
                args = {"order": 1000}
                await page.send(op="send_action_goal", id="g", args=args, feedback=True, **goal)
                await page.until("action_feedback", id="g")
            assert (await watcher.until("publish"))["msg"] == {"data": "goal canceled"}

    run(work())


def test_actions_of_a_client(opened: Gateway) -> None:
    async def work() -> None:
        async with client(opened) as page:
            await page.send(op="advertise_action", action="/count", type="test_msgs/Fibonacci")
            await page.send(op="call_service", service="/send_goal", id="1")
            goal = await page.until("send_action_goal", action="/count")
            assert goal["args"] == {"order": 3}
            about: dict[str, Any] = {"action": "/count", "id": goal["id"]}
            await page.send(op="action_feedback", values={"sequence": [7]}, **about)
            values = {"sequence": [7, 8]}
            await page.send(op="action_result", values=values, status=4, result=True, **about)
            answer = await page.until("service_response", id="1")
            assert answer["values"] == {"success": True, "message": "[7, 8] after [[7]]"}

    run(work())


def test_rosapi(opened: Gateway) -> None:
    async def work() -> None:
        async with client(opened) as page:

            async def ask(service: str, /, **args: Any) -> Any:
                answer = await page.call(f"/rosapi/{service}", args)
                assert answer["result"], answer
                return answer["values"]

            topics = await ask("topics")
            assert dict(zip(topics["topics"], topics["types"], strict=True))["/heard"] == (
                "std_msgs/msg/String"
            )
            assert "/protected_door" not in topics["topics"]
            assert "/rosout" in topics["topics"]
            assert "/robot" in (await ask("nodes"))["nodes"]
            details = await ask("node_details", node="/robot")
            assert "/heard" in details["publishing"] and "/tell" in details["subscribing"]
            assert "/set" in (await ask("services"))["services"]
            assert (await ask("services_for_type", type="std_srvs/SetBool"))["services"] == ["/set"]
            assert (await ask("topic_type", topic="/scan"))["type"] == "sensor_msgs/msg/LaserScan"
            assert (await ask("service_type", service="/set"))["type"] == "std_srvs/srv/SetBool"
            assert (await ask("service_node", service="/set"))["node"] == "/robot"
            assert (await ask("action_servers"))["action_servers"] == ["/fibonacci"]
            action = await ask("action_type", action="/fibonacci")
            assert action["type"] == "test_msgs/action/Fibonacci"
            [twist, vector] = (await ask("message_details", type="geometry_msgs/Twist"))["typedefs"]
            assert twist["fieldtypes"] == ["geometry_msgs/Vector3"] * 2
            assert vector["fieldnames"] == ["x", "y", "z"]
            [request] = (await ask("service_request_details", type="std_srvs/SetBool"))["typedefs"]
            assert request["fieldnames"] == ["data"]
            raw = await ask("topics_and_raw_types")
            text = raw["typedefs_full_text"][raw["topics"].index("/cmd_vel")]
            assert text.startswith("# This expresses velocity in free space")
            assert (
                "Vector3  linear" in text and f"\n{'=' * 80}\nMSG: geometry_msgs/Vector3\n#" in text
            )
            assert (await ask("get_ros_version"))["version"] == 2
            assert "/robot:speed" in (await ask("get_param_names"))["names"]
            assert json.loads((await ask("get_param", name="/robot:speed"))["value"]) == 1.5
            assert (await ask("set_param", name="/robot:speed", value="2"))["successful"]
            assert json.loads((await ask("get_param", name="/robot:speed"))["value"]) == 2.0
            assert (await ask("has_param", name="/robot:none"))["exists"] is False
            gone = await ask("get_param", name="/robot:none", default_value='"x"')
            assert gone["value"] == '"x"'

    run(work())


def test_names_may_lack_the_slash_and_the_node(opened: Gateway) -> None:
    async def work() -> None:
        async with client(opened) as page:

            async def ask(service: str, /, **args: Any) -> Any:
                return (await page.call(f"rosapi/{service}", args))["values"]

            assert (await ask("topic_type", topic="scan"))["type"] == "sensor_msgs/msg/LaserScan"
            assert (await ask("publishers", topic="scan"))["publishers"] == ["/robot"]
            assert (await ask("service_type", service="set"))["type"] == "std_srvs/srv/SetBool"
            assert (await page.call("set", {"data": True}))["values"]["success"] is True
            assert (await ask("set_param", name="names", value='["c"]'))["successful"]
            assert json.loads((await ask("get_param", name="/names"))["value"]) == ["c"]
            assert json.loads((await ask("get_param", name="robot:names"))["value"]) == ["c"]
            assert (await ask("has_param", name="names"))["exists"] is True
            gone = await ask("get_param", name="none", default_value="2")
            assert (gone["value"], gone["reason"]) == ("2", "no node has a parameter 'none'")
            await page.send(op="subscribe", topic="map")
            assert (await page.until("publish"))["topic"] == "/map"

    run(work())


@pytest.mark.parametrize(
    ("message", "told"),
    [
        ("{", "a message that is not JSON"),
        ("[]", "a message without 'op'"),
        ('{"op": "fly", "id": "\\ud800"}', "a message that is not JSON"),
        ('{"op": "fly", "id": NaN}', "'id' must be text or a number"),
        ('{"op": "fly"}', "unknown operation 'fly'"),
        ('{"op": "subscribe"}', "subscribe: needs 'topic'"),
        ('{"op": "subscribe", "topic": 5}', "subscribe: needs text as 'topic'"),
        ('{"op": "subscribe", "topic": "/a b"}', "'/a b' is not a valid name"),
        ('{"op": "subscribe", "topic": "/none"}', "subscribe: /none is unknown; say its type"),
        (
            '{"op": "subscribe", "topic": "/map", "type": "std_msgs/Bool"}',
            "subscribe: /map has the type std_msgs/msg/String, not std_msgs/msg/Bool",
        ),
        (
            '{"op": "advertise", "topic": "/x", "type": "no_msgs/A"}',
            "the type 'no_msgs/msg/A' is not installed beside the gateway",
        ),
        (
            '{"op": "publish", "topic": "/tell", "msg": {"daat": 1}}',
            "String has no field 'daat'",
        ),
        (
            '{"op": "publish", "topic": "/tell", "msg": {"data": 1}}',
            "data: expected text, found '1'",
        ),
        ('{"op": "subscribe", "topic": "/protected_door"}', "/protected_door is protected"),
        (
            '{"op": "fragment", "id": "a", "num": 3, "total": 2, "data": ""}',
            "fragment: needs 'id', 'num' and 'total'",
        ),
    ],
)
def test_wrong_operations_are_answered(opened: Gateway, message: str, told: str) -> None:
    async def work() -> None:
        async with client(opened) as page:
            await page.socket.send_str(message)
            assert (await page.until("status"))["msg"] == told

    run(work())


def test_levels_of_statuses(opened: Gateway) -> None:
    async def work() -> None:
        async with client(opened) as page:
            await page.send(op="set_level", level="none")
            await page.send(op="fly")
            await page.send(op="set_level", level="warning")
            await page.send(op="unadvertise", topic="/tell", id="u")
            status = await page.until("status")
            assert (status["id"], status["level"]) == ("u", "warning")

    run(work())


def test_a_publisher_that_comes_later_is_heard(opened: Gateway) -> None:
    async def work() -> None:
        async with client(opened) as page, client(opened) as other:
            kind = {"topic": "/later", "type": "std_msgs/String"}
            await page.send(op="subscribe", **kind)
            qos = {"reliability": "best_effort"}
            await other.send(op="advertise", qos=qos, **kind)
            # Until both have found each other, messages may be lost.
            message: dict[str, Any] = {}
            while not message:
                await other.send(op="publish", topic="/later", msg={"data": "late"})
                try:
                    message = await asyncio.wait_for(page.next(), 0.2)
                except TimeoutError:
                    continue
            assert message["msg"] == {"data": "late"}

    run(work())


def test_calls_of_a_client_are_done_in_their_order(opened: Gateway) -> None:
    async def work() -> None:
        async with client(opened) as page:
            for number in range(20):
                args = {"name": "/robot:speed", "value": str(number)}
                await page.send(op="call_service", service="/rosapi/set_param", args=args)
                args = {"name": "/robot:speed"}
                call = {"service": "/rosapi/get_param", "args": args, "id": str(number)}
                await page.send(op="call_service", **call)
            for number in range(20):
                answer = await page.until("service_response", id=str(number))
                assert json.loads(answer["values"]["value"]) == number

    run(work())


def test_clients_may_send_cbor(opened: Gateway) -> None:
    async def work() -> None:
        async with client(opened) as page:
            about = {"topic": "/cbor", "type": "sensor_msgs/LaserScan"}
            await page.send(op="subscribe", **about)
            await page.send(op="advertise", **about)
            ranges = cbor2.CBORTag(85, struct.pack("<2f", 0.5, 1.5))
            message = {"ranges": ranges, "header": {"seq": 7, "stamp": {"secs": 5, "nsecs": 6}}}
            publish = {"op": "publish", "topic": "/cbor", "msg": message}
            await page.socket.send_bytes(cbor2.dumps(publish))
            found = (await page.until("publish", topic="/cbor"))["msg"]
            assert found["ranges"] == [0.5, 1.5]
            assert found["header"]["stamp"] == {"sec": 5, "nanosec": 6}

    run(work())
