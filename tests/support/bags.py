"""Bags that tests play, written by the libraries of others, and the panels that play and record."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from mcap.writer import CompressionType
from mcap_ros2.writer import Writer
from paths import SITES
from playwright.sync_api import Locator, Page

START = 1_700_000_000_000_000_000
RULE = "=" * 80
STRING = ("std_msgs/msg/String", "string data")
# A type that no node of the page knows.
PLACE = (
    "far_msgs/msg/Place",
    f"# Where it is.\nfloat64 x  # in m\nfar_msgs/Name[] names\nuint8 HERE=1\n{RULE}\n"
    "MSG: far_msgs/Name\nstring text\n",
)
LATCHED = """- history: 1
  depth: 1
  reliability: 1
  durability: 1
  deadline: {sec: 9223372036, nsec: 854775807}
  lifespan: {sec: 9223372036, nsec: 854775807}
  liveliness: 1
  liveliness_lease_duration: {sec: 9223372036, nsec: 854775807}
  avoid_ros_namespace_conventions: false"""

TWIST = (
    "geometry_msgs/msg/Twist",
    f"geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n{RULE}\n"
    "MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n",
)
# What `drive` returns; the pages of sites/bags play it.
DRIVE = SITES / "bags/bags/drive.mcap"

# A message: the topic, the type with its definition, the content, and the ms from the start.
Sent = tuple[str, tuple[str, str], dict[str, Any], float]


def drive() -> list[Sent]:
    """Six seconds of words and places, and a latched text at the start."""
    sent: list[Sent] = [("/latched", STRING, {"data": "an old map"}, 0)]
    for number in range(120):
        sent.append(("/words", STRING, {"data": f"bag {number}"}, 50 * number))
        if number % 4 == 0:
            place = {"x": number / 10, "names": [{"text": "kitchen"}, {"text": "Küche"}]}
            sent.append(("/places", PLACE, place, 50 * number + 20))
    return sent


def spiral() -> list[Sent]:
    """The commands of demo12: ten a second, always faster ahead."""
    zero = {"x": 0.0, "y": 0.0, "z": 0.0}
    return [
        (
            "/turtle1/cmd_vel",
            TWIST,
            {"linear": {**zero, "x": 0.4 + 0.03 * number}, "angular": {**zero, "z": 2.0}},
            100 * number,
        )
        for number in range(150)
    ]


def write_bag(
    path: Path,
    sent: Sequence[Sent],
    compression: CompressionType = CompressionType.ZSTD,
    **options: Any,
) -> Path:
    """Write a bag as the library of MCAP's own project does; latched topics say so."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("wb") as stream:
        writer = Writer(stream, compression=compression, **{"chunk_size": 4096, **options})
        register = writer._writer.register_channel

        def registered(topic: str, message_encoding: str, schema_id: int, **_: Any) -> int:
            metadata = {"offered_qos_profiles": LATCHED} if topic == "/latched" else {}
            return register(topic, message_encoding, schema_id, metadata)

        writer._writer.register_channel = registered  # type: ignore[method-assign, assignment]
        schemas = {kind: writer.register_msgdef(*kind) for kind in {one[1]: None for one in sent}}
        for topic, kind, content, time in sent:
            at = START + int(time * 1e6)
            writer.write_message(topic, schemas[kind], content, log_time=at, publish_time=at)
        writer.finish()  # type: ignore[no-untyped-call]
    return path


def player(tab: Page) -> Locator:
    """The player of a page."""
    return tab.get_by_role("region", name="Player", exact=True)


def recorder(tab: Page) -> Locator:
    """The recorder of a page."""
    return tab.get_by_role("region", name="Recorder", exact=True)
