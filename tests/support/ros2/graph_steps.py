"""Read a graph in many steps, between which this process changes it; print each change as JSON."""

from __future__ import annotations

import json
import time
from typing import Any

import rclpy
from std_srvs.srv import SetBool

from sitegen.gateway.native.endpoint import Endpoint, Kind, Qos
from sitegen.gateway.native.graph import Graph


def answer(request: Any, response: Any) -> Any:
    return response


def own(kind: Kind, name: str) -> Endpoint:
    """Return what this process says of its own."""
    return Endpoint(f"own {name}", kind, "/page", name, "", "", Qos(), owner="page")


rclpy.init()
robot = rclpy.create_node("robot", start_parameter_services=False)
for letter in "abcde":
    robot.create_service(SetBool, f"/robot/{letter}", answer)
context = rclpy.Context()
context.init()
graph = Graph(rclpy.create_node("_gateway", context=context))
page = rclpy.create_node("page", context=context, start_parameter_services=False)
graph.add(own("node", "/page"))


def finish() -> tuple[int, list[str], list[str]]:
    """Read to the end; return the number of steps, and what has come and gone of the two nodes."""
    steps = 1
    while (changes := graph.changes(0)) is None:
        steps += 1
    come, gone = (
        [
            f"{one.kind} {one.name} {one.owner}"
            for one in some
            if one.name.startswith(("/robot", "/page")) and "type_description" not in one.name
        ]
        for some in changes
    )
    return steps, come, gone


seen: set[str] = set()
limit = time.monotonic() + 20
while len(seen) < 7 and time.monotonic() < limit:
    _, come, gone = finish()
    seen = (seen | {*come}) - {*gone}

assert graph.changes(0) is None
page.create_service(SetBool, "/page/set", answer)
graph.add(own("service", "/page/set"))
steps, *added = finish()

assert graph.changes(0) is None
graph.remove("own /page/set")
graph.remove("own /page")
page.destroy_node()
_, *removed = finish()

found = {"seen": sorted(seen), "steps": steps > 2, "added": added, "removed": removed}
print(json.dumps(found | {"after": finish()[1:]}))
