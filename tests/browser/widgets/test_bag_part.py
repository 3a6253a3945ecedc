"""Parts of bags: played, linked to, and saved as bags that the libraries of others read."""

from __future__ import annotations

import base64
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, cast

import pytest
from bags import START, STRING, player, write_bag
from browser import opened
from mcap.reader import make_reader
from mcap.writer import Writer
from panel import Panel
from playwright.sync_api import Browser, Locator, expect
from playwright.sync_api import Page as Tab
from rosbags.highlevel import AnyReader
from rosbags.typesys import Stores, get_typestore
from waiting import until

pytestmark = pytest.mark.firefox


@pytest.fixture
def page(browser: Browser, bag_pages: str) -> Iterator[Tab]:
    with opened(browser) as tab:
        tab.goto(bag_pages)
        Panel(tab, "hears").expect_started()
        expect(player(tab).locator(".ros-bag-row")).to_have_count(3)
        yield tab


def button(tab: Tab, name: str) -> Locator:
    return player(tab).get_by_role("button", name=name, exact=True)


def open_part(tab: Tab) -> None:
    player(tab).get_by_text("Play or save a part").click()


def limit(tab: Tab, name: str) -> Locator:
    return player(tab).get_by_label(f"{name} (s)")


def enter(tab: Tab, name: str, seconds: str) -> None:
    # Typed: Firefox takes what a script fills in for no change.
    limit(tab, name).press("Control+a")
    limit(tab, name).press_sequentially(seconds)
    limit(tab, name).press("Enter")


def expect_part(tab: Tab, text: str) -> None:
    expect(player(tab).locator(".ros-bag-part summary")).to_have_text(text)


def expect_time(tab: Tab, text: str) -> None:
    expect(player(tab).locator(".ros-bag-time")).to_have_text(f"{text} / 0:05.9")


def seek(tab: Tab, seconds: float) -> None:
    player(tab).get_by_role("slider", name="Time").fill(str(seconds))
    expect_time(tab, f"0:0{seconds:.1f}")


def heard(panel: Panel) -> list[int]:
    """The numbers of the words that the node heard."""
    found = [re.match(r"word 'bag (\d+)'", one) for one in panel.messages()]
    return [int(one[1]) for one in found if one]


def test_the_author_names_a_part_and_its_topics(browser: Browser, bag_pages: str) -> None:
    with opened(browser) as tab:
        tab.goto(f"{bag_pages}part/")
        panel = Panel(tab, "hears")
        panel.expect_started()
        expect_part(tab, "Part: 0:02.0 to 0:03.5")
        expect_time(tab, "0:02.0")
        expect(player(tab).get_by_role("checkbox", name="/places")).not_to_be_checked()
        expect(player(tab).get_by_role("checkbox", name="/places")).to_be_disabled()
        button(tab, "Play").click()
        panel.wait_for("bag 70")
        expect_time(tab, "0:03.5")
        expect(button(tab, "Play")).to_be_visible()
        assert heard(panel) == [*range(40, 71)]
        assert any("an old map" in one for one in panel.messages())
        # After its end, it begins anew.
        button(tab, "Step").click()
        panel.wait_for("bag 71")
        player(tab).get_by_text("Part: 0:02.0 to 0:03.5").click()
        button(tab, "Whole bag").click()
        expect_part(tab, "Play or save a part")
        button(tab, "Play").click()
        panel.wait_for("bag 119")
        assert heard(panel)[31:] == [*range(71, 120)]


def test_a_part_that_the_bag_has_not_is_told(browser: Browser, bag_pages: str) -> None:
    with opened(browser) as tab:
        tab.goto(f"{bag_pages}beyond/")
        told = "The bag ends before the part that this page names."
        expect(player(tab).get_by_role("status")).to_have_text(told)
        expect_part(tab, "Play or save a part")
        # A link to the end is one to the end, however long the bag is.
        player(tab).get_by_role("slider", name="Time").press("End")
        expect_time(tab, "0:05.9")
        assert states(shared(tab)) == {"bag-1": {"time": 5.95}}


def test_a_part_is_played_again_and_again(page: Tab) -> None:
    panel = Panel(page, "hears")
    open_part(page)
    enter(page, "From", "1")
    enter(page, "To", "1.5")
    expect_time(page, "0:01.0")
    player(page).get_by_role("checkbox", name="Loop").check()
    button(page, "Play").click()
    panel.wait_for("bag 30")
    until(lambda: heard(panel).count(20) > 1)
    button(page, "Pause").click()
    once = [*range(20, 31)]
    assert heard(panel)[:12] == [*once, 20]
    # What is no part is said at the field, and changes nothing.
    enter(page, "To", "0.5")
    assert limit(page, "To").evaluate("field => field.validationMessage") == (
        "This must be later than the start."
    )
    expect(button(page, "Save part")).to_be_disabled()
    expect_part(page, "Part: 0:01.0 to 0:01.5")
    enter(page, "To", "7")
    assert limit(page, "To").evaluate("field => field.validity.rangeOverflow")
    enter(page, "To", "2")
    expect_part(page, "Part: 0:01.0 to 0:02.0")
    expect(button(page, "Save part")).to_be_enabled()


def shared(tab: Tab) -> str:
    tab.get_by_role("button", name="Share").click()
    link = tab.get_by_role("dialog", name="Share").get_by_label("Link").input_value()
    tab.keyboard.press("Escape")
    return link


def states(link: str) -> Any:
    text = link.partition("#share=1.")[2]
    return json.loads(base64.urlsafe_b64decode(text + "=" * (-len(text) % 4))).get("show", {})


def test_a_link_opens_the_page_at_a_moment_of_a_part(
    page: Tab, browser: Browser, tmp_path: Path
) -> None:
    assert states(shared(page)) == {}
    open_part(page)
    seek(page, 3)
    button(page, "Start here").click()
    seek(page, 4)
    button(page, "End here").click()
    seek(page, 3.5)
    link = shared(page)
    assert states(link) == {"bag-1": {"time": 3.5, "part": "3-4"}}
    with opened(browser) as fresh:
        fresh.goto(link)
        panel = Panel(fresh, "hears")
        panel.expect_started()
        expect_part(fresh, "Part: 0:03.0 to 0:04.0")
        expect_time(fresh, "0:03.5")
        # What it shows again is the same, and nothing was played.
        assert states(shared(fresh)) == states(link)
        assert heard(panel) == []
        button(fresh, "Play").click()
        panel.wait_for("bag 80")
        assert heard(panel) == [*range(70, 81)]
        # A bag of the visitor is not in links.
        own = write_bag(tmp_path / "own.mcap", [("/words", STRING, {"data": "own"}, 0)])
        player(fresh).locator("input[type=file]").set_input_files(own)
        expect(player(fresh).locator(".ros-bag-row")).to_have_count(1)
        assert states(shared(fresh)) == {}


@pytest.mark.parametrize("part", ["9-12", "3-2", "2", "-1-3", "x"])
def test_a_link_to_a_part_that_the_bag_has_not_is_told(
    page: Tab, browser: Browser, part: str
) -> None:
    text = json.dumps({"run": [], "show": {"bag-1": {"part": part, "time": 1}}})
    fragment = base64.urlsafe_b64encode(text.encode()).decode().rstrip("=")
    with opened(browser) as fresh:
        fresh.goto(f"{page.url}#share=1.{fragment}")
        expect(fresh.locator(".ros-word")).to_contain_text("Parts of this link no longer match")
        expect_part(fresh, "Play or save a part")
        expect_time(fresh, "0:01.0")


def save(tab: Tab, folder: Path) -> Path:
    with tab.expect_download() as download:
        button(tab, "Save part").click()
    expect(player(tab).get_by_role("status")).to_contain_text("Saved ")
    path = folder / download.value.suggested_filename
    download.value.save_as(path)
    return path


@pytest.mark.chromium
def test_a_part_is_saved_as_a_bag(page: Tab, tmp_path: Path) -> None:
    open_part(page)
    enter(page, "From", "2")
    enter(page, "To", "3")
    player(page).get_by_role("checkbox", name="/places").uncheck()
    bag = save(page, tmp_path)
    assert bag.name == "drive_2.0-3.0.mcap"
    store = get_typestore(Stores.ROS2_JAZZY)
    with AnyReader([bag], default_typestore=store) as reader:
        found = [
            (one.topic, time - START, cast(Any, reader.deserialize(data, one.msgtype)).data)
            for one, time, data in reader.messages()
        ]
        [latched] = [one for one in reader.connections if one.topic == "/latched"]
        [profile] = cast(Any, latched.ext).offered_qos_profiles
        assert profile.durability.name == "TRANSIENT_LOCAL"
    words = [("/words", 50_000_000 * number, f"bag {number}") for number in range(40, 61)]
    # Who subscribes gets what was latched before the part.
    assert found == [("/latched", 2_000_000_000, "an old map"), *words]
    # It is a bag like others: the page plays it, too.
    player(page).locator("input[type=file]").set_input_files(bag)
    expect(player(page).locator(".ros-bag-row")).to_have_count(2)
    button(page, "Play").click()
    Panel(page, "hears").wait_for("bag 60")


@pytest.mark.chromium
def test_what_cannot_be_played_is_saved_as_it_is(page: Tab, tmp_path: Path) -> None:
    own = tmp_path / "own.mcap"
    writer = Writer(str(own))
    writer.start(profile="ros2", library="test")
    schema = writer.register_schema("Odd", "jsonschema", b'{"type": "object"}')
    plain = writer.register_channel("/plain", "json", 0, {"unit": "m"})
    odd = writer.register_channel("odd name", "json", schema)
    for number in range(100):
        at = START + number * 100_000_000
        for channel in (plain, odd):
            content = json.dumps({"number": number}).encode()
            writer.add_message(channel, at, content, at - 5, sequence=number)
    writer.finish()  # type: ignore[no-untyped-call]
    player(page).locator("input[type=file]").set_input_files(own)
    expect(player(page).locator(".ros-bag-row")).to_have_count(2)
    open_part(page)
    enter(page, "From", "9.75")
    with save(page, tmp_path).open("rb") as stream:
        reader = make_reader(stream, validate_crcs=True)
        found = [
            (schema and schema.encoding, channel.topic, message.sequence, message.publish_time)
            for schema, channel, message in reader.iter_messages()
        ]
        summary = reader.get_summary()
    assert found == [
        (kind, topic, number, START + number * 100_000_000 - 5)
        for number in (98, 99)
        for kind, topic in ((None, "/plain"), ("jsonschema", "odd name"))
    ]
    assert summary
    assert {one.topic: one.metadata for one in summary.channels.values()} == {
        "/plain": {"unit": "m"},
        "odd name": {},
    }
