"""roslib on a page with a Python node."""

from __future__ import annotations

from panel import Panel
from playwright.sync_api import Page


def test_roslib_and_a_python_node_use_each_other(beside_python: Page) -> None:
    found = beside_python.evaluate(
        """async () => {
          const call = (name, request) => until((resolve, reject) =>
            link.Service({ name, serviceType: "" }).callService(request, resolve, reject));
          const heard = await until((resolve) =>
            link.Topic({ name: "/said", messageType: "std_msgs/String" }).subscribe(resolve));
          const { sum } = await call("/add_two_ints", { a: -1, b: 2 });
          const add = link.Service({ name: "/page/add",
            serviceType: "example_interfaces/AddTwoInts" });
          await add.advertiseAsync(async ({ a, b }) => ({ sum: a + b }));
          await call("/ask_page", { data: true });
          const gain = link.Param({ name: "/helper:gain" });
          await until((resolve, reject) => gain.set(2.5, resolve, reject));
          const actionType = "example_interfaces/Fibonacci";
          const action = new ROSLIB.Action({ ros: link, name: "/fibonacci", actionType });
          const steps = [];
          const { sequence } = await until((resolve, reject) => action.sendGoal({ order: 4 },
            resolve,
            ({ sequence: one }) => steps.push(one.length), reject));
          return { heard, sum, steps, sequence, gain: await until((resolve) => gain.get(resolve)) };
        }"""
    )
    assert found == {
        "heard": {"data": "grüße"},
        "sum": 1,
        "steps": [3, 4, 5],
        "sequence": [0, 1, 1, 2, 3],
        "gain": 2.5,
    }
    Panel(beside_python, "helper").wait_for("page says 42")
