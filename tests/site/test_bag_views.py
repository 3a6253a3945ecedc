"""A bag with a page of its own gets panels for its topics."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
from mcap.writer import CompressionType, Writer

from sitegen.config import load
from sitegen.model import Layout, Part, Widget
from sitegen.site.bags import with_views
from sitegen.site.bags.topics import Topic, topics

SCAN = ("sensor_msgs/msg/LaserScan", "std_msgs/Header header\nfloat32 angle_min\n")
IMAGE = ("sensor_msgs/msg/Image", "std_msgs/Header header\nuint32 height\n")
ODOMETRY = ("nav_msgs/msg/Odometry", "std_msgs/Header header\n")
STRING = ("std_msgs/msg/String", "string data")
OWN = (
    "own_msgs/msg/Motor",
    "uint8 LEFT=1\nstring name\nfloat64 speed  # in m/s\nint32 count 3\nfloat64[3] many\n"
    f"bool on\nuint8 load\nuint16 fourth\n{'=' * 80}\nMSG: own_msgs/Other\nfloat64 inner\n",
)


def write(path: Path, sent: Sequence[tuple[str, tuple[str, str]]], **options: Any) -> Path:
    with path.open("wb") as stream:
        writer = Writer(stream, compression=CompressionType.NONE, **options)
        writer.start(profile="ros2", library="test")
        for name, (kind, text) in sent:
            schema = writer.register_schema(kind, "ros2msg", text.encode())
            channel = writer.register_channel(name, "cdr", schema)
            writer.add_message(channel, 1, b"\x00\x01\x00\x00", 1)
        writer.finish()  # type: ignore[no-untyped-call]
    return path


def shown(parts: Sequence[Part]) -> list[Any]:
    """Widgets with the option that says what they show, inside of the layouts around them."""
    found: list[Any] = []
    for part in parts:
        if isinstance(part, Layout):
            found.append({part.kind: [shown(cell.content) for cell in part.cells]})
        elif isinstance(part, Widget):
            about = part.options.get("topic") or part.options.get("series")
            found.append((part.kind, about) if about else part.kind)
    return found


def views(folder: Path, content: str) -> list[Any]:
    (folder / "site.yaml").write_text(
        f"site: {{title: A}}\npages: [{{path: /, title: A, content: [{content}]}}]\n"
    )
    site = with_views(load(folder / "site.yaml"))
    assert not any(
        "views" in part.options for part in site.pages[0].leaves if isinstance(part, Widget)
    )
    return shown(site.pages[0].content)


def test_what_is_shown_depends_on_the_types_of_the_topics(tmp_path: Path) -> None:
    sent = [("/scan", SCAN), ("/odom", ODOMETRY), ("/words", STRING), ("/motor", OWN)]
    write(tmp_path / "a.mcap", [*sent, ("/camera/image_raw", IMAGE)])
    assert views(tmp_path, "{markdown: Hello}, {bag: a.mcap}") == [
        {"columns": [["3d"], ["bag"]]},
        {
            "grid": [
                [("image", "/camera/image_raw")],
                [
                    (
                        "plot",
                        [
                            *("/motor.speed", "/motor.count", "/motor.load"),
                            *("/odom.twist.twist.linear.x", "/odom.twist.twist.angular.z"),
                        ],
                    )
                ],
            ]
        },
        "topics",
    ]


@pytest.mark.parametrize(
    ("sent", "expected"),
    [
        ([("/words", STRING)], [{"columns": [["topics"], ["bag"]]}]),
        (
            [("/tf_static", ("tf2_msgs/msg/TFMessage", ""))],
            [{"columns": [["3d"], ["bag"]]}, "topics"],
        ),
        ([("/a/robot_description", STRING)], [{"columns": [["3d"], ["bag"]]}, "topics"]),
        (
            [(f"/image{n}", IMAGE) for n in range(6)],
            [
                {"columns": [[("image", "/image0")], ["bag"]]},
                {"grid": [[("image", f"/image{n}")] for n in (1, 2, 3)]},
                "topics",
            ],
        ),
    ],
)
def test_panels_without_anything_to_show_are_left_out(
    tmp_path: Path, sent: Sequence[tuple[str, tuple[str, str]]], expected: list[Any]
) -> None:
    write(tmp_path / "a.mcap", sent)
    assert views(tmp_path, "{bag: a.mcap}") == expected


@pytest.mark.parametrize(
    ("content", "has"),
    [
        ("{bag: {file: a.mcap, views: false}}", False),
        ("{bag: a.mcap}, {topics: }", False),
        ("{bag: a.mcap}, {bag: }", False),
        ("{bag: {file: a.mcap, views: true}}, {graph: }", True),
        ("{columns: [{bag: {file: a.mcap, views: true}}, {graph: }]}", True),
        ("{rows: [{bag: a.mcap}]}", True),
    ],
)
def test_only_a_bag_that_is_alone_has_panels_unless_it_is_said(
    tmp_path: Path, content: str, has: bool
) -> None:
    write(tmp_path / "a.mcap", [("/scan", SCAN)])
    assert ("'3d'" in str(views(tmp_path, content))) == has


def test_topics_have_the_names_that_they_are_played_with(tmp_path: Path) -> None:
    write(tmp_path / "a.mcap", [("/left", IMAGE), ("/right", IMAGE), ("/back", IMAGE)])
    bag = "{bag: {file: a.mcap, remap: {/left: /port}, exclude: [/back]}}"
    assert views(tmp_path, bag) == [
        {"columns": [[("image", "/port")], ["bag"]]},
        ("image", "/right"),
        "topics",
    ]


def test_topics_are_read_from_the_summary(tmp_path: Path) -> None:
    bag = write(tmp_path / "a.mcap", [("/b", SCAN), ("/a", STRING), ("/ä", OWN)])
    assert topics(bag) == [Topic("/a", *STRING), Topic("/b", *SCAN), Topic("/ä", *OWN)]
    content = bag.read_bytes()
    for number in range(len(content)):
        bag.write_bytes(content[:number])
        assert topics(bag) == []
    for number in range(len(content)):
        bag.write_bytes(bytes([*content[:number], content[number] ^ 255, *content[number + 1 :]]))
        topics(bag)
