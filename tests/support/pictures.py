"""Take the pictures of the demos on the home page: `python pictures.py [DEMO ...]`."""

from __future__ import annotations

import base64
import sys
import tempfile
from pathlib import Path

from browser import running, serving
from paths import DEMOS, ROOT
from playwright.sync_api import Page, ViewportSize

from sitegen.build import make, write
from sitegen.report import Report

PICTURES = ROOT / "docs" / "images"
# Width to height.
SHAPE = 1.6
TUTORIAL = [
    "Run ros2 run turtlesim turtlesim_node &",
    "Run ros2 topic pub -r 1",
    "Run ros2 topic echo /turtle1/pose --once",
]
# What is pressed in each demo, the text that is waited for, and the part that the picture shows.
SCENES: dict[str, tuple[list[str], str, str]] = {
    "demo01": ([], "Hello, world! 6", ".ros-panel"),
    "demo02": (["Start"], "Hello, world! 5", ".ros-panel"),
    "demo03": (["Start", "Start"], "I heard: 'Hello, world! 5", ".ros-row"),
    "demo04": (["Start", "Start"], "Now a pirouette", ".stage"),
    "demo05": (["Start"] * 3, "I heard: 'Hello, world! 2", ".stage"),
    "demo06": (["Start", "Start"], "I heard: 'Hello, world! 2", ".ros-row"),
    "demo07": (["Start"], "web_node", ".ros-row"),
    "demo08": ([], "STEP", ".ros-row"),
    "demo09": (["Start", "Run"], "There is a star", ".columns"),
    "demo10": (["Random"], "tool at", ".columns"),
    "demo11": ([], "Drive me", ".columns"),
    "demo12": (["Play"], "0:09.", ".columns"),
    "demo13": (["Run all"], "y 5.", ".columns"),
    "demo14": (TUTORIAL, "linear_velocity", ".columns"),
    "demo15": (["Start", "configure", "activate"], "49.", ".columns"),
    "demo16": ([], "Speed", ".columns"),
}
PROMPT = ['node = rclpy.create_node("web_node")', "node.get_name()"]


def take(tab: Page, demo: str, url: str) -> None:
    """Write the picture of `demo`, whose page is at `url`."""
    buttons, text, part = SCENES[demo]
    tab.goto(url)
    for name in buttons:
        # One that was pressed is disabled.
        exact = name in ("Start", "Run")
        tab.get_by_role("button", name=name, exact=exact, disabled=False).first.click()
    if demo == "demo07":
        tab.locator(".ros-state[data-state=running]").first.wait_for()
        for line in PROMPT:
            tab.get_by_role("textbox").first.fill(line)
            tab.keyboard.press("Enter")
    if demo == "demo16":
        stick = tab.locator("#joystick").bounding_box()
        assert stick
        tab.mouse.move(stick["x"] + 100, stick["y"] + 100)
        tab.mouse.down()
        tab.mouse.move(stick["x"] + 60, stick["y"] + 10)
        tab.wait_for_timeout(3000)
    tab.locator(part).first.scroll_into_view_if_needed()
    if tab.locator(".ros-3d").count():
        # The scanner and the meshes come a little later.
        tab.wait_for_timeout(3000)
    tab.locator("main").get_by_text(text).first.wait_for(state="attached", timeout=60_000)
    top = tab.locator(part).first.bounding_box()
    assert top
    corner = {"x": top["x"], "y": top["y"] + tab.evaluate("scrollY")}
    clip = {**corner, "width": top["width"], "height": top["width"] / SHAPE, "scale": 1}
    session = tab.context.new_cdp_session(tab)
    options = {"format": "webp", "quality": 80, "clip": clip, "captureBeyondViewport": True}
    picture = session.send("Page.captureScreenshot", options)["data"]
    (PICTURES / f"{demo}.webp").write_bytes(base64.b64decode(picture))


def main(demos: list[str]) -> None:
    """Write the pictures of `demos`."""
    PICTURES.mkdir(exist_ok=True)
    with running("chromium") as browser, tempfile.TemporaryDirectory() as temporary:
        for demo in demos:
            output = Path(temporary) / demo
            write(make(DEMOS / demo, Report(sys.stderr)).artifacts, output)
            size = ViewportSize(width=880, height=1400)
            tab = browser.new_page(viewport=size, color_scheme="light")
            with serving(output) as url:
                take(tab, demo, url)
                tab.close()


if __name__ == "__main__":
    main(sys.argv[1:] or list(SCENES))
