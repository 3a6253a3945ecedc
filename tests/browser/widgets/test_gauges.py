"""Values, images and the visitor's camera with a real C++ node at the other end."""

from __future__ import annotations

import pytest
from browser import FLAGS, WHOLE_CHROMIUM, Built, Serve, opened
from panel import Panel
from paths import SITES
from playwright.sync_api import Browser, expect
from playwright.sync_api import Page as Tab

# Browsers have a camera of their own for tests; it shows a green picture with a moving pie.
FAKE = ["--use-fake-device-for-media-stream", "--use-fake-ui-for-media-stream"]
# The colours of the drawn image, from left to right.
COLOURS = """(canvas) => {
  const { width, height } = canvas;
  const copy = new OffscreenCanvas(width, height);
  const context = copy.getContext("2d");
  context.drawImage(canvas, 0, 0);
  const pixel = (x) => [...context.getImageData(x, height / 2, 1, 1).data];
  return [width, height, pixel(0), pixel(width - 1)];
}"""


def test_a_value_follows_the_node(tab: Tab, serve: Serve, built: Built) -> None:
    tab.goto(f"{serve(built(SITES / 'instruments'))}gauges/")
    panel = tab.locator(".ros-value")
    panel.scroll_into_view_if_needed()
    # The battery is full at first, and empty after a second.
    expect(panel.locator(".ros-figure")).to_have_text("15 %")
    expect(panel.get_by_role("status")).to_have_text("empty")
    expect(panel.get_by_role("meter")).to_have_attribute("aria-valuetext", "15 %")
    # It is no longer true when the node has ended.
    Panel(tab, "gauges").stop()
    expect(panel).to_contain_text("/battery has no publishers now")


def test_an_image_has_the_pixels_of_the_node(tab: Tab, serve: Serve, built: Built) -> None:
    tab.goto(f"{serve(built(SITES / 'instruments'))}gauges/")
    panel = tab.locator(".ros-image")
    panel.scroll_into_view_if_needed()
    canvas = panel.locator("canvas")
    expect(canvas).to_have_attribute("width", "4")
    assert canvas.evaluate(COLOURS) == [4, 2, [250, 20, 10, 255], [10, 20, 250, 255]]
    with tab.expect_download() as download:
        panel.get_by_role("button", name="Save").click()
    assert download.value.suggested_filename.endswith(".png")


@pytest.mark.chromium
def test_a_node_sees_through_the_visitors_camera(
    browser: Browser, serve: Serve, built: Built
) -> None:
    url = f"{serve(built(SITES / 'instruments'))}gauges/"
    filming = browser.browser_type.launch(executable_path=WHOLE_CHROMIUM, args=[*FLAGS, *FAKE])
    with opened(filming) as tab:
        tab.goto(url)
        panel = tab.locator(".ros-camera")
        panel.scroll_into_view_if_needed()
        panel.get_by_role("button", name="Start camera").click()
        node = Panel(tab, "gauges")
        node.wait_for("camera 160x120 rgb8 in camera, 57600 bytes")
        node.wait_for("camera info 160x120")
    filming.close()
