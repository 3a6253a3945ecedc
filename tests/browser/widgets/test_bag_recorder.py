"""What a page records, read by the libraries of others, message by message."""

from __future__ import annotations

import io
import json
import re
import tarfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any, cast

import pytest
from bags import DRIVE, recorder
from browser import opened
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from panel import Panel
from playwright.sync_api import Browser, Request, expect
from playwright.sync_api import Page as Tab
from rosbags.highlevel import AnyReader
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from waiting import until

# Who publishes what the visitor does.
TOPICS = """async () => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  return ros.graph.topics().map(({ name }) => name).filter((name) => name.startsWith("/_page"));
}"""


@pytest.fixture
def page(browser: Browser, bag_pages: str) -> Iterator[Tab]:
    with opened(browser) as tab:
        tab.goto(f"{bag_pages}record/")
        Panel(tab, "sends").wait_for("sent 3")
        yield tab


def press(tab: Tab, name: str) -> None:
    recorder(tab).get_by_role("button", name=name, exact=True).click()


def record(tab: Tab) -> None:
    """Record until there are some messages, and stop."""
    press(tab, "Record")
    expect(recorder(tab).get_by_role("status").first).to_have_text(
        re.compile(r"Recording .* of at most .* (?:[6-9]\d|\d{3}) messages")
    )
    press(tab, "Stop")
    expect(recorder(tab).get_by_role("status").first).to_contain_text("Recorded: ")


def recorded(tab: Tab) -> int:
    """The number of messages that the recorder shows while it records."""
    [count] = re.findall(r"(\d+) messages", recorder(tab).get_by_role("status").first.inner_text())
    return int(count)


def save(tab: Tab, folder: Path, name: str = "Save") -> Path:
    with tab.expect_download() as download:
        entry = recorder(tab).get_by_role("listitem").first
        entry.get_by_role("button", name=re.compile(rf"^{name} rosbag2")).click()
    path = folder / download.value.suggested_filename
    download.value.save_as(path)
    return path


def call(tab: Tab, service: str, kind: str, request: dict[str, Any]) -> None:
    tab.evaluate(
        """async (call) => {
          const { ros } = await import(document.querySelector("script[type=module]").src);
          await ros.call(...call);
        }""",
        [service, kind, request],
    )


def read(path: Path, topic: str) -> list[Any]:
    """The decoded messages of a topic."""
    with path.open("rb") as stream:
        reader = make_reader(stream, decoder_factories=[DecoderFactory()])
        return [one[3] for one in reader.iter_decoded_messages(topics=[topic])]


def words(path: Path) -> list[str]:
    return [one.data for one in read(path, "/words")]


def rename(tab: Tab, name: str, key: str = "Enter") -> None:
    entry = recorder(tab).get_by_role("listitem").first
    entry.get_by_role("button", name="Rename").click()
    field = entry.get_by_role("textbox", name="Name of the recording")
    field.fill(name)
    field.press(key)


def test_a_recording_gets_another_name(page: Tab) -> None:
    record(page)
    record(page)
    expect(recorder(page).locator(".ros-bag-entry")).to_have_count(2)
    first = recorder(page).locator(".ros-bag-entry .ros-name").first
    said = recorder(page).locator(".ros-bag-recordings .ros-note")
    before = first.inner_text()
    rename(page, "Fahrt 2 (gut)", key="Escape")
    expect(first).to_have_text(before)
    rename(page, "Fahrt 2 (gut)")
    expect(first).to_have_text("Fahrt 2 (gut).mcap")
    renamed = recorder(page).get_by_role("button", name="Rename Fahrt 2 (gut).mcap")
    expect(renamed).to_be_focused()
    for wrong, why in [("a/b", "A name begins with"), ("", "A name begins with")]:
        rename(page, wrong)
        expect(said).to_contain_text(why)
        recorder(page).get_by_role("textbox").press("Escape")
        expect(said).to_have_text("")
    other = recorder(page).locator(".ros-bag-entry .ros-name").last.inner_text()
    rename(page, other)
    expect(said).to_have_text("Another recording has this name.")
    # Whoever goes on elsewhere keeps the old name.
    recorder(page).get_by_role("textbox").blur()
    expect(first).to_have_text("Fahrt 2 (gut).mcap")
    page.reload()
    expect(recorder(page).locator(".ros-bag-entry .ros-name")).to_have_count(2)
    expect(recorder(page).get_by_text("Fahrt 2 (gut).mcap", exact=True)).to_be_visible()


def test_each_message_is_in_the_bag_once_and_in_order(page: Tab, tmp_path: Path) -> None:
    record(page)
    bag = save(page, tmp_path)
    found = words(bag)
    first = int(found[0].removeprefix("word "))
    assert len(found) >= 10
    assert found == [f"word {first + number}" for number in range(len(found))]
    [latched] = read(bag, "/latched")
    assert latched.data == "a map"
    poses = read(bag, "/poses")
    assert all(pose.pose.position.x == 0.5 * pose.header.stamp.sec for pose in poses)
    assert {pose.header.frame_id for pose in poses} == {"map"}
    with bag.open("rb") as stream:
        reader = make_reader(stream, validate_crcs=True)
        summary = reader.get_summary()
        assert summary and summary.statistics
        assert reader.get_header().profile == "ros2"
        assert {chunk.compression for chunk in summary.chunk_indexes} == {"zstd"}
        times = [message.log_time for _, _, message in reader.iter_messages()]
        assert times == sorted(times)
        assert summary.statistics.message_count == len(times)
        assert summary.statistics.message_start_time == times[0]
        assert summary.statistics.message_end_time == times[-1]


def test_rosbags_reads_it_and_the_folder_with_the_policies(page: Tab, tmp_path: Path) -> None:
    record(page)
    bag = save(page, tmp_path)
    packed = save(page, tmp_path, "Save as folder")
    with tarfile.open(packed) as archive:
        archive.extractall(tmp_path, filter="data")
    folder = packed.with_suffix("")
    for path in (bag, folder):
        with AnyReader([path]) as reader:
            by_topic = {one.topic: one for one in reader.connections}
            assert {"/words", "/poses", "/latched", "/rosout"} <= set(by_topic)
            qos = {name: one.ext.offered_qos_profiles[0] for name, one in by_topic.items()}  # type: ignore[union-attr]
            assert qos["/latched"].durability.name == "TRANSIENT_LOCAL"
            assert qos["/latched"].depth == 1
            assert qos["/poses"].reliability.name == "BEST_EFFORT"
            assert qos["/words"].reliability.name == "RELIABLE"
            assert by_topic["/poses"].msgtype == "geometry_msgs/msg/PoseStamped"
            texts = [
                reader.deserialize(data, one.msgtype).data  # type: ignore[attr-defined]
                for one, _, data in reader.messages()
                if one.topic == "/words"
            ]
            assert texts == words(bag)


def test_events_of_services_are_recorded_on_request(page: Tab, tmp_path: Path) -> None:
    recorder(page).get_by_text("All topics").click()
    recorder(page).get_by_label("Hidden topics").check()
    recorder(page).get_by_role("checkbox", name="/poses").uncheck()
    press(page, "Record")
    expect(recorder(page).get_by_role("status").first).to_contain_text("on 4 topics")
    call(page, "/switch", "std_srvs/srv/SetBool", {"data": True})
    count = recorded(page)
    until(lambda: recorded(page) > count + 5)
    press(page, "Stop")
    expect(recorder(page).get_by_role("status").first).to_contain_text("Recorded: ")
    bag = save(page, tmp_path)
    assert read(bag, "/poses") == []
    # Both libraries know messages only, so the schema is given the name of one.
    with bag.open("rb") as stream:
        events = [*make_reader(stream).iter_messages(topics=["/switch/_service_event"])]
    schema = events[0][0]
    assert schema
    assert schema.name == "std_srvs/srv/SetBool_Event"
    name = "std_srvs/msg/SetBool_Event"
    types = get_types_from_msg(schema.data.decode(), name)
    store = get_typestore(Stores.EMPTY)
    store.register(types)
    received, sent = (cast(Any, store.deserialize_cdr(one[2].data, name)) for one in events)
    assert [one.info.event_type for one in (received, sent)] == [1, 2]
    assert received.request[0].data is True
    assert sent.response[0].message == "switched"


def test_what_was_recorded_is_played_again_byte_by_byte(page: Tab, tmp_path: Path) -> None:
    record(page)
    first = save(page, tmp_path)
    page.get_by_role("region", name="sends", exact=True).get_by_role("button", name="Stop").click()
    entry = recorder(page).get_by_role("listitem").first
    entry.get_by_role("button", name=re.compile("^Open ")).click()
    player = page.get_by_role("region", name="Player", exact=True)
    expect(player.locator(".ros-bag-row")).not_to_have_count(0)
    press(page, "Record")
    expect(recorder(page).get_by_role("status").first).to_contain_text("on 4 topics")
    player.get_by_role("button", name="Play", exact=True).click()
    expect(player.get_by_role("button", name="Pause", exact=True)).to_be_visible()
    expect(player.get_by_role("button", name="Play", exact=True)).to_be_visible()
    count = sum(map(len, contents(first).values()))
    until(lambda: recorded(page) >= count)
    press(page, "Stop")
    expect(recorder(page).get_by_role("listitem")).to_have_count(2)
    second = save(page, tmp_path)
    assert second != first
    assert contents(second) == contents(first)


def contents(path: Path) -> dict[str, list[bytes]]:
    """The messages of a bag by topic."""
    with path.open("rb") as stream:
        found: dict[str, list[bytes]] = {}
        for _, channel, message in make_reader(io.BytesIO(stream.read())).iter_messages():
            found.setdefault(channel.topic, []).append(message.data)
        return found


def test_what_visitors_do_is_logged_after_they_agreed(
    browser: Browser, bag_pages: str, tmp_path: Path
) -> None:
    with opened(browser) as tab:
        asked: list[Request] = []
        tab.on("request", lambda request: asked.append(request))
        tab.goto(f"{bag_pages}study/")
        expect(recorder(tab)).to_contain_text("May we see what you do?")
        expect(recorder(tab)).to_contain_text("Nothing is sent")
        panel = Panel(tab, "sends")
        panel.start()
        panel.wait_for("sent 1")
        assert tab.evaluate(TOPICS) == []
        press(tab, "Agree and record")
        expect(recorder(tab).get_by_role("status").first).to_contain_text("on 2 topics")
        form = tab.get_by_role("region", name="Publish", exact=True)
        form.get_by_label("data string").fill("by hand")
        form.get_by_role("button", name="Publish once").click()
        panel.stop()
        press(tab, "Stop")
        expect(recorder(tab).get_by_role("status").first).to_contain_text("Recorded: ")
        assert tab.evaluate(TOPICS) == []
        bag = save(tab, tmp_path)
    assert {request.method for request in asked} == {"GET"}
    assert all(request.url.startswith((bag_pages, "blob:")) for request in asked)
    assert "by hand" in words(bag)
    actions = [json.loads(one.data) for one in read(bag, "/_page/actions")]
    assert actions == [
        {"action": "set", "panel": "Publish", "control": "data string", "value": "by hand"},
        {"action": "press", "panel": "Publish", "control": "Publish once"},
        {"action": "press", "panel": "sends", "control": "Stop"},
        {"action": "state", "node": "sends", "state": "stopping"},
        {"action": "state", "node": "sends", "state": "stopped"},
    ]


def test_a_recording_ends_at_its_limit(browser: Browser, bag_pages: str) -> None:
    with opened(browser) as tab:
        tab.goto(f"{bag_pages}study/")
        press(tab, "Agree and record")
        expect(recorder(tab).get_by_role("status").first).to_contain_text("of at most 1.0 MB")
        tab.evaluate(
            """async () => {
              const { ros } = await import(document.querySelector("script[type=module]").src);
              const publisher = ros.advertise("/words", "std_msgs/msg/String");
              const random = () => Array.from(crypto.getRandomValues(new Uint8Array(60000)), (n) => n % 94);
              for (let count = 0; count < 60; count++) {
                publisher.publish({ data: String.fromCharCode(...random().map((n) => n + 33)) });
                await new Promise((done) => setTimeout(done, 30));
              }
              publisher.close();
            }"""  # noqa: E501
        )
        said = "The recording has reached its limit of 1 MB."
        expect(recorder(tab).get_by_role("status").first).to_have_text(said)
        size = re.compile(r" ?([6-9]\d\d\.\d kB|1\.0 MB)")
        expect(recorder(tab).get_by_role("listitem").locator(".ros-type")).to_have_text(size)


def test_types_that_a_bag_brought_are_recorded_with_it(page: Tab, tmp_path: Path) -> None:
    player = page.get_by_role("region", name="Player", exact=True)
    press(page, "Record")
    expect(recorder(page).get_by_role("status").first).to_contain_text("on 4 topics")
    player.locator("input[type=file]").set_input_files(DRIVE)
    expect(recorder(page).get_by_role("status").first).to_contain_text("on 5 topics")
    player.get_by_label("Speed").select_option("10")
    player.get_by_role("button", name="Play", exact=True).click()
    expect(player.locator(".ros-bag-time")).to_have_text("0:05.9 / 0:05.9")
    count = recorded(page)
    until(lambda: recorded(page) > count + 5)
    press(page, "Stop")
    expect(recorder(page).get_by_role("status").first).to_contain_text("Recorded: ")
    places = read(save(page, tmp_path), "/places")
    assert len(places) == 30
    assert [one.text for one in places[7].names] == ["kitchen", "Küche"]
    assert places[7].x == 2.8
