"""A page whose text has commands, but no terminal: one opens at the bottom of the window."""

from __future__ import annotations

from browser import Built, Serve
from paths import SITES
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from terminal import ROWS, Terminal


def test_a_terminal_opens_for_the_commands_of_a_text(tab: Tab, serve: Serve, built: Built) -> None:
    tab.set_viewport_size({"width": 390, "height": 640})
    loaded: list[str] = []
    tab.on("request", lambda request: loaded.append(request.url.rpartition("/")[2]))
    tab.goto(serve(built(SITES / "terminal")) + "commands/")
    talk = tab.get_by_role("button", name="Run ros2 run speaking talker &")
    listed = tab.get_by_role("button", name="Run ros2 node list")
    expect(talk).to_be_visible()
    dock = tab.get_by_role("region", name="Terminal", exact=True)
    expect(dock).to_be_hidden()
    assert "terminal.js" not in loaded
    talk.click()
    expect(dock).to_be_visible()
    tab.wait_for_function(f"() => ({ROWS})().includes('talker &')")
    # The text with its commands ends above the terminal.
    listed.scroll_into_view_if_needed()
    edges = [part.bounding_box() for part in (listed, dock)]
    assert edges[0]
    assert edges[1]
    assert edges[0]["y"] + edges[0]["height"] <= edges[1]["y"]
    assert edges[1]["y"] + edges[1]["height"] == 640
    listed.click()
    tab.wait_for_function(f"() => ({ROWS})().includes('/talker')")
    assert tab.evaluate("document.activeElement.closest('.docked') !== null")


def test_closing_it_ends_what_it_runs(tab: Tab, serve: Serve, built: Built) -> None:
    tab.goto(serve(built(SITES / "terminal")) + "commands/")
    talk = tab.get_by_role("button", name="Run ros2 run speaking talker &")
    dock = tab.get_by_role("region", name="Terminal", exact=True)
    talk.click()
    tab.wait_for_function(f"() => ({ROWS})().includes('talker &')")
    tab.get_by_role("button", name="New terminal").click()
    expect(dock.get_by_role("tab")).to_have_count(2)
    close = tab.get_by_role("button", name="Close terminal")
    close.click()
    # One alone has no tab.
    expect(dock.get_by_role("tab")).to_have_count(0)
    close.click()
    expect(dock).to_be_hidden()
    expect(talk).to_be_focused()
    tab.get_by_role("button", name="Run ros2 node list").click()
    terminal = Terminal(tab)
    assert terminal.run("ros2 node list; echo none") == "none"
