"""The panel of managed nodes, with one in Python: states, transitions, and changes by others."""

from __future__ import annotations

from browser import Built, Serve
from paths import SITES
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from stage import add, show, subscribed

CHANGE = """async ([id, label]) => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  return (await ros.call("/managed/change_state", "lifecycle_msgs/srv/ChangeState",
    { transition: { id, label } })).success;
}"""


def test_a_managed_node_is_led_through_its_states(tab: Tab, serve: Serve, built: Built) -> None:
    tab.goto(serve(built(SITES / "instruments")))
    tab.locator(".ros-lifecycle").scroll_into_view_if_needed()
    node = tab.locator(".ros-managed")
    state, transitions = node.locator(".ros-managed-state"), node.get_by_role("button")
    expect(state).to_have_text("unconfigured")
    expect(transitions).to_have_text(["configure", "shutdown"])
    transitions.first.focus()
    tab.keyboard.press("Enter")
    expect(state).to_have_text("inactive")
    expect(transitions).to_have_text(["cleanup", "activate", "shutdown"])
    expect(node.get_by_role("status")).to_have_text("configure: done")
    # The keyboard stays at the transitions.
    expect(transitions.first).to_be_focused()
    node.get_by_role("button", name="activate", exact=True).click()
    expect(node.get_by_role("status")).to_have_text("activate: failed")
    expect(state).to_have_text("inactive")
    # Another client changes the state.
    assert tab.evaluate(CHANGE, [3, "activate"]) is True
    expect(state).to_have_text("active")
    expect(transitions).to_have_text(["deactivate", "shutdown"])
    node.get_by_role("button", name="shutdown").click()
    expect(state).to_have_text("finalized")
    expect(transitions).to_have_count(0)
    tab.get_by_role("region", name="managed").get_by_role("button", name="Stop").click()
    expect(tab.get_by_text("No managed nodes now.")).to_be_visible()


def test_a_panel_out_of_sight_follows_nothing(stage: Tab) -> None:
    stage.evaluate(
        """() => {
          for (const name of ["GetState", "GetAvailableTransitions", "ChangeState"]) {
            ros.types[`lifecycle_msgs/srv/${name}_Request`] = ros.fields("");
          }
          ros.types["lifecycle_msgs/msg/TransitionEvent"] = ros.fields("");
          ros.answer = async () => {
            throw new Error("no response from /arm/get_state within 5 s");
          };
        }"""
    )
    services = {
        "get_state": "GetState",
        "get_available_transitions": "GetAvailableTransitions",
        "change_state": "ChangeState",
    }
    for name in ("/arm", "/leg"):
        for service, type in services.items():
            add(stage, "service", name, f"{name}/{service}", f"lifecycle_msgs/srv/{type}")
    panel = show(stage, "lifecycle", {"show": ["/arm"]})
    expect(panel.locator(".ros-managed")).to_have_count(1)
    expect(panel.get_by_role("status")).to_have_text("no response from /arm/get_state within 5 s")
    assert subscribed(stage) == ["/arm/transition_event"]
    stage.evaluate("unmount()")
    assert subscribed(stage) == []


def test_a_page_without_managed_nodes_says_so(stage: Tab) -> None:
    panel = show(stage, "lifecycle")
    expect(
        panel.get_by_text("no node on this page uses lifecycle_msgs/srv/GetState")
    ).to_be_visible()
