"""What compiled nodes find out: about the graph, services, messages and loggers."""

from __future__ import annotations

from panel import Played
from paths import SITES

SITE = SITES / "rclcpp"


def test_programs_are_answered(played: Played) -> None:
    asking = played(SITE, "asking", "asking")
    assert asking.lines() == [
        "global asking asking",
        "changed 1, again 0",
        "node /asking",
        "node /deep/other",
        "words is std_msgs/msg/String",
        "/deep/add is example_interfaces/srv/AddTwoInts",
        "counts 1 1 1 0, matched 1",
        "asking in /: std_msgs/msg/String, kind 1, reliable 1, kept 1, deadline 0.20",
        "other in /deep: std_msgs/msg/String, kind 2, reliable 0, kept 0, deadline 0.25",
        "the same gid 1",
        "refused: failed to get service names and types by node: "
        "cannot get service names and types for nonexistent node",
        "event 0 of request 1, asked 3, answered -1",
        "event 1 of request 1, asked -1, answered -1",
        "event 2 of request 1, asked -1, answered -1",
        "event 3 of request 1, asked -1, answered 5",
        "one client 1, sum 5",
        "message_age of asking in ms: 1 1 1 1 count 3",
        "message_period of asking in ms: 1 1 1 1 count 2",
        "by name 5, later -1, removed 1 0",
        "the service type 'std_srvs/srv/Empty' is not known here: include its header",
        "flows 1",
        "level 1 0, now 40",
        "waited 1 kept",
        "depth 7, reliable 0",
        "left to the system: 1 1 1 1",
        "refused: validation callback failed: too deep",
    ]
