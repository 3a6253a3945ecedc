"""A page with nothing but a bag shows what is in it."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bags import player
from browser import Built, Serve, opened, serving
from paths import DEMOS
from playwright.sync_api import Browser, expect
from playwright.sync_api import Page as Tab
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore
from waiting import until

from sitegen.build import make, write
from sitegen.options import Options
from sitegen.report import Report

SITE = """
site: {title: Replay}
pages:
  - {path: /, title: A drive, content: [{bag: drive}]}
  - {path: frames/, title: Frames, content: [{tf: }, {bag: drive}, {log: }]}
"""
START = 1_700_000_000_000_000_000


def write_drive(folder: Path) -> None:
    """Write ten seconds of a robot that drives in a circle, looks around, and has a battery."""
    store = get_typestore(Stores.LATEST)
    types: dict[str, Any] = dict(store.types)
    time = types["builtin_interfaces/msg/Time"]

    def header(now: float, frame: str) -> Any:
        stamp = time(sec=1_700_000_000 + int(now), nanosec=int(now % 1 * 1e9))
        return types["std_msgs/msg/Header"](stamp=stamp, frame_id=frame)

    def vector(x: float, y: float, z: float) -> Any:
        return types["geometry_msgs/msg/Vector3"](x=x, y=y, z=z)

    with Writer(folder, version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        kinds = {
            "/tf": "tf2_msgs/msg/TFMessage",
            "/scan": "sensor_msgs/msg/LaserScan",
            "/camera/image_raw": "sensor_msgs/msg/Image",
            "/battery": "std_msgs/msg/Float32",
            "/said": "std_msgs/msg/String",
        }
        added = {
            name: writer.add_connection(name, kind, typestore=store) for name, kind in kinds.items()
        }

        def send(topic: str, now: float, message: Any) -> None:
            data = store.serialize_cdr(message, kinds[topic])
            writer.write(added[topic], START + int(now * 1e9), data)

        for number in range(100):
            now = number / 10
            angle = now * 0.6
            turn = types["geometry_msgs/msg/Quaternion"](
                x=0.0, y=0.0, z=math.sin(angle / 2), w=math.cos(angle / 2)
            )
            moved = types["geometry_msgs/msg/Transform"](
                translation=vector(2 * math.sin(angle), 2 - 2 * math.cos(angle), 0.0), rotation=turn
            )
            frames = types["geometry_msgs/msg/TransformStamped"](
                header=header(now, "odom"), child_frame_id="laser", transform=moved
            )
            send("/tf", now, types["tf2_msgs/msg/TFMessage"](transforms=[frames]))
            ranges = np.array(
                [3 + math.sin(5 * a / 60 + now) for a in range(360)], dtype=np.float32
            )
            scan = types["sensor_msgs/msg/LaserScan"](
                header=header(now, "laser"),
                angle_min=-math.pi,
                angle_max=math.pi,
                angle_increment=2 * math.pi / 360,
                time_increment=0.0,
                scan_time=0.1,
                range_min=0.1,
                range_max=10.0,
                ranges=ranges,
                intensities=np.array([], dtype=np.float32),
            )
            send("/scan", now, scan)
            pixels: Any = np.zeros((48, 64, 3), dtype=np.uint8)
            pixels[:, :, 0] = number * 2
            pixels[:, :, 1] = 200
            image = types["sensor_msgs/msg/Image"](
                header=header(now, "camera"),
                height=48,
                width=64,
                encoding="rgb8",
                is_bigendian=0,
                step=192,
                data=pixels.reshape(-1),
            )
            send("/camera/image_raw", now, image)
            send("/battery", now, types["std_msgs/msg/Float32"](data=12.5 - now / 10))
            send("/said", now, types["std_msgs/msg/String"](data=f"at {now}"))


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("replay")
    write_drive(folder / "drive")
    (folder / "site.yaml").write_text(SITE)
    made = make(folder, Report(), output=folder / "dist", options=Options(draft=True))
    write(made.artifacts, folder / "dist")
    return folder / "dist"


@pytest.fixture
def page(browser: Browser, site: Path) -> Iterator[Tab]:
    with serving(site) as url, opened(browser) as tab:
        tab.goto(url)
        yield tab


def test_all_panels_show_the_bag(page: Tab) -> None:
    bag = player(page)
    expect(bag.locator(".ros-bag-row")).to_have_count(5)
    bag.get_by_role("checkbox", name="Loop").check()
    bag.get_by_role("button", name="Play", exact=True).click()
    # Everything in the frame that stands still, which nobody has chosen.
    view = page.locator(".ros-3d")
    expect(view.get_by_label("Fixed frame")).to_have_value("odom")
    view.get_by_text("Displays").click()
    expect(view.locator(".ros-display-list")).to_contain_text("/scan")
    # Panels begin when they are seen.
    for panel, text in (
        (".ros-image", re.compile("64 . 48")),
        (".ros-plot", re.compile(r"/battery\.data\s*1\d")),
        (".ros-topics", "/said"),
    ):
        page.locator(panel).scroll_into_view_if_needed()
        expect(page.locator(panel)).to_contain_text(text)


@pytest.mark.firefox
def test_types_that_come_with_the_bag_are_no_obstacle(page: Tab) -> None:
    """The panel of frames was there before the bag had been read."""
    page.goto(f"{page.url}frames/")
    player(page).scroll_into_view_if_needed()
    player(page).get_by_role("button", name="Play", exact=True).click()
    expect(page.locator(".ros-tf")).to_contain_text("laser")


def test_a_rover_drives_a_recorded_drive_again(
    browser: Browser, serve: Serve, built: Built
) -> None:
    url = serve(built(DEMOS / "demo11"))
    with opened(browser) as tab:
        tab.goto(f"{url}replay/")
        player(tab).get_by_role("button", name="Play", exact=True).click()
        expect(tab.locator(".ros-3d").get_by_label("Fixed frame")).to_have_value("map")
        tab.goto(f"{url}again/")
        expect(tab.locator(".ros-state[data-state=running]")).to_be_attached()
        player(tab).get_by_role("button", name="Play", exact=True).click()
        tab.locator(".ros-plot").scroll_into_view_if_needed()
        values = tab.locator(".ros-plot .ros-key > li")

        def shown() -> list[float]:
            # Without the path and the sign that removes it.
            found = [re.search(r"x\s+(-?\d\S*)", one) for one in values.all_inner_texts()]
            return [float(one[1].replace("\u2212", "-")) for one in found if one]

        until(lambda: (shown() or [0])[0] > 1, told=values.all_inner_texts)
        recorded, live = shown()
        assert abs(recorded - live) < 0.2
