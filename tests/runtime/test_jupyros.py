"""The module jupyros describes panels as pages mount them, and reads bags."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from bags import STRING, write_bag
from mcap.writer import CompressionType
from paths import ROOT

from sitegen.config.widgetkeys import WIDGETS
from sitegen.site.assets import IN_CELLS

CLIENT = str(ROOT / "sitegen/clients/python")


@pytest.fixture(autouse=True)
def path() -> Iterator[None]:
    sys.path.append(CLIENT)
    yield
    sys.path.remove(CLIENT)


class Twist:
    """A class as rosidl generates it."""


Twist.__module__ = "geometry_msgs.msg._twist"


def test_each_verb_is_a_panel_with_options_of_site_yaml() -> None:
    import jupyros

    panels = [
        *(jupyros.publish("/cmd_vel", Twist), jupyros.service_client("add"), jupyros.echo("a")),
        *(jupyros.action_client("go"), jupyros.live_plot("/a.x"), jupyros.view(top=True)),
        *(jupyros.joints(), jupyros.parameters("talker"), jupyros.tf(), jupyros.image()),
        jupyros.bag_player("a.mcap", from_=2),
    ]
    assert {panel.kind for panel in panels} == {*IN_CELLS}
    for panel in panels:
        assert panel.options.keys() <= {key.name for key in WIDGETS[panel.kind]}


@pytest.mark.parametrize(
    ("given", "series"),
    [
        ("/odom.twist.x", ["/odom.twist.x"]),
        ("odom.twist.x", ["/odom.twist.x"]),
        ("/turtle1/pose/:x:y", ["/turtle1/pose.x", "/turtle1/pose.y"]),
    ],
)
def test_fields_are_named_as_in_jupyter_ros(given: str, series: list[str]) -> None:
    import jupyros

    assert jupyros.live_plot(given).options["series"] == series


def test_a_panel_tells_its_type_and_shows_text_elsewhere() -> None:
    from jupyros.ros2 import Publisher

    bundle = Publisher(None, Twist, "cmd_vel").display()._repr_mimebundle_()
    assert bundle["application/vnd.sitegen.panel+json"] == {
        "kind": "publish",
        "options": {"topic": "/cmd_vel", "type": "geometry_msgs/msg/Twist"},
    }
    assert "publish" in bundle["text/plain"]


def test_a_callback_needs_a_node() -> None:
    import jupyros

    with pytest.raises(ValueError, match="a callback needs a node"):
        jupyros.subscribe("/a", Twist, print)


def test_records_of_bags_are_found(tmp_path: Path) -> None:
    from jupyros import bags

    sent = [("/words", STRING, {"data": f"w{number}"}, 50.0 * number) for number in (3, 1, 2)]
    file = write_bag(tmp_path / "a.mcap", sent, CompressionType.NONE)
    types: dict[int, str] = {}
    channels: dict[int, bags._Channel] = {}
    found: list[tuple[int, int, memoryview]] = []
    for kind, content in bags._records(memoryview(file.read_bytes())[len(bags.MAGIC) :]):
        bags._take(kind, content, types, channels, found)
    assert [one.topic for one in channels.values()] == ["/words"]
    assert [one.type for one in channels.values()] == ["std_msgs/msg/String"]
    assert [bytes(data)[8:10] for _, _, data in found] == [b"w3", b"w1", b"w2"]
    with pytest.raises(ValueError, match="not a bag in MCAP"):
        next(bags.bag(b"SQLite format 3"))
