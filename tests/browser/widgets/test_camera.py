"""The visitor's camera: a fake one of Chromium, whose image has a turning disc on green."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import FLAGS, WHOLE_CHROMIUM, Serve
from playwright.sync_api import Browser, Locator, expect
from playwright.sync_api import Page as Tab
from stage import WIDER, hide_tab, show

from sitegen.site.pages.policy import policy

pytestmark = pytest.mark.chromium

RAW, COMPRESSED = "sensor_msgs/msg/Image", "sensor_msgs/msg/CompressedImage"
INFO = "sensor_msgs/msg/CameraInfo"
FAKE = ["--use-fake-device-for-media-stream", "--use-fake-ui-for-media-stream"]


@pytest.fixture(scope="module")
def filming(browser: Browser) -> Iterator[Browser]:
    """A Chromium with a camera, which pages may use."""
    filming = browser.browser_type.launch(executable_path=WHOLE_CHROMIUM, args=[*FLAGS, *FAKE])
    yield filming
    filming.close()


@pytest.fixture
def filmed(filming: Browser, stage: Tab) -> Iterator[Tab]:
    """A stage in this browser, whose types are those of a node that processes images."""
    page = filming.new_page()
    page.goto(stage.url)
    page.wait_for_selector("body[data-ready]")
    page.evaluate(
        "(all) => { for (const type of all) ros.types[type] = ros.fields('uint32 width'); }",
        [RAW, COMPRESSED, INFO],
    )
    yield page
    page.close()


def published(tab: Tab, topic: str, count: int = 1) -> None:
    tab.wait_for_function(
        "([topic, count]) => ros.published.filter((one) => one.topic === topic).length >= count",
        arg=[topic, count],
    )


def start(panel: Locator) -> None:
    panel.get_by_role("button", name="Start camera").click()


def test_a_camera_publishes_until_it_is_stopped(filmed: Tab) -> None:
    panel = show(filmed, "camera", {"topic": "/front/image_raw", "width": 160, "rate": 20})
    expect(panel).to_contain_text("Your camera is off. Its images stay on this page.")
    assert filmed.evaluate("ros.published") == []
    start(panel)
    published(filmed, "/front/image_raw", 3)
    found = filmed.evaluate(
        """() => {
          const [{ type, message }] = ros.published.filter(({ topic }) => topic === "/front/image_raw");
          const { header, data, ...rest } = message;
          return { type, ...rest, size: data.length, plain: data instanceof Uint8Array,
            green: data[1] > data[0] && data[1] > data[2],
            age: Date.now() / 1000 - header.stamp.sec, frame: header.frame_id };
        }"""  # noqa: E501
    )
    assert found["age"] < 60
    assert found | {"age": 0} == {
        "type": RAW, "width": 160, "height": 120, "encoding": "rgb8", "is_bigendian": 0,
        "step": 480, "size": 160 * 120 * 3, "plain": True, "green": True, "frame": "camera",
        "age": 0,
    }  # fmt: skip
    published(filmed, "/front/camera_info")
    info = filmed.evaluate("ros.published.find(({ type }) => type.endsWith('Info')).message")
    assert (info["width"], info["height"]) == (160, 120)
    expect(panel.get_by_role("status")).to_contain_text("images published")
    panel.get_by_role("button", name="Stop").click()
    count = filmed.evaluate("ros.published.length")
    assert filmed.evaluate("ros.closed") == 2
    expect(panel.get_by_role("button", name="Start camera")).to_be_focused()
    filmed.wait_for_timeout(300)
    assert filmed.evaluate("ros.published.length") == count
    filmed.set_viewport_size({"width": 390, "height": 800})
    assert filmed.evaluate(WIDER) <= 0


def test_a_camera_compresses(filmed: Tab) -> None:
    options = {"topic": "/image", "compressed": True, "info": "/info", "frame": "eye"}
    panel = show(filmed, "camera", options)
    start(panel)
    published(filmed, "/image")
    found = filmed.evaluate(
        """async () => {
          const { type, message } = ros.published.find(({ topic }) => topic === "/image");
          const { width } = await createImageBitmap(new Blob([message.data]));
          return [type, message.format, message.header.frame_id, width, [...message.data.subarray(0, 2)]];
        }"""  # noqa: E501
    )
    assert found == [COMPRESSED, "jpeg", "eye", 320, [0xFF, 0xD8]]
    published(filmed, "/info")


def test_a_camera_stops_when_it_is_hidden(filmed: Tab) -> None:
    panel = show(filmed, "camera", {"topic": "/image"})
    start(panel)
    published(filmed, "/image")
    hide_tab(filmed, True)
    hide_tab(filmed, False)
    expect(panel.get_by_role("status")).to_have_text("Stopped because the page was hidden.")
    start(panel)
    expect(panel.get_by_role("button", name="Stop")).to_be_enabled()
    filmed.evaluate("document.querySelector('.ros-row').hidden = true")
    filmed.wait_for_function("() => ros.closed === 4")
    filmed.evaluate("document.querySelector('.ros-row').hidden = false")
    expect(panel.get_by_role("status")).to_have_text("Stopped because the panel was hidden.")
    start(panel)
    expect(panel.get_by_role("button", name="Stop")).to_be_enabled()
    tracks = filmed.evaluate(
        """() => {
          // Switched off with the panel, also one that is still being switched on.
          const get = navigator.mediaDevices.getUserMedia.bind(navigator.mediaDevices);
          navigator.mediaDevices.getUserMedia = async (wanted) => (window.late = await get(wanted));
          unmount();
          return ros.closed;
        }"""
    )
    assert tracks == 6
    panel = show(filmed, "camera", {"topic": "/image"})
    filmed.evaluate("() => { document.querySelector('.ros-start').click(); unmount(); }")
    filmed.wait_for_function(
        "() => window.late?.getTracks().every((t) => t.readyState === 'ended')"
    )
    assert filmed.evaluate("ros.closed") == 6


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("NotAllowedError", "Access to the camera was refused."),
        ("NotFoundError", "No camera was found."),
        ("NotReadableError", "The camera does not respond."),
        ("SecurityError", "The browser does not allow cameras here."),
        ("OddError", "The camera cannot be used: for some reason"),
    ],
)
def test_why_there_is_no_camera_is_said(filmed: Tab, name: str, said: str) -> None:
    panel = show(filmed, "camera", {"topic": "/image"})
    filmed.evaluate(
        """(name) => {
          navigator.mediaDevices.getUserMedia = () => Promise.reject(new DOMException("for some reason", name));
        }""",  # noqa: E501
        name,
    )
    start(panel)
    expect(panel.get_by_role("status")).to_contain_text(said)
    expect(panel.get_by_role("button", name="Start camera")).to_be_enabled()
    assert filmed.evaluate("ros.published") == []


def test_a_camera_needs_a_page_that_may_use_it_and_a_type(filmed: Tab) -> None:
    panel = show(filmed, "camera", {"topic": "/image"})
    filmed.evaluate(
        "Object.defineProperty(navigator, 'mediaDevices', { value: undefined, configurable: true })"
    )
    start(panel)
    expect(panel.get_by_role("status")).to_contain_text("Browsers allow cameras only on https://")
    filmed.evaluate("(raw) => { unmount(); delete ros.types[raw]; }", RAW)
    panel = show(filmed, "camera", {"topic": "/image"})
    expect(panel).to_contain_text(f"No node of this page uses {RAW}, so the page cannot publish it")
    expect(panel.get_by_role("button", name="Start camera")).to_be_disabled()


def test_a_full_queue_is_no_end(filmed: Tab, serve: Serve) -> None:
    panel = show(filmed, "camera", {"topic": "/image", "rate": 30})
    filmed.evaluate(
        """() => {
          let left = 2;
          const { advertise } = ros;
          ros.advertise = (...topic) => {
            const publisher = advertise(...topic);
            const publish = (message) => {
              if (left-- > 0) throw new Error("the queues are full");
              publisher.publish(message);
            };
            return { ...publisher, publish };
          };
        }"""
    )
    start(panel)
    published(filmed, "/image", 2)
    expect(panel.get_by_role("status")).to_contain_text("published")


def test_the_policy_of_pages_allows_it(filmed: Tab, tmp_path: Path) -> None:
    page = tmp_path / "index.html"
    # The stage has scripts of its own, which pages have not.
    rules = policy("", live=True, fonts=False, offline=False)
    rules = re.sub(r"script-src [^;]*", "script-src 'self' 'unsafe-inline'", rules)
    meta = f'<meta http-equiv="Content-Security-Policy" content="{rules}">'
    page.write_text(page.read_text().replace("<title>", f"{meta}<title>"))
    filmed.reload()
    filmed.wait_for_selector("body[data-ready]")
    filmed.evaluate("(type) => { ros.types[type] = ros.fields('string format'); }", COMPRESSED)
    panel = show(filmed, "camera", {"topic": "/image", "compressed": True})
    start(panel)
    published(filmed, "/image")
    assert filmed.evaluate("ros.published[0].message.data.length") > 500
