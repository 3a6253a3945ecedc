"""Bags that other libraries wrote, played to real nodes and panels."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from bags import DRIVE, START, STRING, drive, player, spiral, write_bag
from browser import opened
from mcap.writer import CompressionType
from panel import Panel
from paths import DEMOS
from playwright.sync_api import Browser, Route, expect
from playwright.sync_api import Page as Tab
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore

pytestmark = pytest.mark.firefox


@pytest.fixture
def page(browser: Browser, bag_pages: str) -> Iterator[Tab]:
    with opened(browser) as tab:
        tab.goto(bag_pages)
        expect(player(tab).locator(".ros-bag-row")).to_have_count(3)
        yield tab


def press(tab: Tab, name: str) -> None:
    player(tab).get_by_role("button", name=name, exact=True).click()


def seek(tab: Tab, seconds: float) -> None:
    player(tab).get_by_role("slider").fill(str(seconds))


def heard(panel: Panel, what: str = "word") -> list[str]:
    """What the node heard, without when."""
    found = [re.fullmatch(rf"{what} '(.*)' at [\d.]+", one) for one in panel.messages()]
    return [one[1] for one in found if one]


def test_a_bag_of_the_site_is_played_in_order_to_a_node(page: Tab) -> None:
    panel = Panel(page, "hears")
    panel.expect_started()
    summary = player(page).locator(".ros-bar .ros-type")
    expect(summary).to_contain_text("0:05.9 · 151 messages")
    press(page, "Play")
    panel.wait_for("bag 119")
    assert heard(panel) == [f"bag {number}" for number in range(120)]
    assert heard(panel, "latched") == ["an old map"]
    expect(player(page).get_by_role("button", name="Play", exact=True)).to_be_enabled()
    expect(player(page).locator(".ros-bag-time")).to_have_text("0:05.9 / 0:05.9")


def test_a_panel_shows_a_type_that_no_node_knows(page: Tab) -> None:
    topics = page.locator(".ros-topics")
    topics.get_by_role("button", name="/places").click()
    press(page, "Play")
    expect(topics).to_contain_text("Küche")
    press(page, "Pause")


def test_steps_seeks_and_latched_messages(page: Tab) -> None:
    panel = Panel(page, "hears")
    panel.expect_started()
    seek(page, 3.001)
    panel.wait_for("an old map")
    press(page, "Step")
    press(page, "Step")
    panel.wait_for("bag 61")
    assert heard(panel)[-1] == "bag 61"
    expect(player(page).locator(".ros-bag-time")).to_have_text("0:03.0 / 0:05.9")
    assert heard(panel) in (["bag 61"], ["bag 60", "bag 61"])


def test_topics_are_left_out_and_the_rate_is_kept(page: Tab) -> None:
    panel = Panel(page, "hears")
    panel.expect_started()
    player(page).get_by_role("checkbox", name="/latched").uncheck()
    player(page).get_by_label("Speed").select_option("10")
    seek(page, 0)
    press(page, "Play")
    panel.wait_for("bag 119")
    times = [float(one.rpartition(" ")[2]) for one in panel.messages() if "bag" in one]
    assert 0.3 < times[-1] - times[0] < 3
    assert heard(panel, "latched") == []


def test_sim_time_names_and_loops(browser: Browser, bag_pages: str) -> None:
    with opened(browser) as tab:
        tab.goto(f"{bag_pages}clock/")
        panel = Panel(tab, "hears_later", region="hears_later")
        panel.expect_started()
        expect(player(tab).locator(".ros-bag-row")).to_have_count(3)
        expect(player(tab).get_by_role("checkbox", name="/latched")).to_be_disabled()
        press(tab, "Play")
        panel.wait_for("said 'bag 119'")
        panel.wait_for("said 'bag 0'")
        said = [one for one in panel.messages() if one.startswith("said 'bag 100'")]
        # Its clock is that of the bag.
        assert abs(float(said[0].rpartition(" ")[2]) - (START / 1e9 + 5)) < 0.2
        press(tab, "Pause")


@pytest.mark.parametrize("compression", [CompressionType.NONE, CompressionType.LZ4])
def test_a_file_of_the_visitor_is_played(
    page: Tab, tmp_path: Path, compression: CompressionType
) -> None:
    panel = Panel(page, "hears")
    panel.expect_started()
    sent = [
        ("/words", STRING, {"data": f"own {number} {'x' * 300}"}, number) for number in range(90)
    ]
    own = write_bag(tmp_path / "own.mcap", sent, compression)
    player(page).locator("input[type=file]").set_input_files(own)
    expect(player(page).locator(".ros-name").first).to_have_text("own.mcap")
    expect(player(page).locator(".ros-bag-row")).to_have_count(1)
    press(page, "Play")
    panel.wait_for("own 89")
    assert [one.split()[1] for one in heard(panel)] == [str(number) for number in range(90)]


@contextmanager
def ranges(page: Tab, content: bytes) -> Iterator[list[tuple[int, int]]]:
    """Answer for the bag of the site as a server with ranges does; note what is asked for."""
    asked: list[tuple[int, int]] = []

    def answer(route: Route) -> None:
        first, _, last = route.request.headers["range"].removeprefix("bytes=").partition("-")
        part = content[int(first) : int(last) + 1]
        asked.append((int(first), int(first) + len(part)))
        span = f"bytes {first}-{int(first) + len(part) - 1}/{len(content)}"
        route.fulfill(status=206, body=part, headers={"Content-Range": span})

    page.route(re.compile(r"drive\..*\.mcap"), answer)
    page.reload()
    yield asked


def test_a_server_is_asked_for_parts(page: Tab, tmp_path: Path) -> None:
    noise = random.Random(2).randbytes(900_000).hex()
    sent = [("/words", STRING, {"data": f"large {n} {noise}"}, 10_000 * n) for n in range(30)]
    bag = write_bag(tmp_path / "large.mcap", sent, CompressionType.NONE).read_bytes()
    size = len(bag)
    assert size > 50_000_000
    with ranges(page, bag) as asked:
        expect(player(page).locator(".ros-bag-row")).to_have_count(1)
        panel = Panel(page, "hears")
        panel.expect_started()
        # To play, the first messages are read ahead; all others stay where they are.
        press(page, "Step")
        panel.wait_for("large 0")
        assert sum(last - first for first, last in asked) < size / 2
        seek(page, 250)
        press(page, "Step")
        panel.wait_for("large 25")
        assert all(one.startswith(("large 0 ", "large 25 ")) for one in heard(panel))
    small = DRIVE.read_bytes()
    with ranges(page, small) as asked:
        expect(player(page).locator(".ros-bag-row")).to_have_count(3)
        # A small one comes with the first request.
        assert asked[-1] == (0, len(small))


def test_what_rosbags_wrote_is_played(page: Tab, tmp_path: Path) -> None:
    folder = tmp_path / "bag"
    store = get_typestore(Stores.ROS2_JAZZY)
    text = store.types["std_msgs/msg/String"]
    with Writer(folder, version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        words = writer.add_connection("/words", "std_msgs/msg/String", typestore=store)
        for number in range(50):
            data = store.serialize_cdr(text(data=f"rosbags {number}"), "std_msgs/msg/String")
            writer.write(words, START + number * 10_000_000, data)
    panel = Panel(page, "hears")
    panel.expect_started()
    [file] = folder.glob("*.mcap")
    player(page).locator("input[type=file]").set_input_files(file)
    expect(player(page).locator(".ros-bag-row")).to_have_count(1)
    press(page, "Play")
    panel.wait_for("rosbags 49")
    assert heard(panel) == [f"rosbags {number}" for number in range(50)]


def test_a_bag_is_dropped_on_the_page(page: Tab, tmp_path: Path) -> None:
    sent = [("/words", STRING, {"data": "dropped"}, 0)]
    content = write_bag(tmp_path / "own.mcap", sent).read_bytes()
    page.evaluate(
        """(bytes) => {
          const dataTransfer = new DataTransfer();
          dataTransfer.items.add(new File([new Uint8Array(bytes)], "dropped.mcap"));
          const panel = document.querySelector(".ros-bag");
          for (const kind of ["dragover", "drop"]) {
            const about = { dataTransfer, bubbles: true, cancelable: true };
            panel.dispatchEvent(new DragEvent(kind, about));
          }
        }""",
        list(content),
    )
    expect(player(page).locator(".ros-name").first).to_have_text("dropped.mcap")
    expect(player(page).locator(".ros-bag-row")).to_have_count(1)
    press(page, "Step")
    Panel(page, "hears").wait_for("dropped")


def test_publishers_offer_what_was_recorded(page: Tab) -> None:
    found = page.evaluate(
        """async () => {
          const { ros } = await import(document.querySelector("script[type=module]").src);
          return ros.graph.endpoints().filter(({ node }) => node === "/rosbag2_player").map(
            ({ name, qos }) => [name, qos.reliable, qos.transientLocal, qos.depth]);
        }"""
    )
    assert sorted(found) == [
        ["/latched", True, True, 1],
        ["/places", True, False, 10],
        ["/words", True, False, 10],
    ]


def test_without_its_worker_a_player_says_so(browser: Browser, bag_pages: str) -> None:
    context = browser.new_context()
    context.route(re.compile("bagNode"), lambda route: route.abort())
    tab = context.new_page()
    tab.goto(bag_pages)
    said = "A part of this page could not be loaded; check the connection to the site."
    expect(player(tab).get_by_role("status")).to_have_text(said)
    context.close()


def test_the_bags_of_the_repository_are_what_they_say(tmp_path: Path) -> None:
    assert write_bag(tmp_path / "drive.mcap", drive()).read_bytes() == DRIVE.read_bytes()
    own = write_bag(tmp_path / "spiral.mcap", spiral(), chunk_size=1 << 20)
    assert own.read_bytes() == (DEMOS / "demo12/bags/spiral.mcap").read_bytes()
