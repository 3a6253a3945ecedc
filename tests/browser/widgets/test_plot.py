"""Plots in a real browser: what they draw, keep and subscribe to."""

from __future__ import annotations

import csv
import io
from itertools import pairwise

import pytest
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from plots import drawn, expect_values, with_topics
from saving import saved
from stage import WIDER, add, hide_tab, show, subscribed

pytestmark = pytest.mark.firefox


@pytest.fixture
def robot(stage: Tab) -> Tab:
    """A stage with two topics to plot."""
    return with_topics(stage)


def test_curves_are_drawn_with_their_values(robot: Tab) -> None:
    panel = show(robot, "plot", {"series": ["/joints.position[:]{name}", "/v.x"]})
    assert subscribed(robot) == ["/joints", "/v"]
    robot.evaluate(
        """() => {
          for (let n = 0; n <= 300; n++) {
            vector(n / 10, Math.sin(n / 10));
            const position = Float64Array.of(n, 300 - n);
            publish("/joints", n / 10, { name: ["elbow", "<b>"], position });
          }
        }"""
    )
    expect_values(
        panel,
        ("/joints.position[elbow]", "300"),
        ("/joints.position[<b>]", "0"),
        ("/v.x", "\u22120.9880"),
    )
    expect(panel.get_by_role("img")).to_have_attribute(
        "aria-label",
        "Plot against time. Latest values: /joints.position[elbow] 300, "
        "/joints.position[<b>] 0, /v.x \u22120.9880",
    )
    rising, falling = drawn(panel, 1), drawn(panel, 2)
    assert min(rising)[1] > max(rising)[1]
    assert min(falling)[1] < max(falling)[1]
    # It has the whole width, which is that of the window.
    assert max(rising)[0] - min(rising)[0] > 800
    panel.get_by_role("button", name="/joints.position[elbow]").click()
    assert drawn(panel, 1) == []
    assert drawn(panel, 2)


def test_paths_of_rqt_plot_are_understood(robot: Tab) -> None:
    panel = show(robot, "plot", {"series": ["/v/x"]})
    assert subscribed(robot) == ["/v"]
    robot.evaluate("vector(1, 0.5)")
    expect_values(panel, ("/v.x", "0.5000"))


def test_nothing_is_received_while_nobody_looks(robot: Tab) -> None:
    panel = show(robot, "plot", {"series": ["/v.x"]})
    robot.evaluate("() => { vector(0, 1); vector(10, 2); }")
    panel.get_by_role("button", name="Pause").click()
    assert subscribed(robot) == []
    panel.get_by_role("button", name="Resume").click()
    assert subscribed(robot) == ["/v"]
    hide_tab(robot, True)
    assert subscribed(robot) == []
    hide_tab(robot, False)
    assert subscribed(robot) == ["/v"]
    robot.evaluate("() => { vector(20, 2); vector(30, 1); }")
    # What was missed is a gap and no line.
    columns = sorted({x for x, _ in drawn(panel, 0)})
    gaps = [after - before for before, after in pairwise(columns)]
    assert max(gaps) == pytest.approx(max(columns) / 3, rel=0.15)
    robot.evaluate("unmount()")
    assert subscribed(robot) == []


def test_a_chart_is_drawn_once_a_frame(robot: Tab) -> None:
    show(robot, "plot", {"series": ["/v.x"]})
    drawn = robot.evaluate(
        """async () => {
          let cleared = 0;
          const { clearRect } = CanvasRenderingContext2D.prototype;
          CanvasRenderingContext2D.prototype.clearRect = function (...box) {
            cleared++;
            clearRect.apply(this, box);
          };
          await frames();
          cleared = 0;
          for (let n = 0; n < 1000; n++) vector(n / 1000, n);
          await frames(1);
          await frames(1);
          const once = cleared;
          await frames(10);
          return [once, cleared];
        }"""
    )
    assert drawn == [1, 1]


def test_old_samples_are_forgotten(robot: Tab) -> None:
    show(robot, "plot", {"series": ["/v.x"]})
    sizes = robot.evaluate(
        """async () => {
          const { MOST, Trace } = await import("./runtime/widgets/plot/trace.js");
          const trace = new Trace();
          for (let n = 0; n < 2 * MOST + 5; n++) trace.push(n, -n);
          const last = trace.value(trace.size - 1);
          const most = [trace.size, trace.time(0), last, trace.find(MOST + 100.5)];
          trace.dropBefore(2 * MOST);
          return [MOST, most, [trace.size, trace.time(0)]];
        }"""
    )
    most = sizes[0]
    assert sizes[1] == [most, most + 5, -2 * most - 4, 96]
    assert sizes[2] == [5, 2 * most]
    robot.evaluate("() => { for (let n = 0; n < 100; n++) vector(n, n < 60 ? 1000 : 1); }")
    # Of the thousands nothing is left, so the axis does not reach there.
    assert len({y for _, y in drawn(robot.locator("#panel"), 0)}) < 6
    assert "1000" not in robot.locator("#panel").inner_text()


def test_samples_that_there_is_no_room_for_are_told(robot: Tab) -> None:
    panel = show(robot, "plot", {"series": ["/v.x"], "window": 600})
    fill = """async (count) => {
      const { MOST } = await import("./runtime/widgets/plot/trace.js");
      for (let n = 0; n < MOST + count; n++) vector((window.at = (window.at ?? 0) + 0.001), n);
    }"""
    robot.evaluate(fill, -1)
    expect(panel.locator(".ros-key li")).to_have_count(1)
    robot.evaluate(fill, 0)
    expect(panel.locator(".ros-key li.ros-silent")).to_contain_text(
        "/v.x: only the last 131072 samples are kept: 131.1 s"
    )
    panel.get_by_label("seconds").fill("60")
    panel.get_by_label("seconds").press("Enter")
    expect(panel.locator(".ros-key li")).to_have_count(1)


def test_an_outline_has_all_peaks(stage: Tab) -> None:
    found = stage.evaluate(
        """async () => {
          const { Trace } = await import("./runtime/widgets/plot/trace.js");
          const { emptyOutline, outlineTime } = await import("./runtime/widgets/plot/outline.js");
          const trace = new Trace();
          for (let n = 0; n < 60000; n++) {
            const odd = { 12345: 7, 45678: -9, 30000: NaN }[n];
            trace.push(n / 1000, odd ?? Math.sin(n / 50));
          }
          const outline = emptyOutline(500);
          outlineTime(trace, 0, 60, 500, outline);
          const ys = [...outline.ys.subarray(0, outline.count)];
          const xs = [...outline.xs.subarray(0, outline.count)];
          return { count: ys.length, top: Math.max(...ys.filter((y) => y === y)), low: outline.low,
            high: outline.high, gaps: ys.filter(Number.isNaN).length,
            sorted: xs.every((x, index) => index === 0 || x >= xs[index - 1]) };
        }"""
    )
    assert found["count"] <= 5 * 500 + 7
    assert found == {
        "count": found["count"],
        "top": 7,
        "low": -9,
        "high": 7,
        "gaps": 1,
        "sorted": True,
    }


def test_visitors_choose_what_is_plotted(robot: Tab) -> None:
    add(robot, "publisher", "/arm", "/text", "std_msgs/msg/String")
    panel = show(robot, "plot")
    expect(panel).to_contain_text("Add a message path to plot it")
    offered = panel.locator("datalist option").evaluate_all("(all) => all.map(({value}) => value)")
    assert offered == ["/joints.position[:]{name}", "/v.x", "/v.y", "/v.z"]
    field = panel.get_by_label("message path of a new curve")
    field.fill("/v")
    field.press("Enter")
    field.fill("v.x")
    panel.get_by_role("button", name="Add").click()
    expect(panel.get_by_role("status")).to_contain_text("'v.x' is not a message path")
    expect(field).to_have_attribute("aria-invalid", "true")
    field.fill("/v.x")
    field.press("Enter")
    expect(field).to_have_value("")
    field.fill("/v.x")
    field.press("Enter")
    expect(panel.get_by_role("status")).to_have_text("/v.x is plotted already")
    expect(panel).to_contain_text("/v is a whole geometry_msgs/msg/Vector3; add one of its fields")
    assert robot.evaluate("ros.kept().series") == ["/v", "/v.x"]
    panel.get_by_role("button", name="Remove /v", exact=True).click()
    assert robot.evaluate("ros.kept().series") == ["/v.x"]
    robot.evaluate("vector(1, 5)")
    expect_values(panel, ("/v.x", "5"))
    add(robot, "publisher", "/new", "/count", "std_msgs/msg/Int64")
    expect(panel.locator("datalist option[value='/count.data']")).to_have_count(1)


def test_a_link_has_the_curves_and_the_window(robot: Tab) -> None:
    panel = show(robot, "plot", {"series": ["/v.x"], "window": 10})
    kept = robot.evaluate("ros.kept()")
    assert [value for value in kept.values() if value] == []
    panel.get_by_label("seconds").fill("2,5")
    panel.get_by_label("seconds").dispatch_event("change")
    panel.get_by_role("button", name="Points", exact=True).click()
    panel.get_by_label("message path of a new curve").fill("/v.y")
    panel.get_by_role("button", name="Add").click()
    kept = robot.evaluate("ros.kept()")
    assert kept == {"series": ["/v.x", "/v.y"], "window": "2.5", "points": True}
    robot.evaluate("(kept) => { unmount(); ros.given = kept; }", kept)
    panel = show(robot, "plot", {"series": ["/v.x"], "window": 10})
    assert robot.evaluate("ros.kept()") == kept
    expect(panel.get_by_label("seconds")).to_have_value("2.5")
    robot.evaluate("() => { unmount(); ros.given = { series: ['/v.x', 'x', 3], window: '-1' }; }")
    show(robot, "plot", {"series": ["/v.y"]})
    assert robot.evaluate("[ros.odd, ros.kept().series, ros.kept().window]") == [2, ["/v.x"], ""]


def test_a_part_is_selected_and_left(robot: Tab) -> None:
    panel = show(robot, "plot", {"series": ["/v.x"]})
    robot.evaluate("() => { for (let n = 0; n <= 300; n++) vector(n / 10, n); }")
    whole = drawn(panel, 0)
    area = panel.locator(".u-over").bounding_box()
    assert area

    def drag(x: float, to: float) -> None:
        robot.mouse.move(area["x"] + x * area["width"], area["y"] + 20)
        robot.mouse.down()
        robot.mouse.move(area["x"] + (x + to) / 2 * area["width"], area["y"] + 22)
        robot.mouse.move(area["x"] + to * area["width"], area["y"] + 22)
        robot.mouse.up()
        robot.evaluate("frames()")

    drag(0.5, 0.6)
    expect(panel.get_by_role("button", name="Resume")).to_be_visible()
    assert subscribed(robot) == []
    steep = drawn(panel, 0)
    assert len({x for x, _ in steep}) > 100
    assert steep != whole
    panel.locator(".u-over").dispatch_event("dblclick")
    expect(panel.get_by_role("button", name="Pause")).to_be_visible()
    assert drawn(panel, 0) == whole
    assert subscribed(robot) == ["/v"]

    # The same with keys and with buttons; a pause that the visitor wanted stays.
    chart = panel.get_by_role("img")
    chart.press("+")
    assert drawn(panel, 0) != whole
    chart.press("0")
    assert drawn(panel, 0) == whole
    panel.get_by_role("button", name="Pause").click()
    panel.get_by_role("button", name="Zoom in").click()
    panel.get_by_role("button", name="Fit").click()
    assert drawn(panel, 0) == whole
    expect(panel.get_by_role("button", name="Resume")).to_be_visible()
    for _ in range(80):
        panel.get_by_role("button", name="Zoom in").click()
    panel.get_by_role("button", name="Fit").click()
    assert drawn(panel, 0) == whole


def test_what_is_shown_is_saved_as_a_table(robot: Tab) -> None:
    panel = show(robot, "plot", {"series": ["/v.x", "/joints.position[:]{name}"], "window": 5})
    robot.evaluate(
        """() => {
          vector(0, 1);
          vector(10, 2);
          publish("/joints", 10.5, { name: ['a,"b"'], position: Float64Array.of(-0.25) });
          vector(11, NaN);
        }"""
    )
    expect_values(panel, ("/v.x", "NaN"), ('/joints.position[a,"b"]', "\u22120.2500"))
    name, content = saved(panel.get_by_role("button", name="CSV"))
    assert name == "plot.csv"
    rows = list(csv.reader(io.StringIO(content.decode(), newline="")))
    assert rows[0] == ["time", "/v.x", '/joints.position[a,"b"]']
    assert [row[1:] for row in rows[1:]] == [["2", ""], ["", "-0.25"], ["NaN", ""]]
    begun = robot.evaluate("begun / 1000")
    assert [float(row[0]) - begun for row in rows[1:]] == pytest.approx([10, 10.5, 11], abs=1e-3)


def test_odd_numbers_do_no_harm(robot: Tab) -> None:
    add(robot, "publisher", "/counter", "/count", "std_msgs/msg/Int64")
    panel = show(robot, "plot", {"series": ["/v.x", "/v.y", "/count.data", "/joints.position[5]"]})
    robot.evaluate(
        """() => {
          const odd = [NaN, Infinity, -Infinity, 1.7e308, -1.7e308, 5e-324, -0, 1e29, 4, 4, 4];
          odd.forEach((value, n) => vector(n, value, 1e15 + n));
          publish("/count", 11, { data: 2n ** 63n - 1n });
          publish("/joints", 12, { name: [], position: new Float64Array() });
          publish("/joints", 12, {});
          ros.subscriptions.find(({ topic }) => topic === "/v")
            .callback({ x: 1 }, { size: 1, sequence: 1, timestamp: 0, received: 0 });
          vector(13, "text", {}, null);
          vector(14, 3);
        }"""
    )
    expect_values(panel, ("/v.x", "3"), ("/v.y", "0"), ("/count.data", "\u2013"))
    robot.evaluate("publish('/count', 15, { data: 2n ** 63n - 1n })")
    expect_values(panel, ("/v.x", "3"), ("/v.y", "0"), ("/count.data", "9.223e+18"))
    assert drawn(panel, 2)


def test_more_curves_than_can_be_told_apart_are_left_out(robot: Tab) -> None:
    panel = show(robot, "plot", {"series": ["/joints.position[:]"]})
    robot.evaluate("publish('/joints', 1, { name: [], position: new Float64Array(5000) })")
    expect(panel).to_contain_text("Only 40 curves are drawn; choose fewer elements with a slice")
    expect(panel.locator(".ros-key > li:has(.ros-value-now)")).to_have_count(40)


def test_a_derivative_is_per_second(robot: Tab) -> None:
    panel = show(robot, "plot", {"series": ["/v.x.@derivative"]})
    robot.evaluate("() => { vector(0, 1); vector(0, 5); vector(0.5, 3); vector(0.5, 9); }")
    expect_values(panel, ("/v.x.@derivative", "4"))


def test_the_stamp_of_the_header_can_be_the_time(robot: Tab) -> None:
    add(robot, "publisher", "/sim", "/s", "nav_msgs/msg/Stamped")
    panel = show(robot, "plot", {"series": ["/s.value"], "time": "header", "window": 10})
    robot.evaluate(
        """() => {
          const at = (sec, value) =>
            publish("/s", 1, { header: { stamp: { sec, nanosec: 0 } }, value });
          for (let sec = 100; sec <= 110; sec++) at(sec, sec);
        }"""
    )
    assert len({x for x, _ in drawn(panel, 0)}) > 800
    # The simulation starts again.
    robot.evaluate(
        "publish('/s', 2, { header: { stamp: { sec: 1, nanosec: 0 } }, value: 7 })",
    )
    expect_values(panel, ("/s.value", "7"))
    assert len({x for x, _ in drawn(panel, 0)}) < 10


def test_a_topic_may_be_behind_another(robot: Tab) -> None:
    panel = show(robot, "plot", {"series": ["/v.x", "/joints.position[0]"]})
    robot.evaluate(
        """() => {
          for (let n = 0; n < 100; n++) {
            vector(n / 10, 0);
            publish("/joints", n / 10 - 3, { name: [], position: Float64Array.of(1) });
          }
        }"""
    )
    first, second = ({x for x, _ in drawn(panel, number)} for number in (0, 1))
    assert len(second) == pytest.approx(len(first), rel=0.05)
    # Within a topic, a message out of order is left out.
    robot.evaluate("() => { vector(9.5, 50); vector(10, 0); }")
    expect_values(panel, ("/v.x", "0"), ("/joints.position[0]", "1"))
    assert len({y for _, y in drawn(panel, 0)}) < 8


def test_colours_follow_the_page(robot: Tab) -> None:
    panel = show(robot, "plot", {"series": ["/v.x"]})
    robot.evaluate("() => { for (let n = 0; n < 100; n++) vector(n / 10, n); }")
    robot.evaluate("document.documentElement.dataset.colours = 'dark'")
    dark = drawn(panel, 0)
    robot.evaluate("document.documentElement.dataset.colours = 'light'")
    light = drawn(panel, 0)
    assert dark
    assert light
    colours = robot.evaluate(
        """() => Object.fromEntries(["light", "dark"].map((colours) => {
          document.documentElement.dataset.colours = colours;
          const paint = new OffscreenCanvas(1, 1).getContext("2d");
          const shade = (colour) => {
            paint.fillStyle = colour;
            paint.fillRect(0, 0, 1, 1);
            const parts = [...paint.getImageData(0, 0, 1, 1).data].map((part) => part / 255)
              .map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4));
            return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2];
          };
          const area = document.querySelector(".ros-chart-area");
          const paper = shade(getComputedStyle(area).backgroundColor);
          const found = Array.from({ length: 8 }, (_, number) => {
            const probe = document.createElement("span");
            probe.className = `ros-series-${number}`;
            document.querySelector(".ros-plot").append(probe);
            const ink = shade(getComputedStyle(probe).color);
            probe.remove();
            return (Math.max(ink, paper) + 0.05) / (Math.min(ink, paper) + 0.05);
          });
          return [colours, Math.min(...found)];
        }))"""
    )
    assert colours["light"] >= 4.5
    assert colours["dark"] >= 4.5


def test_a_phone_has_room_for_it(robot: Tab) -> None:
    robot.set_viewport_size({"width": 390, "height": 800})
    long = "/a_rather_long_name_of_a_topic.pose.pose.position.x"
    panel = show(robot, "plot", {"series": ["/joints.position[:]{name}", long]})
    robot.evaluate("publish('/joints', 1, { name: ['a'], position: Float64Array.of(1) })")
    robot.evaluate("frames()")
    assert robot.evaluate(WIDER) <= 0
    canvas = panel.locator("canvas").bounding_box()
    assert canvas
    assert canvas["width"] <= 390
    inside = panel.locator("button, input").evaluate_all(
        "(all) => all.every((one) => one.getBoundingClientRect().right <= innerWidth)"
    )
    assert inside
    robot.set_viewport_size({"width": 800, "height": 800})
    robot.wait_for_function(
        "() => document.querySelector('.ros-chart canvas').getBoundingClientRect().width > 500"
    )
