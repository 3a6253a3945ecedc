"""With a phone, a visitor starts, reads and stops what demos run, and sees what buttons do."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import closing

import pytest
from browser import Built, Serve
from panel import Panel
from paths import ROOT
from playwright.sync_api import Browser, Locator, Page, ViewportSize, expect

PHONE: ViewportSize = {"width": 390, "height": 844}
# As one reads a page: what belongs together begins at the top of the screen.
TO_THE_TOP = "(element) => element.scrollIntoView()"
PANEL = "(element) => element.closest('.stage') ?? element.closest('.ros-panel')"
TOP = "(element) => Math.round(element.getBoundingClientRect().top)"
# Where a panel is when it is touched: what drives the browser may scroll before it touches.
NOTE_PLACE = f"""(element) => addEventListener(
  "pointerdown",
  () => {{ element.place = ({TOP})(element); }},
  {{ capture: true, once: true }},
)"""


class Visitor:
    """A finger on a page of a demo."""

    def __init__(self, page: Page) -> None:
        self.page = page

    def press(self, button: Locator, effect: Locator, text: str = "") -> None:
        """Press a button and see, without scrolling, that `effect` is there and has the text."""
        panel = button.evaluate_handle(PANEL)
        panel.evaluate(TO_THE_TOP)
        panel.evaluate(NOTE_PLACE)
        button.tap()
        if text:
            expect(effect).to_contain_text(text)
        expect(effect).to_be_in_viewport(ratio=0.9)
        if button.count():
            expect(button).to_be_in_viewport(ratio=0.9)
        assert panel.evaluate(TOP) == panel.evaluate("(element) => element.place")

    def start(self, node: str, effect: Locator | None = None, text: str = "") -> None:
        """Start a node, and see the newest line of its console unless there is another effect."""
        panel = Panel(self.page, node)
        line = panel.console.locator("> :last-child")
        self.press(panel.button("Start"), effect or line, text)

    def stop(self, node: str) -> None:
        panel = Panel(self.page, node)
        panel.expect_started()
        self.press(panel.button("Stop"), panel.panel.locator(".ros-state").first, "stopped")


def demo01(visitor: Visitor) -> None:
    console = Panel(visitor.page, "talker").console
    expect(console).to_contain_text("Hello, world! 1'")
    console.evaluate_handle(PANEL).evaluate(TO_THE_TOP)
    expect(console.locator("> :last-child")).to_be_in_viewport(ratio=0.9)


def demo02(visitor: Visitor) -> None:
    visitor.start("talker", text="Hello, world!")
    visitor.stop("talker")


def demo03(visitor: Visitor) -> None:
    visitor.start("talker", text="Hello, world!")
    visitor.start("listener", text="I heard")
    visitor.stop("listener")
    visitor.stop("talker")


def demo04(visitor: Visitor) -> None:
    robot = visitor.page.get_by_role("region", name="Robot")
    visitor.start("dance", robot.get_by_role("img"))
    visitor.start("colors", robot.get_by_role("img"))
    visitor.press(robot.get_by_role("button", name="Reset"), robot.get_by_role("img"))
    visitor.stop("dance")
    visitor.stop("colors")


def demo05(visitor: Visitor) -> None:
    page = visitor.page
    drawing = page.locator(".ros-graph svg")
    for node in ("talker", "listener", "client"):
        visitor.start(node, drawing.locator(".ros-node-box").last)
    # Each program adds its node: four boxes when the server is there, too.
    first = page.get_by_role("button", name="Start server first")
    visitor.press(first, drawing.locator(".ros-node-box", has_text="/add_two_ints_server"))
    for tab, panel in (
        ("Topics", ".ros-topics .ros-table"),
        ("Services", ".ros-services .ros-list"),
    ):
        visitor.press(page.locator(".tabbed-labels").get_by_text(tab), page.locator(panel))
    for node in ("talker", "listener", "server"):
        visitor.stop(node)


def demo06(visitor: Visitor) -> None:
    visitor.start("listener", Panel(visitor.page, "listener").panel.get_by_role("log"))
    visitor.start("talker", text="Hello, world!")
    visitor.stop("talker")
    visitor.stop("listener")


def demo07(visitor: Visitor) -> None:
    panel = visitor.page.get_by_role("region", name="shell", exact=True)
    line = panel.get_by_role("log").locator("> :last-child")
    visitor.press(panel.get_by_role("button", name="Start"), line, "rclpy is imported")
    panel.get_by_role("textbox").fill("40 + 2")
    panel.get_by_role("textbox").press("Enter")
    expect(line).to_have_text("42")
    expect(line).to_be_in_viewport(ratio=0.9)
    visitor.stop("shell")


def demo08(visitor: Visitor) -> None:
    panel = Panel(visitor.page, "counter", region="counter: Editor")
    line = panel.console.locator("> :last-child")
    visitor.press(panel.button("Run"), line, "Now it is")
    visitor.press(panel.button("Stop"), panel.panel.locator(".ros-state").first, "stopped")


def demo09(visitor: Visitor) -> None:
    page = visitor.page
    paper = page.get_by_role("application")
    star = Panel(page, "star", region="star: Editor")
    run, line = star.button("Run"), star.console.locator("> :last-child")
    # Nobody is at a loss who starts with the program instead of the turtle.
    visitor.press(run, page.get_by_text("star needs turtlesim.").first)
    first = page.get_by_role("button", name="Start turtlesim first").first
    # Where the program is changed, its output is seen.
    visitor.press(first, line, "of 5")
    visitor.press(page.get_by_role("button", name="Turn left"), paper)
    visitor.press(run, line, "of 5")
    visitor.press(star.button("Stop"), star.panel.locator(".ros-state").first, "stopped")
    visitor.stop("turtlesim")


def demo10(visitor: Visitor) -> None:
    page = visitor.page
    line = page.get_by_role("region", name="trace", exact=True).locator(".ros-lines > :last-child")
    expect(line).to_contain_text("tool at 0.24 0.00 0.88")
    slider = page.get_by_label("elbow", exact=True)
    slider.scroll_into_view_if_needed()
    slider.fill("1.5")
    expect(line).not_to_contain_text("0.88")


def demo11(visitor: Visitor) -> None:
    page = visitor.page
    # In the console and in the log.
    expect(page.get_by_text("Drive me: I listen to /cmd_vel").first).to_be_attached()
    # A phone has no keys.
    expect(page.get_by_text("Drag the stick to drive. A gamepad works, too.")).to_be_attached()
    stick = page.locator(".ros-stick")
    stick.scroll_into_view_if_needed()
    box = stick.bounding_box()
    assert box
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"])
    # The rover goes straight ahead, until a wall stops it.
    expect(page.get_by_text("Bump! A wall").first).to_be_attached()
    page.mouse.up()


def demo12(visitor: Visitor) -> None:
    page = visitor.page
    player = page.get_by_role("region", name="Player")
    time = player.locator(".ros-bag-time")
    # A bag is loaded when someone looks at it.
    page.locator(".ros-bag").scroll_into_view_if_needed()
    expect(page.locator(".ros-bag-row")).to_have_count(1)
    expect(page.locator(".ros-turtle")).to_be_attached()
    visitor.press(player.get_by_role("button", name="Play", exact=True), time, "0:01.")
    visitor.press(player.get_by_role("button", name="Pause", exact=True), time)


def demo13(visitor: Visitor) -> None:
    page = visitor.page
    run = page.get_by_role("button", name="Run cell 1", exact=True)
    visitor.press(run, page.locator(".ros-output").first.locator("> :last-child"), "'notebook'")


def demo14(visitor: Visitor) -> None:
    page = visitor.page
    screen = page.locator(".ros-screen")
    for command, printed in [
        ("ros2 run turtlesim turtlesim_node &", "Spawning turtle"),
        ("ros2 node list", "/turtlesim"),
    ]:
        page.get_by_role("button", name=f"Run {command}", exact=True).tap()
        expect(screen).to_be_in_viewport(ratio=0.9)
        expect(screen).to_contain_text(printed)
    # What the phone's keyboard lacks.
    page.keyboard.type("ros2 ser")
    page.get_by_role("button", name="Tab", exact=True).tap()
    expect(screen).to_contain_text("ros2 service")


def demo15(visitor: Visitor) -> None:
    page = visitor.page
    visitor.start("camera", page.locator(".ros-state").first, "running")
    # What can be done next takes the place of what was pressed.
    for transition, then in [("configure", "activate"), ("activate", "deactivate")]:
        button, next_one = (
            page.get_by_role("button", name=n, exact=True) for n in (transition, then)
        )
        visitor.press(button, next_one)
    expect(page.locator(".ros-managed-state")).to_have_text("active")


def demo16(visitor: Visitor) -> None:
    page = visitor.page
    stick = page.locator("#joystick")
    paper = page.get_by_role("application", name="turtlesim window")
    stick.evaluate(TO_THE_TOP)
    expect(paper).to_be_in_viewport(ratio=0.9)
    expect(page.locator(".ros-turtle")).to_be_attached()
    heading = page.locator(".ros-readings > *").filter(has_text="Heading")
    before = heading.inner_text()
    box = stick.bounding_box()
    assert box
    # What touches the stick does not scroll the page.
    finger = page.context.new_cdp_session(page)
    for type, down in (("touchStart", 0.5), ("touchMove", 0.7), ("touchMove", 0.9)):
        at = {"x": box["x"] + box["width"] * 0.3, "y": box["y"] + box["height"] * down}
        finger.send("Input.dispatchTouchEvent", {"type": type, "touchPoints": [at]})
    expect(heading).not_to_have_text(before)
    assert stick.evaluate(TOP) == round(box["y"])
    finger.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    expect(page.locator(".ros-readings")).to_contain_text("Speed0.00")


VISITS = (
    *(demo01, demo02, demo03, demo04, demo05, demo06, demo07, demo08, demo09, demo10, demo11),
    *(demo12, demo13, demo14, demo15, demo16),
)


@pytest.fixture
def phone(browser: Browser, serve: Serve) -> Iterator[Page]:
    with closing(browser.new_context(viewport=PHONE, has_touch=True, is_mobile=True)) as context:
        yield context.new_page()


@pytest.mark.parametrize("visit", VISITS, ids=lambda visit: visit.__name__)
def test_button_and_effect_are_seen_together(
    visit: Callable[[Visitor], None], phone: Page, built: Built, serve: Serve
) -> None:
    phone.goto(f"{serve(built(ROOT))}{visit.__name__}/")
    visit(Visitor(phone))
    assert phone.evaluate("document.documentElement.scrollWidth") == PHONE["width"]
