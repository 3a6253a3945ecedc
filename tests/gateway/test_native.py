"""The gateway's part in a native graph, beside an ordinary node of rclpy with Fast DDS."""

from __future__ import annotations

import json

from native import Native


def test_a_party_takes_part_in_the_native_graph() -> None:
    (line,) = Native().run("gateway_native.py")
    seen = json.loads(line)
    assert seen == {
        "out": ["std_msgs/msg/String", True, True, None],
        # Two parties share the one subscription of the gateway.
        "shared": 1,
        "order": True,
        "gid": True,
        "sequence": True,
        "latched": True,
        "gid of ours": True,
        "heard": ["to the robot"],
        "owner": "page",
        "malformed": "8 bytes are no std_msgs/String",
        "nodes": ["/_sitegen_gateway", "/robot", "/x/talker"],
        "publishers": [["/in", ["std_msgs/msg/String"]]],
        "called": "from the robot",
        "served": "from the page",
        "owned": [
            "client /robot/set",
            "node /x/talker",
            "publisher /in",
            "service /page/set",
        ],
        "unknown": "the type 'no_msgs/msg/A' is not installed beside the gateway",
        "invalid": "'String' is not a valid type",
        "node": "no node '/a b': Invalid node name: node name must not contain characters other "
        "than alphanumerics or '_':",
        "action": "Fibonacci_SendGoal_Request",
    }


def test_a_graph_is_read_in_steps_between_which_it_changes() -> None:
    (line,) = Native().run("graph_steps.py")
    services = [f"service /robot/{letter} None" for letter in "abcde"]
    assert json.loads(line) == {
        "seen": ["node /page page", "node /robot None", *services],
        "steps": True,
        "added": [["service /page/set page"], []],
        "removed": [[], ["service /page/set page", "node /page page"]],
        "after": [[], []],
    }
