"""A plot as a test sees it: topics to plot, the values of its legend, and what is drawn."""

from __future__ import annotations

from playwright.sync_api import Locator, expect
from playwright.sync_api import Page as Tab
from stage import add

JOINTS = "sensor_msgs/msg/JointState"
VECTOR = "geometry_msgs/msg/Vector3"


def with_topics(stage: Tab) -> Tab:
    """Return `stage` with two topics, and functions to publish on them as if time passed."""
    stage.evaluate(
        """() => {
          ros.types["sensor_msgs/msg/JointState"] = ros.fields("string[] name, float64[] position");
          ros.types["std_msgs/msg/Int64"] = ros.fields("int64 data");
          ros.types["nav_msgs/msg/Stamped"] =
            ros.fields("std_msgs/msg/Header header, float64 value");
          ros.types["std_msgs/msg/Header"] = ros.fields("builtin_interfaces/msg/Time stamp");
          window.begun = performance.timeOrigin + performance.now();
          // Publish at a time, in seconds from the beginning.
          window.publish = (topic, second, message) =>
            ros.emit(topic, message, 24, begun + 1000 * second);
          window.vector = (second, x, y = 0, z = 0) => publish("/v", second, { x, y, z });
        }"""
    )
    add(stage, "publisher", "/arm", "/joints", JOINTS)
    add(stage, "publisher", "/odom", "/v", VECTOR)
    return stage


def expect_values(panel: Locator, *values: tuple[str, str]) -> None:
    """Wait until the legend has these curves with these values, and no other ones."""
    rows = panel.locator(".ros-key > li:has(.ros-value-now)")
    expect(rows.locator(".ros-path")).to_have_text([path for path, _ in values])
    expect(rows.locator(".ros-value-now")).to_have_text([value for _, value in values])


def drawn(panel: Locator, number: int) -> list[list[int]]:
    """The columns and rows of the canvas where the curve of this colour is."""
    found: list[list[int]] = panel.page.evaluate(
        """async (number) => {
          await frames();
          const probe = document.createElement("span");
          probe.className = `ros-series-${number}`;
          document.querySelector(".ros-plot").append(probe);
          const paint = new OffscreenCanvas(1, 1).getContext("2d");
          paint.fillStyle = getComputedStyle(probe).color;
          paint.fillRect(0, 0, 1, 1);
          const wanted = paint.getImageData(0, 0, 1, 1).data;
          probe.remove();
          const canvas = document.querySelector(".ros-chart canvas");
          const { width, height } = canvas;
          const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
          const places = [];
          for (let at = 0; at < data.length; at += 4) {
            const near = (part) => Math.abs(data[at + part] - wanted[part]) < 9;
            if ([0, 1, 2].every(near) && data[at + 3] > 200) {
              places.push([(at / 4) % width, Math.floor(at / 4 / width)]);
            }
          }
          return places;
        }""",
        number,
    )
    return found
