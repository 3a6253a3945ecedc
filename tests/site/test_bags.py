"""Bags that pages cannot read are converted when the site is built."""

from __future__ import annotations

import importlib.util
import io
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bags import LATCHED, PLACE, START, STRING, drive, write_bag
from rosbags.highlevel import AnyReader
from rosbags.interfaces import Qos
from rosbags.rosbag1 import Writer as Ros1Writer
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from rosbags.typesys.store import Typestore

from sitegen.config import load
from sitegen.errors import SiteError
from sitegen.model import Artifact
from sitegen.report import Report
from sitegen.site import offline
from sitegen.site.bags import Bags, bags, convert
from sitegen.site.offline import worker

SITE = """
site: {title: Bags}
pages:
  - {path: /, content: [{markdown: "# A"}, {bag: NAME}]}
"""


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "cache"
    monkeypatch.setenv("SITEGEN_CACHE", str(folder))
    return folder


def found(folder: Path, name: str, report: Report | None = None) -> Bags:
    (folder / "site.yaml").write_text(SITE.replace("NAME", name))
    site = load(folder / "site.yaml")
    convert(site, report or Report(io.StringIO()))
    return bags(site, site.pages[0])


def write_folder(folder: Path, plugin: StoragePlugin = StoragePlugin.SQLITE3) -> Path:
    """Write the drive as rosbag2 does: a folder with a metadata.yaml."""
    store = get_typestore(Stores.EMPTY)
    for name, text in (STRING, PLACE):
        store.register(get_types_from_msg(text, name))
    with Writer(folder, version=9, storage_plugin=plugin) as writer:
        connections = {
            topic: writer.add_connection(
                topic,
                kind[0],
                typestore=store,
                offered_qos_profiles=profiles if topic == "/latched" else (),
            )
            for profiles in [latched_profiles()]
            for topic, kind in {one[0]: one[1] for one in drive()}.items()
        }
        for topic, kind, content, time in drive():
            message = made(store.types, kind[0], content)
            data = store.serialize_cdr(message, kind[0])
            writer.write(connections[topic], START + int(time * 1e6), data)
    return folder


def latched_profiles() -> tuple[Qos, ...]:
    from rosbags.rosbag2.metadata import parse_qos
    from ruamel.yaml import YAML

    return tuple(parse_qos(YAML(typ="safe").load(LATCHED)))


def made(types: dict[str, type], name: str, content: dict[str, object]) -> object:
    if name == "std_msgs/msg/String":
        return types[name](**content)
    names = [types["far_msgs/msg/Name"](**one) for one in content["names"]]  # type: ignore[attr-defined]
    return types[name](x=content["x"], names=names)


def contents(path: Path) -> list[tuple[str, int, bytes]]:
    with AnyReader([path]) as reader:
        return [(one.topic, time, bytes(data)) for one, time, data in reader.messages()]


def test_a_file_is_copied_as_it_is(tmp_path: Path) -> None:
    own = write_bag(tmp_path / "bags/drive one.mcap", drive())
    one = found(tmp_path, "bags/drive one.mcap")
    [artifact] = one.artifacts
    assert artifact.source == own
    assert list(one.paths) == ["bags/drive one.mcap"]
    assert artifact.path.startswith("bags/drive-one.")
    assert artifact.path.endswith(".mcap")


def test_the_only_file_of_a_folder_is_copied_as_it_is(tmp_path: Path) -> None:
    folder = write_folder(tmp_path / "drive", StoragePlugin.MCAP)
    [artifact] = found(tmp_path, "drive").artifacts
    assert artifact.source == next(folder.glob("*.mcap"))


def test_a_sqlite_bag_is_converted_once(tmp_path: Path, cache: Path) -> None:
    folder = write_folder(tmp_path / "drive")
    [artifact] = found(tmp_path, "drive").artifacts
    assert isinstance(artifact.source, Path)
    assert artifact.source.is_relative_to(cache)
    assert contents(artifact.source) == contents(folder)
    assert len(contents(folder)) == 151
    with AnyReader([artifact.source]) as reader:
        by_topic = {one.topic: one for one in reader.connections}
        assert {name: one.msgtype for name, one in by_topic.items()} == {
            "/latched": "std_msgs/msg/String",
            "/words": "std_msgs/msg/String",
            "/places": "far_msgs/msg/Place",
        }
        [qos] = by_topic["/latched"].ext.offered_qos_profiles  # type: ignore[union-attr]
        assert (qos.durability.name, qos.depth) == ("TRANSIENT_LOCAL", 1)
    time = artifact.source.stat().st_mtime_ns
    [again] = found(tmp_path, "drive").artifacts
    assert again == artifact
    assert artifact.source.stat().st_mtime_ns == time


# Of its own package, and around a type of ROS 1 that ROS 2 has changed.
OWN = """Header header
time when
far_msgs/Spot[] spots
visualization_msgs/Marker marker
================================================================================
MSG: far_msgs/Spot
float64 x
"""


def write_ros1(path: Path, compression: Ros1Writer.CompressionFormat | None = None) -> Path:
    """Write a bag of ROS 1: a latched topic, and types that ROS 2 has, lacks or has changed."""
    store = get_typestore(Stores.ROS1_NOETIC)
    store.register(get_types_from_msg(OWN, "far_msgs/msg/Own"))
    types = store.types
    time = types["builtin_interfaces/msg/Time"]
    header = types["std_msgs/msg/Header"](seq=7, stamp=time(sec=5, nanosec=6), frame_id="map")
    camera = default(store, "sensor_msgs/msg/CameraInfo")
    camera.header, camera.height, camera.D = header, 480, np.array([0.5, 0.25])
    marker = default(store, "visualization_msgs/msg/Marker")
    marker.header, marker.text = header, "a cube"
    own = types["far_msgs/msg/Own"](
        header=header,
        when=time(sec=8, nanosec=9),
        spots=[types["far_msgs/msg/Spot"](x=1.5)],
        marker=marker,
    )
    sent = [
        ("/latched", types["std_msgs/msg/String"](data="an old map"), True),
        ("/camera_info", camera, False),
        ("/own", own, False),
        *(("/words", types["std_msgs/msg/String"](data=f"word {n}"), False) for n in range(50)),
    ]
    writer = Ros1Writer(path)
    if compression:
        writer.set_compression(compression)
    with writer:
        connections: dict[str, Any] = {}
        for number, (topic, message, latched) in enumerate(sent):
            connections[topic] = connections.get(topic) or writer.add_connection(
                topic, message.__msgtype__, typestore=store, latching=int(latched)
            )
            data = store.serialize_ros1(message, message.__msgtype__)
            writer.write(connections[topic], START + number * 1_000_000, data)
    return path


def test_a_bag_of_ros_1_gets_the_types_of_ros_2(tmp_path: Path) -> None:
    report = Report(io.StringIO())
    write_ros1(tmp_path / "old.bag")
    [artifact] = found(tmp_path, "old.bag", report).artifacts
    assert isinstance(artifact.source, Path)
    assert report.said == [
        "old.bag: these types have other fields in ROS 2, and only what both have is kept: "
        "visualization_msgs/Marker"
    ]
    with AnyReader([artifact.source]) as reader:
        connections: list[Any] = reader.connections
        qos = {one.topic: one.ext.offered_qos_profiles for one in connections}
        assert [one.durability.name for one in qos["/latched"]] == ["TRANSIENT_LOCAL"]
        assert qos["/words"] == []
        read: list[Any] = [
            (one.topic, time, reader.deserialize(data, one.msgtype))
            for one, time, data in reader.messages()
        ]
        own = reader.typestore.fielddefs
    current = get_typestore(Stores.LATEST).fielddefs
    for name in (
        "std_msgs/msg/Header",
        "sensor_msgs/msg/CameraInfo",
        "visualization_msgs/msg/Marker",
    ):
        assert own[name][1] == current[name][1]
    assert [time for _, time, _ in read] == [START + n * 1_000_000 for n in range(53)]
    by_topic = {topic: message for topic, _, message in read}
    assert by_topic["/words"].data == "word 49"
    assert by_topic["/latched"].data == "an old map"
    camera, message = by_topic["/camera_info"], by_topic["/own"]
    assert (camera.header.stamp.sec, camera.header.frame_id) == (5, "map")
    assert (camera.height, list(camera.d)) == (480, [0.5, 0.25])
    assert (message.when.sec, message.spots[0].x, message.marker.text) == (8, 1.5, "a cube")
    # The next build says it again, and converts nothing.
    again = Report(io.StringIO())
    assert found(tmp_path, "old.bag", again).artifacts == [artifact]
    assert again.said == report.said


@pytest.mark.parametrize("compression", list(Ros1Writer.CompressionFormat))
def test_a_bag_of_ros_1_may_be_compressed(
    tmp_path: Path, compression: Ros1Writer.CompressionFormat
) -> None:
    write_ros1(tmp_path / "old.bag", compression)
    [artifact] = found(tmp_path, "old.bag").artifacts
    assert isinstance(artifact.source, Path)
    assert len(contents(artifact.source)) == 53


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda content: content[: len(content) // 2], "cannot be converted: "),
        (lambda _: b"", "cannot be converted: "),
        (lambda _: b"#ROSBAG V1.2\n" + bytes(100), "cannot be converted: "),
    ],
    ids=["cut", "empty", "old"],
)
def test_a_damaged_bag_of_ros_1_is_one_line(
    tmp_path: Path, change: Callable[[bytes], bytes], said: str
) -> None:
    bag = write_ros1(tmp_path / "old.bag")
    bag.write_bytes(change(bag.read_bytes()))
    with pytest.raises(SiteError) as wrong:
        found(tmp_path, "old.bag")
    [line] = wrong.value.lines
    assert line.startswith(f"site.yaml:4: bag.file: 'old.bag' {said}")
    assert str(tmp_path) not in line


def default(store: Typestore, name: str) -> Any:
    """Return a message whose fields are zero, empty or false."""
    from rosbags.convert.converter import default_message

    return default_message(store, name)


def test_without_rosbags_it_is_said_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_folder(tmp_path / "drive")
    monkeypatch.setattr(importlib.util, "find_spec", lambda _: None)
    with pytest.raises(SiteError) as wrong:
        found(tmp_path, "drive")
    assert wrong.value.lines == [
        "site.yaml:4: bag.file: 'drive' is not a single .mcap file; "
        "to convert it, install 'ros-sitegen[bags]'"
    ]


def test_a_damaged_bag_is_one_line(tmp_path: Path) -> None:
    folder = write_folder(tmp_path / "drive")
    database = next(folder.glob("*.db3"))
    database.write_bytes(database.read_bytes()[:3000])
    with pytest.raises(SiteError) as wrong:
        found(tmp_path, "drive")
    assert wrong.value.lines == [
        "site.yaml:4: bag.file: 'drive' cannot be converted: "
        "Cannot open database drive.db3: database disk image is malformed"
    ]


def test_only_small_bags_are_kept_for_when_there_is_no_network(tmp_path: Path) -> None:
    (tmp_path / "site.yaml").write_text(
        "site: {title: A, offline: true}\npages: [{path: /, content: [{markdown: '# A'}]}]\n"
    )
    site = load(tmp_path / "site.yaml")
    large = tmp_path / "large.mcap"
    with large.open("wb") as stream:
        stream.truncate(worker.WHOLE + 1)
    made = [
        *(Artifact("index.html", b"<p>"), Artifact("bags/small.mcap", b"small")),
        Artifact("bags/large.mcap", large),
    ]
    [script] = offline.artifacts(site, made)
    assert isinstance(script.source, bytes)
    assert b"bags/small.mcap" in script.source
    assert b"bags/large.mcap" not in script.source
