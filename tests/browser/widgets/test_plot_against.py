"""Plots of one value against another, whose picture is kept from frame to frame."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from plots import drawn, with_topics
from stage import show

pytestmark = pytest.mark.firefox


@pytest.fixture
def robot(stage: Tab) -> Tab:
    """A stage with two topics to plot."""
    return with_topics(stage)


def test_one_value_is_plotted_against_another(robot: Tab) -> None:
    panel = show(robot, "plot", {"series": ["/v.y"], "x": "/v.x", "min": -2, "max": 2})
    robot.evaluate(
        """() => {
          for (let n = 0; n < 3000; n++) vector(n / 1000, Math.cos(n / 400), Math.sin(n / 400));
        }"""
    )
    places = drawn(panel, 0)
    by_column: dict[int, set[int]] = {}
    for x, y in places:
        by_column.setdefault(x, set()).add(y)
    middle = by_column[sorted(by_column)[len(by_column) // 2]]
    # A circle has two sides, far apart.
    assert max(middle) - min(middle) > 60
    assert (panel.get_by_role("img").get_attribute("aria-label") or "").startswith(
        "Plot against /v.x"
    )
    robot.evaluate("unmount()")
    panel = show(robot, "plot", {"series": ["/v.y"], "x": "/v.q"})
    expect(panel.get_by_text("/v.q: geometry_msgs/msg/Vector3 has no field 'q'")).to_be_visible()


# Publish samples on a rose of several turns, with a gap, from one number to another.
ROSE = """async ([from, to]) => {
  for (let n = from; n < to; n++) {
    const far = 1 + Math.cos(n / 37) / 4;
    vector(n / 1000, far * Math.cos(n / 400), n % 3000 === 1500 ? NaN : far * Math.sin(n / 400));
    if (n % 200 === 0) await frames(1);
  }
  await frames();
}"""


def test_a_frame_against_x_draws_what_is_new(robot: Tab) -> None:
    show(robot, "plot", {"series": ["/v.y"], "x": "/v.x", "window": 20})
    robot.evaluate(ROSE, [0, 20_000])
    lines: list[int] = robot.evaluate(
        """async () => {
          const { lineTo } = CanvasRenderingContext2D.prototype;
          let count = 0;
          CanvasRenderingContext2D.prototype.lineTo = function (x, y) {
            count++;
            lineTo.call(this, x, y);
          };
          const counts = [];
          for (let n = 20_000; n < 30_000; n += 20) {
            for (let at = n; at < n + 20; at++) {
              const far = 1 + Math.cos(at / 37) / 4;
              vector(at / 1000, far * Math.cos(at / 400), far * Math.sin(at / 400));
            }
            await frames(1);
            counts.push(count);
            count = 0;
          }
          return counts;
        }"""
    )
    # Once, the first time that the window drops a sample, all are drawn.
    assert max(lines[10:]) < 4000
    assert sum(lines[10:]) / len(lines[10:]) < 2000


def test_a_kept_picture_against_x_is_as_one_drawn_anew(robot: Tab) -> None:
    panel = show(robot, "plot", {"series": ["/v.y", "/v.z"], "x": "/v.x", "window": 5})
    curve = panel.get_by_role("button", name="/v.z", exact=True)

    def expect_as_anew() -> None:
        kept = set(map(tuple, drawn(panel, 0)))
        # Other curves are another picture.
        for _ in range(2):
            curve.click()
        anew = set(map(tuple, drawn(panel, 0)))
        assert len(kept) > 1000
        assert len(kept ^ anew) < 0.02 * len(anew)

    robot.evaluate(ROSE, [0, 4000])
    expect_as_anew()
    # The window drops some, most, and all of the first samples.
    for begin, end in ((4000, 6000), (6000, 12_100), (12_100, 30_000)):
        robot.evaluate(ROSE, [begin, end])
        expect_as_anew()
    panel.get_by_role("button", name="Points", exact=True).click()
    expect_as_anew()
    panel.get_by_role("button", name="Zoom in").click()
    expect_as_anew()
    panel.get_by_role("button", name="Fit").click()
    robot.set_viewport_size({"width": 700, "height": 700})
    robot.evaluate(ROSE, [30_000, 31_000])
    expect_as_anew()
    robot.evaluate("document.documentElement.dataset.colours = 'dark'")
    expect_as_anew()
    panel.get_by_role("button", name="Clear", exact=True).click()
    assert drawn(panel, 0) == []


def test_axes_against_x_follow_the_curves(robot: Tab) -> None:
    show(robot, "plot", {"series": ["/v.y"], "x": "/v.x", "window": 10})
    # It drifts, so the axes move; and it is never cut off, nor does it become small.
    robot.evaluate(
        """async () => {
          for (let n = 0; n < 3000; n++) {
            vector(n / 100, n / 100 + Math.cos(n / 20), Math.sin(n / 20));
            if (n % 20 === 0) await frames(1);
          }
        }"""
    )
    places = drawn(robot.locator("#panel"), 0)
    area = robot.locator(".u-over").bounding_box()
    assert area
    width = max(x for x, _ in places) - min(x for x, _ in places)
    assert 0.8 * area["width"] < width < 0.98 * area["width"]


def test_extents_are_those_of_all_samples(stage: Tab) -> None:
    wrong = stage.evaluate(
        """async () => {
          const { MOST, Trace } = await import("./runtime/widgets/plot/trace.js");
          const trace = new Trace(true);
          const wrong = [];
          for (let n = 0; n < MOST + 30000; n++) {
            trace.push(n, n % 500 === 3 ? NaN : Math.sin(n / 5000) * n, Math.cos(n / 9000) * 1e3);
            if (n % 9000 === 4000) trace.dropBefore(n - 20000);
            if (n % 777) continue;
            const { left, right, low, high } = trace.extents.whole;
            const sample = (_, at) => [trace.x(at), trace.value(at)];
            const all = Array.from({ length: trace.size }, sample)
              .filter(([, y]) => y === y);
            const [xs, ys] = [0, 1].map((part) => all.map((one) => one[part]));
            const least = (values) => values.reduce((a, b) => Math.min(a, b), Infinity);
            const most = (values) => values.reduce((a, b) => Math.max(a, b), -Infinity);
            const real = [least(xs), most(xs), least(ys), most(ys)];
            if (real.join() !== [left, right, low, high].join()) wrong.push(n);
          }
          trace.clear();
          return [wrong, trace.extents.whole.left === Infinity];
        }"""
    )
    assert wrong == [[], True]
