"""Messages of rosbridge that are changed at random, and which of them are surely invalid."""

from __future__ import annotations

import copy
import json
import random
import re
from collections.abc import Iterator
from typing import Any, NoReturn

# Of each operation the fields that it must have.
REQUIRED = {
    "advertise": {"topic": "name", "type": "text"},
    "unadvertise": {"topic": "name"},
    "publish": {"topic": "name"},
    "subscribe": {"topic": "name"},
    "unsubscribe": {"topic": "name"},
    "call_service": {"service": "text"},
    "advertise_service": {"service": "name", "type": "text"},
    "unadvertise_service": {"service": "name"},
    "service_response": {"service": "text"},
    "advertise_action": {"action": "name", "type": "text"},
    "unadvertise_action": {"action": "name"},
    "send_action_goal": {"action": "name", "action_type": "text"},
    "cancel_action_goal": {"action": "text"},
    "action_feedback": {"action": "text"},
    "action_result": {"action": "text"},
    "set_level": {"level": "level"},
    "fragment": {"data": "text", "num": "number", "total": "number"},
    "auth": {},
}
OPTIONAL = {
    "advertise": {"latch": "flag", "queue_size": "number", "qos": "object"},
    "publish": {"msg": "object"},
    "subscribe": {"throttle_rate": "number", "compression": "text", "qos": "object"},
    "call_service": {"args": "object", "timeout": "number", "fragment_size": "number"},
    "send_action_goal": {"args": "object"},
    "service_response": {"result": "flag"},
}
TYPES: dict[str, type | tuple[type, ...]] = {
    "name": str,
    "text": str,
    "level": str,
    "flag": bool,
    "number": (int, float),
    "object": (dict, list),
}
LEVELS = ("none", "error", "warning", "info")
NAME = re.compile(r"[~/]?[A-Za-z_]\w*(/[A-Za-z_]\w*)*", re.ASCII)
LONGEST_ID = 1000

STRING, TWIST = "std_msgs/String", "geometry_msgs/msg/Twist"
FIBONACCI, OLD = "example_interfaces/Fibonacci", "actionlib_tutorials/FibonacciActionGoal"
FRAMES = {"source_frames": ["a"], "target_frame": "b", "rate": 10}
CLOUD = {"header": {"stamp": {"secs": 1, "nsecs": 2}}, "fields": [{"name": "x"}], "data": "AAAA"}
MESSAGES: list[dict[str, Any]] = [
    {"op": "advertise", "topic": "/m", "type": STRING, "id": "a", "qos": {"depth": 3}},
    {"op": "advertise", "topic": "/m/move", "type": TWIST, "latch": True, "queue_size": 2},
    {"op": "advertise", "topic": "/m/cloud", "type": "sensor_msgs/PointCloud2"},
    {"op": "unadvertise", "topic": "/m", "id": "a"},
    {"op": "publish", "topic": "/m", "msg": {"data": "x"}},
    {"op": "publish", "topic": "/m/move", "msg": {"linear": {"x": 1}}},
    {"op": "publish", "topic": "/m/cloud", "msg": CLOUD},
    {"op": "subscribe", "topic": "/chatter", "type": STRING, "id": "s", "compression": "cbor"},
    {"op": "subscribe", "topic": "/m/move", "throttle_rate": 5, "queue_length": 2},
    {"op": "unsubscribe", "topic": "/chatter", "id": "s"},
    {"op": "call_service", "service": "/add_two_ints", "args": {"a": 1, "b": 2}, "timeout": 0.1},
    {"op": "call_service", "service": "/rosapi/topics", "args": {}, "compression": "png"},
    {"op": "call_service", "service": "/rosapi/get_param", "args": {"name": "/robot:label"}},
    {"op": "call_service", "service": "/rosapi/set_param", "args": {"name": "m", "value": "1"}},
    {"op": "call_service", "service": "/rosapi/message_details", "args": {"type": TWIST}},
    {"op": "call_service", "service": "/rosapi/node_details", "args": {"node": "/robot"}},
    {"op": "call_service", "service": "/rosapi/topics_for_type", "args": {"type": STRING}},
    {"op": "advertise_service", "service": "/m/set", "type": "std_srvs/SetBool"},
    {"op": "unadvertise_service", "service": "/m/set"},
    {"op": "service_response", "service": "/m/set", "id": "x", "values": {}, "result": True},
    {"op": "advertise_action", "action": "/m/count", "type": FIBONACCI},
    {"op": "unadvertise_action", "action": "/m/count"},
    {"op": "send_action_goal", "action": "/fibonacci", "action_type": FIBONACCI, "id": "g"},
    {"op": "cancel_action_goal", "action": "/fibonacci", "id": "g"},
    {"op": "action_feedback", "action": "/m/count", "id": "q", "values": {"sequence": [1]}},
    {"op": "action_result", "action": "/m/count", "id": "q", "status": 4, "result": True},
    {"op": "set_level", "level": "error"},
    {"op": "fragment", "id": "f", "data": "{}", "num": 0, "total": 1},
    {"op": "auth", "mac": "x"},
    {"op": "advertise", "topic": "/old/goal", "type": OLD},
    {"op": "publish", "topic": "/old/goal", "msg": {"goal_id": {"id": "z"}, "goal": {"order": 1}}},
    {"op": "send_action_goal", "action": "/tf2_web_republisher", "id": "t", "args": FRAMES}
    | {"action_type": "tf2_web_republisher/TFSubscription"},
]
ODD: list[Any] = [
    *(None, True, False, 0, -1, -0.5, 2**53, 1e308, "", "x", "/a b", "/" * 300, "é" * 1001),
    *([], {}, [[[]]], ["a", 1, None], {"secs": "a"}, {"toString": 1}, {"length": 5}),
    *("__proto__", "constructor", "/chatter", STRING),
]


def mutations(seed: int, count: int) -> Iterator[str]:
    """Yield messages that are changed in one to three places, most of them still JSON."""
    chance = random.Random(seed)
    for _ in range(count):
        message = copy.deepcopy(chance.choice(MESSAGES))
        for _ in range(chance.randint(1, 3)):
            _change(message, chance)
        text = json.dumps(message, ensure_ascii=False)
        if chance.random() < 0.1:
            at = chance.randrange(len(text))
            text = text[:at] + chr(chance.randint(32, 122)) + text[at + 1 :]
        if chance.random() < 0.02:
            text = text[: chance.randrange(len(text))]
        yield text


def _change(message: dict[str, Any], chance: random.Random) -> None:
    places = list(_places(message))
    if not places:
        return
    inside, key = chance.choice(places)
    way = chance.random()
    if way < 0.3:
        del inside[key]
    elif way < 0.75:
        inside[key] = copy.deepcopy(chance.choice(ODD))
    elif way < 0.85:
        message[chance.choice(["extra", "__proto__", "msg", "args", "id"])] = chance.choice(ODD)
    elif isinstance(inside[key], str):
        letters = (chr(chance.randrange(300)) if chance.random() < 0.2 else c for c in inside[key])
        inside[key] = "".join(letters)


def _places(inside: Any) -> Iterator[tuple[Any, Any]]:
    keys = inside if isinstance(inside, dict) else range(len(inside))
    for key in keys:
        yield inside, key
        if isinstance(inside[key], dict | list):
            yield from _places(inside[key])


def is_invalid(text: str) -> bool:
    """Return whether a message cannot be meant as anything, whatever the graph has."""
    try:
        message = json.loads(text, parse_constant=_refuse)
    except ValueError:
        return True
    if not isinstance(message, dict) or message.get("op") not in list(REQUIRED):
        return True
    op, name = message["op"], message.get("id")
    if not (name is None or _is(name, "number") or (_is(name, "text") and len(name) <= LONGEST_ID)):
        return True
    required, optional = REQUIRED[op], OPTIONAL.get(op, {})
    return not all(_is(message.get(key), kind) for key, kind in required.items()) or not all(
        message.get(key) is None or _is(message[key], kind) for key, kind in optional.items()
    )


def _refuse(constant: str) -> NoReturn:
    raise ValueError(constant)


def _is(value: object, kind: str) -> bool:
    if not isinstance(value, TYPES[kind]) or (kind == "number" and isinstance(value, bool)):
        return False
    if kind == "name":
        return NAME.fullmatch(str(value)) is not None
    return kind != "level" or value in LEVELS
