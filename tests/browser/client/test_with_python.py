"""The module `sitegen` and roslib's transport, with a Python node."""

from __future__ import annotations

from browser import Built, Serve
from panel import Panel
from paths import SITES
from playwright.sync_api import Page

SITE = SITES / "scripts"


def test_a_script_and_a_python_node_use_each_other(tab: Page, serve: Serve, built: Built) -> None:
    tab.goto(f"{serve(built(SITE))}python/")
    tab.wait_for_selector("body[data-scripted]")
    found = tab.evaluate(
        """async () => {
          ros.service("/page/add", "example_interfaces/srv/AddTwoInts")
            .serve(({ a, b }) => ({ sum: a + b }));
          const fibonacci = ros.action("/fibonacci");
          await fibonacci.wait();
          const { data } = await ros.topic("/said").next();
          const { sum } = await ros.service("/add_two_ints").call({ a: -1n, b: 2n });
          await ros.parameters("/helper").set("gain", 3);
          await ros.service("/ask_page").call({ data: true });
          const goal = await fibonacci.send({ order: 4 });
          const steps = [];
          for await (const { sequence } of goal.feedback()) steps.push(sequence.length);
          const { sequence } = await goal.result();
          const gain = await ros.parameters("/helper").get("gain");
          return { data, sum: String(sum), steps, sequence: [...sequence], gain };
        }"""
    )
    assert found == {
        "data": "grüße",
        "sum": "1",
        "steps": [3, 4, 5],
        "sequence": [0, 1, 1, 2, 3],
        "gain": 3,
    }
    Panel(tab, "helper").wait_for("page says 42")
