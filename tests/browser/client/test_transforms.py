"""Transforms between frames at a time that a script asks for."""

from __future__ import annotations

from playwright.sync_api import Page

MOVING = """() => {
  const tf = ros.topic("/tf", "tf2_msgs/msg/TFMessage");
  globalThis.move = (sec, x) => tf.publish({ transforms: [{
    header: { frame_id: "map", stamp: { sec } }, child_frame_id: "base",
    transform: { translation: { x }, rotation: { w: 1 } },
  }] });
  globalThis.at = async (time) => (await ros.tf.lookup("map", "base", { time, timeout: 2000 }))
    .translation.x;
  // It listens from its first use on.
  ros.tf.frames();
}"""


def test_transforms_are_interpolated_at_a_time(scripted: Page) -> None:
    scripted.evaluate(MOVING)
    found = scripted.evaluate(
        """async () => {
          move(100, 4);
          const later = at({ sec: 101, nanosec: 500_000_000 });
          move(102, 8);
          return [await later, await at(101), await at({ sec: 101, nanosec: 0 }), await at(100),
            await at(0), await at({ sec: 0, nanosec: 0 })];
        }"""
    )
    assert found == [7, 6, 6, 4, 8, 8]


def test_another_time_is_refused(scripted: Page) -> None:
    found = scripted.evaluate(
        """() => Promise.all([101n, "101", NaN, null, {}, { sec: 101n, nanosec: 0 }].map((time) =>
          ros.tf.lookup("map", "base", { time }).catch(({ name, message }) => [name, message])))"""
    )
    kind = "'time' is a number of seconds or {sec, nanosec}, both numbers, not "
    shown = ["the bigint 101", "the string 101", "the number NaN", "null", *["another object"] * 2]
    assert found == [["TypeError", kind + each] for each in shown]
