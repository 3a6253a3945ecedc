"""Images in a real browser: each encoding by its pixels, and the panel."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Locator, expect
from playwright.sync_api import Page as Tab
from saving import saved
from stage import WIDER, add, hide_tab, show, subscribed

from sitegen.site.pages.policy import policy

pytestmark = pytest.mark.firefox

RAW, COMPRESSED = "sensor_msgs/msg/Image", "sensor_msgs/msg/CompressedImage"
RED, GREEN, BLUE = [255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255]
CLEAR = [0, 0, 0, 0]


def grey(*values: int) -> list[list[int]]:
    return [[value, value, value, 255] for value in values]


def decode(
    stage: Tab,
    encoding: str,
    width: int,
    height: int,
    data: list[int],
    *,
    step: int = 0,
    big: bool = False,
    low: float | None = None,
    high: float | None = None,
) -> Any:
    """The pixels of an image, or what is said in place of them."""
    image = {"encoding": encoding, "width": width, "height": height, "step": step}
    return stage.evaluate(
        """async ([image, data, big, low, high]) => {
          const { decode } = await import("./runtime/widgets/image/decode.js");
          try {
            // In the middle of a buffer, at an odd address, as in messages.
            const bytes = new Uint8Array(data.length + 3);
            bytes.set(data, 3);
            const whole = { ...image, is_bigendian: big ? 1 : 0, data: bytes.subarray(3) };
            const found = [...decode(whole, { low: low ?? NaN, high: high ?? NaN }).data];
            const quad = (_, n) => found.slice(4 * n, 4 * n + 4);
            return Array.from({ length: found.length / 4 }, quad);
          } catch (error) {
            return error.message;
          }
        }""",
        [image, data, big, low, high],
    )


@pytest.mark.parametrize(
    ("encoding", "data", "pixels"),
    [
        ("rgb8", [255, 0, 0, 0, 0, 255], [RED, BLUE]),
        ("bgr8", [255, 0, 0, 0, 0, 255], [BLUE, RED]),
        ("8UC3", [255, 0, 0, 0, 0, 255], [BLUE, RED]),
        ("rgba8", [255, 0, 0, 255, 1, 2, 3, 4], [RED, [1, 2, 3, 4]]),
        ("bgra8", [255, 0, 0, 255, 1, 2, 3, 4], [BLUE, [3, 2, 1, 4]]),
        ("8UC4", [255, 0, 0, 255, 1, 2, 3, 4], [BLUE, [3, 2, 1, 4]]),
        ("mono8", [0, 200], grey(0, 200)),
        ("8UC1", [7, 9], grey(7, 9)),
        # Brightness 16 is black and 235 is white, without colour.
        ("yuv422", [128, 16, 128, 235], grey(0, 255)),
        ("uyvy", [128, 16, 128, 235], grey(0, 255)),
        ("yuv422_yuy2", [16, 128, 235, 128], grey(0, 255)),
        ("yuyv", [16, 128, 235, 128], grey(0, 255)),
        # The smallest value is black, the largest white; 0 is no depth, but black.
        ("mono16", [0, 0, 255, 255], grey(0, 255)),
        ("16UC1", [0, 0, 10, 0], [CLEAR, grey(128)[0]]),
        ("32FC1", [0, 0, 128, 63, 0, 0, 0, 64], grey(0, 255)),
        ("32FC1", [0, 0, 192, 127, 0, 0, 0, 64], [CLEAR, grey(128)[0]]),
    ],
)
def test_each_encoding_has_its_pixels(
    stage: Tab, encoding: str, data: list[int], pixels: list[list[int]]
) -> None:
    assert decode(stage, encoding, 2, 1, data) == pixels
    # Rows may be padded, by any number of bytes; the last one need not be.
    padded = [*data, 99, 98, 97, *data]
    assert decode(stage, encoding, 2, 2, padded, step=len(data) + 3) == [*pixels, *pixels]
    said = decode(stage, encoding, 2, 2, padded[:-1], step=len(data) + 3)
    assert said == (
        f"The image has {len(padded) - 1} bytes of data; "
        f"2 \u00d7 2 pixels in {encoding} need {len(padded)}"
    )


def test_colours_of_video_are_converted(stage: Tab) -> None:
    # Red, green and blue in BT.601.
    for yuv, rgb in (((81, 90, 240), RED), ((145, 54, 34), GREEN), ((41, 240, 110), BLUE)):
        y, u, v = yuv
        [one, two] = decode(stage, "yuv422", 2, 1, [u, y, v, y])
        assert one == two
        assert one == pytest.approx(rgb, abs=3)
        assert decode(stage, "yuv422_yuy2", 2, 1, [y, u, y, v]) == [one, two]


def test_the_order_of_bytes_counts(stage: Tab) -> None:
    little, big = [0, 0, 0, 1, 0, 2], [0, 0, 1, 0, 2, 0]
    assert decode(stage, "mono16", 3, 1, little) == grey(0, 128, 255)
    assert decode(stage, "mono16", 3, 1, big, big=True) == grey(0, 128, 255)
    assert decode(stage, "mono16", 3, 1, big) == grey(0, 128, 255)
    assert decode(stage, "mono16", 3, 1, [0, 0, 1, 0, 0, 1], big=True) == grey(0, 255, 1)
    floats = [63, 128, 0, 0, 64, 0, 0, 0]
    assert decode(stage, "32FC1", 2, 1, floats, big=True) == grey(0, 255)


def test_depth_has_a_range(stage: Tab) -> None:
    metres = [232, 3, 208, 7, 184, 11]  # 1000, 2000 and 3000
    assert decode(stage, "16UC1", 3, 1, metres) == grey(0, 128, 255)
    assert decode(stage, "16UC1", 3, 1, metres, low=0, high=4000) == grey(64, 128, 191)
    assert decode(stage, "16UC1", 3, 1, metres, low=2000) == grey(0, 0, 255)
    nothing = [0, 0, 192, 127, 0, 0, 128, 127, 0, 0, 128, 255]  # NaN and the infinities
    assert [alpha for *_, alpha in decode(stage, "32FC1", 3, 1, nothing)] == [0, 0, 0]


@pytest.mark.parametrize("pattern", ["rggb", "bggr", "gbrg", "grbg"])
def test_the_colours_of_a_sensor_are_put_together(stage: Tab, pattern: str) -> None:
    width, height = 6, 4
    for part, colour in enumerate((RED, GREEN, BLUE)):
        seen = [
            255 if "rgb".index(pattern[2 * (y % 2) + x % 2]) == part else 0
            for y in range(height)
            for x in range(width)
        ]
        assert decode(stage, f"bayer_{pattern}8", width, height, seen) == [colour] * len(seen)
    # What a pixel sees itself is exact.
    values = list(range(10, 10 + width * height))
    pixels = decode(stage, f"bayer_{pattern}8", width, height, values)
    for y in range(height):
        for x in range(width):
            own = "rgb".index(pattern[2 * (y % 2) + x % 2])
            assert pixels[y * width + x][own] == values[y * width + x]
    assert decode(stage, f"bayer_{pattern}8", 1, 1, [9])[0][3] == 255


@pytest.mark.parametrize(
    ("encoding", "width", "height", "step", "said"),
    [
        ("nv12", 2, 2, 2, "The encoding 'nv12' is not supported; use one of rgb8, bgr8,"),
        ("constructor", 2, 2, 2, "The encoding 'constructor' is not supported"),
        ("x" * 999, 2, 2, 2, "The encoding 'xxxx"),
        ("rgb8", 0, 2, 6, "The image is empty: 0 \u00d7 2 pixels"),
        ("rgb8", 2, 2, 5, "step is 5, but a row of 2 pixels in rgb8 has 6 bytes"),
        ("rgb8", 4000000000, 4000000000, 0, "The image is too large"),
        ("mono8", 30000, 1000, 0, "The image has 12 bytes of data; 30000 \u00d7 1000 pixels in"),
        ("yuv422", 3, 2, 6, "yuv422 needs an even width, not 3"),
    ],
)
def test_wrong_images_are_explained(
    stage: Tab, encoding: str, width: int, height: int, step: int, said: str
) -> None:
    found = decode(stage, encoding, width, height, [0] * 12, step=step)
    assert found.startswith(said)
    assert len(found) < 300


@pytest.fixture
def camera(stage: Tab) -> Tab:
    """A stage with a topic of images, and one of compressed ones."""
    stage.evaluate(
        """([raw, compressed]) => {
          ros.types["std_msgs/msg/Header"] = ros.fields("builtin_interfaces/msg/Time stamp, string frame_id");
          ros.types[raw] = ros.fields("std_msgs/msg/Header header, uint32 height, uint32 width, string encoding, uint8[] data");
          ros.types[compressed] = ros.fields("std_msgs/msg/Header header, string format, uint8[] data");
          window.send = async (encoding, width, height, data, more = {}) => {
            ros.emit("/raw", { encoding, width, height, step: 0, is_bigendian: 0, data: Uint8Array.from(data), ...more });
            await frames();
          };
          window.compress = async (type, colour, size = 4) => {
            const canvas = new OffscreenCanvas(size, size);
            const paper = canvas.getContext("2d");
            paper.fillStyle = colour;
            paper.fillRect(0, 0, size, size);
            const data = new Uint8Array(await (await canvas.convertToBlob({ type })).arrayBuffer());
            ros.emit("/small", { format: type.slice(6), data });
            await frames(10);
          };
        }""",  # noqa: E501
        [RAW, COMPRESSED],
    )
    add(stage, "publisher", "/camera", "/raw", RAW)
    add(stage, "publisher", "/camera", "/small", COMPRESSED)
    return stage


def pixel(panel: Locator, x: int = 0, y: int = 0) -> list[int]:
    found: list[int] = panel.locator("canvas").evaluate(
        "(canvas, [x, y]) => [...canvas.getContext('2d').getImageData(x, y, 1, 1).data]", [x, y]
    )
    return found


def test_images_are_drawn(camera: Tab) -> None:
    panel = show(camera, "image", {"topic": "/raw"})
    expect(panel).to_contain_text("No message yet")
    expect(panel.get_by_role("button", name="Save")).to_be_disabled()
    camera.evaluate("send('rgb8', 2, 1, [255, 0, 0, 0, 0, 255])")
    assert [pixel(panel, 0), pixel(panel, 1)] == [RED, BLUE]
    expect(panel.get_by_role("img")).to_have_attribute(
        "aria-label", "Image of /raw: 2 \u00d7 1, rgb8"
    )
    camera.evaluate("send('rgb8', 2, 1, [255])")
    expect(panel.get_by_role("status")).to_contain_text("The image has 1 bytes of data")
    camera.evaluate("send('mono8', 3, 3, Array(9).fill(50))")
    expect(panel.locator(".ros-note")).to_be_hidden()
    assert pixel(panel, 2, 2) == grey(50)[0]


@pytest.mark.parametrize("format", ["jpeg", "png", "webp"])
def test_compressed_images_are_drawn(camera: Tab, format: str) -> None:
    panel = show(camera, "image", {"topic": "/small"})
    camera.evaluate("(type) => compress(type, 'red')", f"image/{format}")
    expect(panel.get_by_text("4 \u00d7 4")).to_be_visible()
    assert pixel(panel, 1, 1) == pytest.approx(RED, abs=6)
    camera.evaluate("ros.emit('/small', { format: 'jpeg', data: Uint8Array.of(1, 2, 3) })")
    expect(panel.get_by_role("status")).to_have_text(
        "The browser cannot decode this image; its format is 'jpeg'"
    )
    camera.evaluate(
        "ros.emit('/small', { format: '16UC1; compressedDepth png', data: new Uint8Array(9) })"
    )
    expect(panel.get_by_role("status")).to_contain_text("Compressed depth images are not supported")


def test_only_the_newest_image_is_decoded(camera: Tab) -> None:
    panel = show(camera, "image", {"topic": "/raw"})
    decoded = camera.evaluate(
        """async () => {
          let count = 0;
          const put = CanvasRenderingContext2D.prototype.putImageData;
          CanvasRenderingContext2D.prototype.putImageData = function (...image) {
            count++;
            put.apply(this, image);
          };
          for (let n = 0; n < 100; n++) {
            const data = Uint8Array.of(n);
            ros.emit("/raw", { encoding: "mono8", width: 1, height: 1, step: 1, data });
          }
          await frames(5);
          return count;
        }"""
    )
    assert decoded == 1
    assert pixel(panel) == grey(99)[0]
    hide_tab(camera, True)
    assert subscribed(camera) == []
    hide_tab(camera, False)
    assert subscribed(camera) == ["/raw"]


# Count what is drawn in each frame, while each look at the clock takes a millisecond.
SLOW = """() => {
  let time = 0;
  performance.now = () => time++;
  window.drawn = [0];
  const next = () => {
    drawn.push(0);
    requestAnimationFrame(next);
  };
  requestAnimationFrame(next);
  const put = CanvasRenderingContext2D.prototype.putImageData;
  CanvasRenderingContext2D.prototype.putImageData = function (...image) {
    drawn[drawn.length - 1]++;
    put.apply(this, image);
  };
}"""
SHOWN = """([width, value]) => {
  const canvas = document.querySelector("canvas");
  if (canvas.width !== width) return false;
  return canvas.getContext("2d").getImageData(width - 1, canvas.height - 1, 1, 1).data[0] === value;
}"""


def test_a_large_image_is_decoded_over_several_frames(camera: Tab) -> None:
    panel = show(camera, "image", {"topic": "/raw"})
    camera.evaluate(SLOW)
    camera.evaluate(
        """() => {
          const data = Uint8Array.from({ length: 2000 * 1500 }, (_, at) => at % 250);
          for (let row = 0; row < 1500; row++) data[row * 2000] = row % 200;
          ros.emit("/raw", { encoding: "mono8", width: 2000, height: 1500, step: 0, data });
        }"""
    )
    camera.wait_for_function(SHOWN, arg=[2000, 249])
    counts = [count for count in camera.evaluate("drawn") if count]
    assert len(counts) > 5
    assert max(counts) < 12
    for row in (0, 15, 16, 17, 800, 1499):
        assert pixel(panel, 0, row) == grey(row % 200)[0]
        assert pixel(panel, 777, row) == grey(27)[0]
    expect(panel).to_contain_text("2000 \u00d7 1500, mono8")
    name, content = saved(panel.get_by_role("button", name="Save"))
    assert (name, content[:4]) == ("image.png", b"\x89PNG")
    # It has the place of the one before, and so has a small one.
    box = panel.locator("canvas").bounding_box()
    area = panel.get_by_role("img").bounding_box()
    assert box
    assert area
    assert box["height"] == pytest.approx(min(area["height"], area["width"] * 3 / 4), abs=2)
    camera.evaluate("send('mono8', 1, 1, [9])")
    assert pixel(panel) == grey(9)[0]


def test_only_the_newest_of_large_images_is_decoded(camera: Tab) -> None:
    show(camera, "image", {"topic": "/raw"})
    camera.evaluate(SLOW)
    camera.evaluate(
        """async () => {
          window.large = (value) => ros.emit("/raw", { encoding: "16UC1", width: 1000, height: 1000,
            step: 0, data: new Uint8Array(2_000_000).fill(value).fill(1, 0, 2) });
          large(2);
          await frames(2);
          for (let value = 3; value <= 9; value++) large(value);
        }"""
    )
    camera.wait_for_function(SHOWN, arg=[1000, 255])
    whole = 32
    camera.wait_for_function("(whole) => drawn.reduce((a, b) => a + b) >= 2 * whole", arg=whole)
    camera.evaluate("frames(10)")
    # The first, and the last of those that came while it was decoded.
    assert sum(camera.evaluate("drawn")) == 2 * whole
    # In another range, it is drawn again.
    camera.get_by_label("depth that is white").fill("60000")
    camera.get_by_label("depth that is white").dispatch_event("change")
    camera.wait_for_function(SHOWN, arg=[1000, round(255 * (9 * 257 - 257) / (60000 - 257))])
    # It is given up when nobody looks.
    before = sum(camera.evaluate("drawn"))
    camera.evaluate("large(11)")
    camera.evaluate("frames(2)")
    camera.evaluate("unmount()")
    camera.evaluate("frames(10)")
    assert sum(camera.evaluate("drawn")) < before + whole


def test_visitors_choose_the_topic_and_the_range(camera: Tab) -> None:
    add(camera, "publisher", "/talker", "/chatter", "std_msgs/msg/String")
    panel = show(camera, "image")
    expect(panel.get_by_label("topic").locator("option")).to_have_text(["/raw", "/small"])
    camera.evaluate("send('rgb8', 1, 1, [1, 2, 3])")
    expect(panel.get_by_label("depth that is black")).to_be_hidden()
    camera.evaluate("send('16UC1', 2, 1, [232, 3, 208, 7])")
    expect(panel.get_by_label("depth that is black")).to_have_attribute("placeholder", "1000")
    panel.get_by_label("depth that is white").fill("3000")
    panel.get_by_label("depth that is white").dispatch_event("change")
    camera.evaluate("frames()")
    assert pixel(panel, 1) == grey(128)[0]
    kept = camera.evaluate("ros.kept()")
    assert kept == {"topic": "/raw", "min": "", "max": "3000"}
    panel.get_by_label("topic").select_option("/small")
    assert subscribed(camera) == ["/small"]
    camera.evaluate("(kept) => { unmount(); ros.given = kept; }", kept)
    panel = show(camera, "image")
    camera.evaluate("send('16UC1', 2, 1, [232, 3, 208, 7])")
    assert pixel(panel, 1) == grey(128)[0]


def test_what_is_no_image_is_said(camera: Tab) -> None:
    add(camera, "publisher", "/talker", "/chatter", "std_msgs/msg/String")
    panel = show(camera, "image", {"topic": "/chatter"})
    expect(panel).to_contain_text(f"/chatter has the type std_msgs/msg/String; images are {RAW} or")
    assert subscribed(camera) == []
    camera.evaluate("(raw) => { unmount(); delete ros.types[raw]; }", RAW)
    panel = show(camera, "image", {"topic": "/raw"})
    expect(panel).to_contain_text(f"This page has no definition of {RAW}")
    camera.evaluate("() => { unmount(); ros.graph.all = []; }")
    panel = show(camera, "image")
    expect(panel).to_contain_text("No topics with images now")


def test_an_image_is_zoomed_moved_and_saved(camera: Tab) -> None:
    panel = show(camera, "image", {"topic": "/raw"})
    camera.evaluate("send('mono8', 100, 50, Array(5000).fill(255))")
    picture = panel.get_by_role("img")

    def width() -> float:
        box = panel.locator("canvas").bounding_box()
        assert box
        return box["width"]

    fitted = width()
    area = picture.bounding_box()
    assert area
    assert fitted == pytest.approx(min(area["width"], 2 * area["height"]), abs=2)
    panel.get_by_role("button", name="Zoom in").click()
    assert width() == pytest.approx(1.3 * fitted, abs=2)
    picture.press("-")
    assert width() == pytest.approx(fitted, abs=2)
    before = panel.locator("canvas").bounding_box()
    camera.mouse.move(area["x"] + 50, area["y"] + 50)
    camera.mouse.down()
    camera.mouse.move(area["x"] + 90, area["y"] + 60)
    camera.mouse.up()
    after = panel.locator("canvas").bounding_box()
    assert before
    assert after
    assert after["x"] - before["x"] == pytest.approx(40)
    panel.get_by_role("button", name="Fit").click()
    assert panel.locator("canvas").bounding_box() == before
    name, content = saved(panel.get_by_role("button", name="Save"))
    assert (name, content[:4]) == ("image.png", b"\x89PNG")
    camera.set_viewport_size({"width": 390, "height": 800})
    assert camera.evaluate(WIDER) <= 0


def test_the_policy_of_pages_allows_it(camera: Tab, tmp_path: Path, browser_name: str) -> None:
    page = tmp_path / "index.html"
    # The stage has scripts of its own, which pages have not.
    rules = policy("", live=True, fonts=False, offline=False)
    rules = re.sub(r"script-src [^;]*", "script-src 'self' 'unsafe-inline'", rules)
    meta = f'<meta http-equiv="Content-Security-Policy" content="{rules}">'
    page.write_text(page.read_text().replace("<title>", f"{meta}<title>"))
    camera.reload()
    camera.wait_for_selector("body[data-ready]")
    camera.evaluate(
        "([small]) => { ros.types[small] = ros.fields('string format'); }", [COMPRESSED]
    )
    add(camera, "publisher", "/camera", "/small", COMPRESSED)
    panel = show(camera, "image", {"topic": "/small"})
    camera.evaluate(
        """async () => {
          const canvas = new OffscreenCanvas(2, 2);
          canvas.getContext("2d").fillRect(0, 0, 1, 1);
          const data = new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer());
          ros.emit("/small", { format: "png", data });
        }"""
    )
    expect(panel.get_by_text("2 \u00d7 2, png")).to_be_visible()
    assert pixel(panel)[3] == 255
    if browser_name == "chromium":  # Firefox does not tell of downloads
        with camera.expect_download() as download:
            panel.get_by_role("button", name="Save").click()
        assert download.value.suggested_filename == "image.png"


def test_an_image_that_was_a_message_is_decoded(stage: Tab) -> None:
    decoded = stage.evaluate(
        """async (raw) => {
          const { Codec } = await import("./runtime/messages/codec.js");
          const { decode } = await import("./runtime/widgets/image/decode.js");
          const types = {
            ...ros.types,
            "std_msgs/msg/Header": ros.fields("builtin_interfaces/msg/Time stamp, string frame_id"),
            [raw]: ros.fields("std_msgs/msg/Header header, uint32 height, uint32 width, " +
              "string encoding, uint8 is_bigendian, uint32 step, uint8[] data"),
          };
          const codec = new Codec(types);
          const header = { stamp: { sec: 1, nanosec: 2 }, frame_id: "eye" };
          const data = Uint8Array.of(1, 2, 3, 4, 5, 6);
          const sent =
            { header, height: 1, width: 2, encoding: "bgr8", is_bigendian: 0, step: 6, data };
          return [...decode(codec.read(raw, codec.write(raw, sent)), { low: NaN, high: NaN }).data];
        }""",
        RAW,
    )
    assert decoded == [3, 2, 1, 255, 6, 5, 4, 255]
