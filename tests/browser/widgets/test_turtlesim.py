"""Turtlesim: its node as upstream's programs know it, and its window on the page."""

from __future__ import annotations

import pytest
from browser import Built, Serve
from panel import Panel
from paths import ROOT, SITES
from playwright.sync_api import Locator, Page, expect

from sitegen.config import load

SITE = SITES / "turtles"
DEMO = ROOT / "demos" / "demo09"
TRIED = """
spawned ['friend', '', 'turtle2']
left ['/turtle1/pose', '/turtle2/pose']
drew to 7.30 6.50 0.50 on 250 10 20
went to 3.00 2.00 -0.50 on 69 86 255
stopped at 11.09 2.00 0.00 on 69 86 255
cleared 11.09 2.00 0.00 on 33 86 255
turned by -0.5, feedback shrinks: True
drove back, and stopped by itself: True
reset 5.54 5.54 0.00 on 33 86 255
""".strip().split("\n")
SAID = """
Starting turtlesim with node name /turtlesim
Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]
Spawning turtle [friend] at x=[1.000000], y=[2.000000], theta=[0.000000]
A turtle named [friend] already exists
Spawning turtle [turtle2] at x=[1.000000], y=[2.000000], theta=[0.000000]
Tried to kill turtle [nobody], which does not exist
Oh no! I hit the wall! (Clamping from [x=20.000000, y=2.000000])
Clearing turtlesim.
Rotation goal completed successfully
Resetting turtlesim.
Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]
""".strip().split("\n")


@pytest.fixture
def url(built: Built, serve: Serve) -> str:
    return serve(built(SITE))


def reading(window: Locator, name: str) -> Locator:
    return window.locator("div", has=window.page.locator(f"dt:text-is('{name}')")).locator("dd")


def drawn(window: Locator, x: float, y: float) -> list[int]:
    """The color of the lines at a place: red, green, blue and how opaque."""
    found: list[int] = window.locator("canvas").evaluate(
        """(canvas, [x, y]) => {
          const fine = canvas.width / 500;
          const at = [x * 45 * fine, (499 - y * 45) * fine].map(Math.round);
          return [...canvas.getContext("2d").getImageData(...at, 1, 1).data];
        }""",
        [x, y],
    )
    return found


def test_turtlesim_does_what_a_visitor_tries(tab: Page, url: str) -> None:
    tab.goto(f"{url}one/")
    turtlesim, visitor = Panel(tab, "turtlesim"), Panel(tab, "visitor")
    turtlesim.start()
    turtlesim.wait_for("Spawning")
    visitor.start()
    visitor.wait_for("reset")
    assert visitor.lines() == TRIED
    assert turtlesim.messages() == SAID


def test_the_window_shows_turtles_and_keys_drive_them(tab: Page, url: str) -> None:
    tab.goto(f"{url}one/")
    window = tab.locator(".ros-robot")
    expect(window).to_contain_text("no publishers")
    drawing = window.get_by_role("application", name="The turtlesim window")
    status = drawing.get_by_role("status")
    expect(status).to_have_text("The turtle appears when turtlesim starts.")
    drawing.focus()
    tab.keyboard.press("ArrowUp")
    expect(status).to_have_text("No turtle to drive. Start turtlesim first.")
    turtlesim = Panel(tab, "turtlesim")
    turtlesim.start()
    expect(window.locator(".ros-turtle")).to_have_count(1)
    expect(status).to_be_hidden()
    expect(reading(window, "Position")).to_have_text("5.54, 5.54")
    assert drawn(window, 6, 5.54)[3] == 0
    drawing.focus()
    tab.keyboard.press("ArrowUp")
    expect(reading(window, "Speed")).to_have_text("2.00")
    expect(reading(window, "Speed")).to_have_text("0.00")
    assert drawn(window, 6, 5.54) == [0xB3, 0xB8, 0xFF, 255]
    window.get_by_role("button", name="Turn left").click()
    expect(reading(window, "Turn")).to_have_text("2.00")
    window.get_by_role("button", name="Reset").click()
    expect(reading(window, "Position")).to_have_text("5.54, 5.54")
    assert drawn(window, 6, 5.54)[3] == 0
    turtlesim.stop()
    expect(window.locator(".ros-turtle")).to_have_count(0)
    expect(status).to_have_text("The turtle appears when turtlesim starts.")


def test_a_launch_file_brings_the_windows_of_its_turtles(tab: Page, url: str) -> None:
    tab.goto(f"{url}two/")
    first, second = tab.locator(".ros-robot").all()
    expect(first).to_contain_text("/first/sim/window from /first/sim")
    expect(second).to_contain_text("/second/sim/window from /second/sim")
    expect(reading(second, "Position")).to_have_text("5.54, 5.54")
    expect(tab.get_by_role("region", name="mimic", exact=True)).to_contain_text("running")
    first.get_by_role("button", name="Forward").click()
    expect(reading(second, "Speed")).to_have_text("2.00")
    expect(reading(second, "Speed")).to_have_text("0.00")
    assert drawn(second, 6, 5.54)[3] == 255


def test_the_program_of_the_demo_draws_a_star(tab: Page, built: Built, serve: Serve) -> None:
    tab.goto(serve(built(DEMO)))
    Panel(tab, "turtlesim").start()
    tab.get_by_role("button", name="Run").click()
    Panel(tab, "star").wait_for("There is a star")
    window = tab.locator(".ros-robot")
    expect(reading(window, "Position")).to_have_text("2.50, 6.50")
    assert drawn(window, 4, 6.5) == [255, 221, 51, 255]
    assert drawn(window, 4, 6)[3] == 0


def test_the_keys_of_a_terminal_are_left_out() -> None:
    site = load(SITE / "site.yaml")
    assert "turtle_teleop_key" not in {n.executable for p in site.pages for n in p.nodes.values()}
    [note] = [note for note in site.notes if "turtle_teleop_key" in note]
    assert note.endswith("reads keys from a terminal; use the arrow keys in the turtlesim window")
