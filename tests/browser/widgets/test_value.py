"""Single values in a real browser: numbers, gauges, lights and texts."""

from __future__ import annotations

from typing import Any

import pytest
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from stage import WIDER, add, hide_tab, show, subscribed

pytestmark = pytest.mark.firefox

THRESHOLDS: list[dict[str, Any]] = [
    {"from": 0, "is": "danger", "text": "empty"},
    {"from": 20, "is": "caution"},
    {"from": 40, "is": "good", "text": None},
]


@pytest.fixture
def battery(stage: Tab) -> Tab:
    """A stage with a battery."""
    stage.evaluate(
        """() => {
          ros.types["robot_msgs/msg/Battery"] = ros.fields(
            "float32 charge, bool present, string serial, uint64 cycles, float32[] cells");
          const empty =
            { charge: 0, present: false, serial: "", cycles: 0n, cells: new Float32Array(2) };
          window.send = async (fields, second = 0) => {
            const at = performance.timeOrigin + 1000 * second;
            ros.emit("/battery", { ...empty, ...fields }, 24, at);
            await frames();
          };
        }"""
    )
    add(stage, "publisher", "/base", "/battery", "robot_msgs/msg/Battery")
    return stage


def test_a_number_has_a_unit_and_a_state(battery: Tab) -> None:
    options = {
        "path": "/battery.charge", "scale": 100, "unit": "%", "decimals": 1,
        "thresholds": THRESHOLDS,
    }  # fmt: skip
    panel = show(battery, "value", options)
    expect(panel).to_contain_text("No message yet")
    battery.evaluate("send({ charge: 0.125 })")
    expect(panel.locator(".ros-figure")).to_have_text("12.5 %")
    expect(panel.get_by_role("status")).to_have_text("empty")
    shapes, colours = [], []
    for charge, word in ((0.1, "empty"), (0.2, "caution"), (0.9, "good")):
        battery.evaluate("(charge) => send({ charge: charge + 1e-6 })", charge)
        expect(panel.get_by_role("status")).to_have_text(word)
        shapes.append(panel.locator(".ros-grade path").get_attribute("d"))
        colours.append(panel.locator(".ros-number").evaluate("(e) => getComputedStyle(e).color"))
    assert len(set(shapes)) == 3
    assert len(set(colours)) == 3
    battery.evaluate("send({ charge: -1 })")
    expect(panel.get_by_role("status")).to_be_hidden()


def test_values_that_are_odd_are_shown(battery: Tab) -> None:
    panel = show(battery, "value", {"path": "/battery.charge", "thresholds": THRESHOLDS})
    for sent, shown in (
        ("NaN", "NaN"), ("Infinity", "∞"), ("-Infinity", "\u2212∞"), ("-0.5", "\u22120.5000"),
        ("1e-9", "1.000e\u22129"),
        ("1e300", "1.000e+300"),
    ):  # fmt: skip
        battery.evaluate(f"send({{ charge: {sent} }})")
        expect(panel.locator(".ros-figure")).to_have_text(shown)
    battery.evaluate("unmount()")
    panel = show(battery, "value", {"path": "/battery.cycles"})
    battery.evaluate("send({ cycles: 2n ** 64n - 1n })")
    expect(panel.locator(".ros-figure")).to_have_text("1.845e+19")
    battery.evaluate("unmount()")
    panel = show(battery, "value", {"path": "/battery.cells[-1]"})
    battery.evaluate("send({ cells: Float32Array.of(1, 3.5) })")
    expect(panel.locator(".ros-figure")).to_have_text("3.5000")
    battery.evaluate("send({ cells: new Float32Array() })")
    expect(panel.locator(".ros-figure")).to_have_text("3.5000")


def test_a_gauge_has_a_range(battery: Tab) -> None:
    options = {
        "path": "/battery.charge", "show": "gauge", "min": -50, "max": 50, "unit": "A",
        "thresholds": THRESHOLDS,
    }  # fmt: skip
    panel = show(battery, "value", options)
    battery.evaluate("send({ charge: 25 })")
    meter = panel.get_by_role("meter")
    for name, value in (("valuemin", "-50"), ("valuemax", "50"), ("valuenow", "25")):
        expect(meter).to_have_attribute(f"aria-{name}", value)
    expect(meter).to_have_attribute("aria-valuetext", "25 A")
    assert panel.locator(".ros-range").count() == 3

    def width() -> float:
        found: float = panel.locator(".ros-filled").evaluate("(e) => e.getBBox().width")
        return found

    three_quarters = width()
    battery.evaluate("send({ charge: 1000 })")
    expect(meter).to_have_attribute("aria-valuenow", "50")
    expect(panel.locator(".ros-figure")).to_have_text("1000 A")
    assert width() > three_quarters
    battery.evaluate("send({ charge: NaN })")
    assert width() == 0


def test_a_light_is_on_or_off(battery: Tab) -> None:
    panel = show(battery, "value", {"path": "/battery.present", "title": "Battery"})
    expect(panel.locator(".ros-title")).to_have_text("Battery")
    battery.evaluate("send({ present: true })")
    expect(panel.locator(".ros-figure")).to_have_text("on")
    on = panel.locator(".ros-lamp").evaluate("(e) => getComputedStyle(e).backgroundColor")
    battery.evaluate("send({ present: false })")
    expect(panel.locator(".ros-figure")).to_have_text("off")
    assert panel.locator(".ros-lamp").evaluate("(e) => getComputedStyle(e).backgroundColor") != on


def test_a_text_is_text(battery: Tab) -> None:
    panel = show(battery, "value", {"path": "/battery.serial"})
    battery.evaluate("send({ serial: '<img src=x>' })")
    expect(panel.locator(".ros-figure")).to_have_text("<img src=x>")
    battery.evaluate("send({ serial: 'x'.repeat(100000) })")
    assert len(panel.inner_text()) < 1200
    battery.set_viewport_size({"width": 390, "height": 800})
    assert battery.evaluate(WIDER) <= 0


def test_the_change_per_second_is_a_value(battery: Tab) -> None:
    panel = show(battery, "value", {"path": "/battery.charge.@derivative"})
    battery.evaluate("send({ charge: 1 }, 10)")
    expect(panel).to_contain_text("No message yet")
    battery.evaluate("send({ charge: 2 }, 10.5)")
    expect(panel.locator(".ros-figure")).to_have_text("2")


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"path": "battery"}, "'battery' is not a message path"),
        ({"path": "/battery.volts"}, "/battery.volts: robot_msgs/msg/Battery has no field 'volts'"),
        ({"path": "/battery"}, "/battery is a whole robot_msgs/msg/Battery"),
        ({"path": "/battery.cells"}, "/battery.cells names several values; name one, such as [0]"),
        ({"path": "/battery.cells[:]"}, "/battery.cells[:] names several values"),
        ({"path": "/battery.serial", "show": "gauge"}, "/battery.serial is text, not a number"),
        ({"path": "/other.data"}, "No node uses /other now"),
    ],
)
def test_what_is_wrong_is_said(battery: Tab, options: dict[str, Any], said: str) -> None:
    panel = show(battery, "value", options)
    expect(panel.locator(".ros-note")).to_contain_text(said)
    battery.evaluate("send({})")
    assert subscribed(battery) == []


def test_it_works_while_it_is_seen_and_says_when_nobody_publishes(battery: Tab) -> None:
    panel = show(battery, "value", {"path": "/battery.charge"})
    battery.evaluate("send({ charge: 1 })")
    assert subscribed(battery) == ["/battery"]
    hide_tab(battery, True)
    assert subscribed(battery) == []
    hide_tab(battery, False)
    expect(panel.locator(".ros-note")).to_be_empty()
    add(battery, "subscription", "/reader", "/battery", "robot_msgs/msg/Battery")
    battery.evaluate("ros.graph.remove('/base')")
    expect(panel).to_contain_text("/battery has no publishers now")
    expect(panel.locator(".ros-figure")).to_have_text("1")
    battery.evaluate("unmount()")
    assert subscribed(battery) == []
