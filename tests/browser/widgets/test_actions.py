"""The panel of actions, with a server in Python: goals are sent, followed, canceled and refused."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from browser import Built, Serve
from paths import SITES
from playwright.sync_api import Locator, expect
from playwright.sync_api import Page as Tab
from stage import add, show


@pytest.fixture
def panel(tab: Tab, serve: Serve, built: Built) -> Iterator[Locator]:
    tab.goto(serve(built(SITES / "instruments")))
    panel = tab.locator(".ros-actions")
    expect(panel.get_by_role("button", name="Send goal")).to_be_enabled()
    yield panel


def send(panel: Locator, order: int) -> Locator:
    """Send a goal and return its card, which is the first."""
    count = panel.locator(".ros-goal").count()
    panel.get_by_label("order int32").fill(str(order))
    panel.get_by_role("button", name="Send goal").click()
    expect(panel.locator(".ros-goal")).to_have_count(count + 1)
    return panel.locator(".ros-goal").first


def test_goals_are_sent_followed_and_canceled(panel: Locator) -> None:
    expect(panel.get_by_text("served by /counter")).to_be_visible()
    long = send(panel, 1000)
    name = long.locator("b").inner_text()
    expect(panel.get_by_label(f"feedback of goal {name}")).to_contain_text("- 13")
    expect(long).to_have_attribute("data-state", "executing")
    # Another goal runs beside it.
    other = send(panel, 5)
    done = panel.get_by_label(f"result of goal {other.locator('b').inner_text()}")
    expect(done).to_have_text("sequence:\n- 0\n- 1\n- 1\n- 2\n- 3\n- 5")
    expect(other).to_have_attribute("data-state", "succeeded")
    expect(panel.get_by_role("status")).to_contain_text("succeeded")
    panel.get_by_role("button", name=f"Cancel goal {name}").click()
    expect(panel.locator('[data-state="canceled"]')).to_contain_text("Result")
    expect(panel.get_by_role("button", name="Cancel goal")).to_have_count(0)
    aborted = send(panel, 3)
    expect(aborted).to_have_attribute("data-state", "aborted")
    refused = send(panel, -1)
    expect(refused).to_have_attribute("data-state", "rejected")
    panel.get_by_label("order int32").fill("many")
    panel.get_by_role("button", name="Send goal").click()
    expect(panel.get_by_role("status")).to_have_text("Not sent: correct the marked fields")
    assert panel.locator(".ros-goal").count() == 4


def test_a_server_that_ends_leaves_no_goal_waiting(panel: Locator, tab: Tab) -> None:
    goal = send(panel, 1000)
    expect(goal).to_have_attribute("data-state", "executing")
    tab.get_by_role("region", name="counter").get_by_role("button", name="Stop").click()
    expect(goal).to_contain_text("no result: the server of /fibonacci ended")
    expect(panel.get_by_text("no server now")).to_be_visible()
    left = tab.evaluate(
        """async () => {
          const { ros } = await import(document.querySelector("script[type=module]").src);
          return ros.graph.endpoints().filter(({ kind }) => kind === "client").length;
        }"""
    )
    assert left == 0


def test_goals_of_other_clients_are_shown(panel: Locator, tab: Tab) -> None:
    tab.evaluate(
        """async () => {
          const { ros } = await import(document.querySelector("script[type=module]").src);
          const uuid = new Uint8Array(16).fill(7);
          await ros.call("/fibonacci/_action/send_goal", "test_msgs/action/Fibonacci_SendGoal",
            { goal_id: { uuid }, goal: { order: 4 } });
        }"""
    )
    goal = panel.locator(".ros-goal")
    expect(goal.locator("b")).to_have_text("070707 of another node")
    expect(goal).to_have_attribute("data-state", "succeeded")
    expect(panel.get_by_label("result of goal 070707")).to_contain_text("- 3")


def test_an_action_without_definitions_is_said_plainly(stage: Tab) -> None:
    panel = show(stage, "actions")
    expect(panel.get_by_text("No actions now.")).to_be_visible()
    name = "/spin/_action/send_goal"
    add(stage, "service", "/spinner", name, "spin_msgs/action/Spin_SendGoal")
    panel.get_by_role("button", name="/spin").click()
    expect(panel.get_by_role("status")).to_contain_text(
        "this page has no definition of spin_msgs/action/Spin_Goal"
    )
    expect(panel.get_by_role("button", name="Send goal")).to_be_disabled()
