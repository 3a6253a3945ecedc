"""Quality of service and names as compiled programs meet them; see sites/qos."""

from __future__ import annotations

import re

import pytest
import yaml
from browser import Built, Serve
from native import Native
from panel import Panel, expect_nothing_left
from paths import SITES
from playwright.sync_api import BrowserContext, Page, expect

SITE = SITES / "qos"


@pytest.fixture
def page(context: BrowserContext, serve: Serve, built: Built) -> Page:
    page = context.new_page()
    page.goto(serve(built(SITE)))
    return page


def start(page: Page, *names: str) -> list[Panel]:
    panels = [Panel(page, name) for name in names]
    for panel in panels:
        panel.start()
    for panel in panels:
        panel.expect_started()
    return panels


def test_events_reach_both_sides(page: Page) -> None:
    offers, wants = start(page, "offers", "wants")
    wants.wait_for("deadline missed")
    wants.wait_for("alive 0, not alive 1")
    offers.wait_for("liveliness lost 1")
    wants.stop()
    offers.wait_for("matched 0 of 1, -1")
    assert sorted(set(offers.messages())) == [
        "deadline missed 1",
        "liveliness lost 1",
        "matched 0 of 1, -1",
        "matched 1 of 1, +1",
    ]
    assert sorted(wants.messages()) == [
        "alive 0, not alive 1",
        "alive 1, not alive 0",
        "deadline missed 1",
        "heard",
        "matched 1, +1",
    ]


def test_a_depth_of_zero_is_warned_of_as_upstream_and_keeps_a_message(page: Page) -> None:
    (zero,) = start(page, "zero")
    zero.wait_for("got 7")
    lines = [re.sub(r" \[[\d.]+\]", "", line) for line in zero.lines()]
    stored = "A zero depth with KEEP_LAST doesn't make sense; no data could be stored."
    left = "This will be interpreted as SYSTEM_DEFAULT"
    assert lines == [
        "[INFO] [zero]: nothing yet",
        f"[WARN] [rclcpp]: {stored} {left}",
        f"[WARN] [rclcpp]: {stored}{left}",
        "[INFO] [zero]: depth 0",
        "[INFO] [zero]: got 7",
    ]


def test_what_does_not_suit_is_told_in_the_words_of_ros(page: Page) -> None:
    offers, strict = start(page, "offers", "strict")
    strict.wait_for("Last incompatible policy: DEADLINE_QOS_POLICY")
    strict.wait_for("incompatible 1: DURABILITY_QOS_POLICY")
    strict.wait_for("Incompatible type on topic '/vitals', no messages will be received from it.")
    offers.wait_for("Incompatible type on topic '/vitals', no messages will be sent to it.")
    assert "[WARN]" in strict.console.inner_text()
    assert strict.console.inner_text().count("New publisher discovered") == 1
    assert "requesting incompatible QoS. No messages will be sent to it." in (
        offers.console.inner_text()
    )
    page.get_by_role("tab", name="Topics").click()
    warnings = page.locator(".ros-topics tbody p")
    expect(
        warnings.get_by_text("/strict does not receive from /offers. Durability: ")
    ).to_be_visible()
    expect(warnings.get_by_text("/strict does not receive from /offers. Type: ")).to_be_visible()


def test_nothing_is_lost_where_all_is_kept(page: Page) -> None:
    pours, drinks = start(page, "pours", "drinks")
    drinks.wait_for("drank all")
    pours.wait_for("poured, all: 1")
    pours.expect_state("stopped")
    assert drinks.messages() == ["drank all"]
    drinks.stop()
    expect_nothing_left(page)


def test_who_keeps_all_and_finds_no_room_is_told(page: Page) -> None:
    pours, _ = start(page, "pours", "sleeps")
    pours.wait_for("failed to publish message: the queues of the subscriptions to '/wine' are full")
    pours.expect_state("stopped")


def test_names_are_those_of_ros(page: Page) -> None:
    arguments = yaml.safe_load((SITE / "site.yaml").read_text())["nodes"]["names"]["arguments"]
    names = Panel(page, "names")
    names.start()
    names.expect_state("stopped")
    here = "\n".join(names.lines()).split("--")
    native = "\n".join(Native().run("names.py", *arguments)).split("--")
    assert len(native) == len(arguments) + 1
    assert [words(text) for text in here] == [words(text) for text in native]


def words(text: str) -> list[str]:
    """The words of a message; a console shows lines that are empty in its own way."""
    return text.split()
