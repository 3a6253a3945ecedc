"""The panel of frames: the tree, its publishers, and transforms compared with known values."""

from __future__ import annotations

import re

from browser import Built, Serve
from paths import SITES
from playwright.sync_api import Locator, expect
from playwright.sync_api import Page as Tab
from scenes import HELPERS
from stage import cells, show, subscribed

TF = "tf2_msgs/msg/TFMessage"
NONE = "\u2013"


def pose(panel: Locator) -> list[str]:
    return panel.locator("dd").all_inner_texts()


def test_frames_of_a_node_are_drawn_listed_and_related(
    tab: Tab, serve: Serve, built: Built
) -> None:
    tab.goto(f"{serve(built(SITES / 'instruments'))}frames/")
    panel = tab.locator(".ros-tf")
    panel.scroll_into_view_if_needed()
    expect(panel.locator("dd").first).to_have_text("1.000, 2.500, 0.200 m")
    drawing = panel.get_by_role("img")
    expect(drawing).to_have_accessible_name(
        "base_link is below odom; island is a root; laser is below base_link; "
        "odom is a root; palm is below island"
    )
    expect(panel.locator("tbody tr").first).to_have_text(
        re.compile(r"base_linkodom/frames(9|10|11)\.\d Hz0\.\d s")
    )
    rows = cells(panel)
    assert [row.split()[:4] for row in rows[1:]] == [
        ["island", NONE, NONE, NONE],
        ["laser", "base_link", "/frames", "fixed"],
        ["odom", NONE, NONE, NONE],
        ["palm", "island", "/frames", "fixed"],
    ]
    panel.get_by_label("in frame", exact=True).select_option("palm")
    expect(panel.get_by_text("frame 'laser' is not connected to 'palm'")).to_be_visible()
    expect(panel.locator("dl")).to_be_hidden()


def test_transforms_are_those_of_tf2(stage: Tab) -> None:
    """The quaternion of roll 0.1, pitch 0.2, yaw 0.3 is that of tf2's setRPY."""
    stage.evaluate(HELPERS)
    stage.evaluate("(type) => { ros.types[type] = ros.fields(''); }", TF)
    panel = show(stage, "tf", {"reference": "base", "frame": "laser"})
    expect(panel.get_by_text("no frame 'laser' in /tf")).to_be_visible()
    assert subscribed(stage) == ["/tf", "/tf_static"]
    stage.evaluate(
        """() => {
          const laser = transform("base", "laser", [0.5, 0, 0.2]);
          laser.transform.rotation = { x: 0.0342708, y: 0.1060205, z: 0.1435722, w: 0.9833474 };
          ros.emit("/tf_static", { transforms: [laser] });
        }"""
    )
    expect(panel.locator("dd")).to_have_text(
        [
            "0.500, 0.000, 0.200 m",
            "0.0343, 0.1060, 0.1436, 0.9833",
            "0.100, 0.200, 0.300 rad",
            "5.7, 11.5, 17.2 °",
        ]
    )
    # The inverse: the position is turned by the inverse rotation, too.
    panel.get_by_label("Pose of frame").select_option("base")
    panel.get_by_label("in frame", exact=True).select_option("laser")
    expect(panel.locator("dd").nth(1)).to_have_text("-0.0343, -0.1060, -0.1436, 0.9833")
    expect(panel.locator("dd").first).to_have_text("-0.428, 0.118, -0.304 m")
    assert stage.evaluate("ros.kept()") == {"reference": "laser", "frame": "base"}
    stage.evaluate("unmount()")
    assert subscribed(stage) == []


def test_a_page_without_transforms_says_so(stage: Tab) -> None:
    panel = show(stage, "tf")
    expect(panel.get_by_text(f"no node on this page uses {TF}")).to_be_visible()
