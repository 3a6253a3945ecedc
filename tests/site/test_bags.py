"""Bags that pages cannot read are converted when the site is built."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import pytest
from bags import LATCHED, PLACE, START, STRING, drive, write_bag
from rosbags.highlevel import AnyReader
from rosbags.interfaces import Qos
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from sitegen.config import load
from sitegen.errors import SiteError
from sitegen.model import Artifact
from sitegen.site import offline
from sitegen.site.bags import Bags, bags
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


def found(folder: Path, name: str) -> Bags:
    (folder / "site.yaml").write_text(SITE.replace("NAME", name))
    site = load(folder / "site.yaml")
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
