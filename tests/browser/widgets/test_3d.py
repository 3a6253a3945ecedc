"""3D views: each display draws what its message says, and nothing that comes breaks the view."""

from __future__ import annotations

import re
from typing import Any

import pytest
from playwright.sync_api import Locator, expect
from playwright.sync_api import Page as Tab
from scenes import at, emit, expect_colors, pixels, view
from stage import add, hide_tab, show, subscribed

# By display and its options: the message, and which colours are where.
SCENES: list[tuple[dict[str, Any], str, str, list[tuple[float, float, str]]]] = [
    (
        {"kind": "laser_scan", "topic": "/t", "size": 0.2, "color": "#00ff00"},
        "sensor_msgs/msg/LaserScan",
        "{ header: header(), angle_min: 0, angle_increment: Math.PI / 2, range_min: 0.1,"
        " range_max: 5, ranges: Float32Array.of(1, 1.5, NaN, 0.01), intensities: [] }",
        [(1, 0, "green"), (0, 1.5, "green"), (-1, 0, "black"), (0, 0, "black")],
    ),
    (
        {"kind": "point_cloud", "topic": "/t", "size": 0.1, "color_by": "color"},
        "sensor_msgs/msg/PointCloud2",
        "cloud([...square(1, 1), ...square(-1, 0), [NaN, 0, 0]])",
        [(1, 1, "white"), (-1, 0, "white"), (0, 0, "black")],
    ),
    (
        {"kind": "point_cloud", "topic": "/t", "size": 0.1, "color_by": "x"},
        "sensor_msgs/msg/PointCloud2",
        "cloud([...square(-1, 0), ...square(1, 0)], ['x', 'y', 'z'], { is_bigendian: true })",
        [(-1, 0, "red"), (1, 0, "magenta"), (0, 0, "black")],
    ),
    (
        {"kind": "map", "topic": "/t", "alpha": 1},
        "nav_msgs/msg/OccupancyGrid",
        "{ header: header(), info: { width: 2, height: 2, resolution: 1, origin: pose(-1, -1) },"
        " data: Int8Array.of(0, 100, 100, 0) }",
        [(-0.5, -0.5, "white"), (0.5, -0.5, "black"), (0.5, 0.5, "white"), (1.5, 0, "black")],
    ),
    (
        {"kind": "path", "topic": "/t", "width": 0.3, "color": "#00ff00"},
        "nav_msgs/msg/Path",
        "{ header: header(), poses: [pose(-1, 1), pose(1, 1), pose(NaN), pose(1, -1)]"
        ".map((pose) => ({ pose })) }",
        [(0, 1, "green"), (1, 0, "green"), (0, 0, "black"), (-1, -1, "black")],
    ),
    (
        {"kind": "odometry", "topic": "/t", "length": 2, "color": "#ff0000"},
        "nav_msgs/msg/Odometry",
        "{ header: header(), pose: { pose: pose(0, -1, 0, Math.PI / 2) } }",
        [(0, -0.5, "red"), (0.6, -0.5, "black")],
    ),
    (
        {"kind": "pose", "topic": "/t", "length": 2, "color": "#ff0000"},
        "geometry_msgs/msg/PoseStamped",
        "{ header: header(), pose: pose(-1, 0.5) }",
        [(0, 0.5, "red"), (-1.4, 0.5, "black")],
    ),
    (
        {"kind": "pose_array", "topic": "/t", "length": 2, "color": "#ff0000"},
        "geometry_msgs/msg/PoseArray",
        "{ header: header(), poses: [pose(-1, 1), pose(-1, -1), pose(0, NaN)] }",
        [(0, 1, "red"), (0, -1, "red"), (0, 0, "black")],
    ),
    (
        {"kind": "point", "topic": "/t", "radius": 0.4, "color": "#ff0000"},
        "geometry_msgs/msg/PointStamped",
        "{ header: header(), point: { x: 1, y: -1, z: 0 } }",
        [(1, -1, "red"), (0, 0, "black")],
    ),
    (
        {"kind": "polygon", "topic": "/t", "width": 0.2, "color": "#00ff00"},
        "geometry_msgs/msg/PolygonStamped",
        "{ header: header(), polygon: { points: points([-1, -1], [1, -1], [1, 1], [-1, 1]) } }",
        [(0, 1, "green"), (-1, 0, "green"), (0, 0, "black")],
    ),
    (
        {"kind": "range", "topic": "/t", "color": "#ffff00", "alpha": 1},
        "sensor_msgs/msg/Range",
        "{ header: header(), range: 1.5, field_of_view: 0.6, min_range: 0.1, max_range: 3 }",
        [(1.2, 0, "yellow"), (1.7, 0, "black"), (-0.5, 0, "black")],
    ),
    (
        {"kind": "wrench", "topic": "/t", "force_scale": 1, "width": 0.2, "force_color": "#ff0000"},
        "geometry_msgs/msg/WrenchStamped",
        "{ header: header(), wrench: { force: { x: 1.5, y: 0, z: 0 },"
        " torque: { x: 0, y: 0, z: 0 } } }",
        [(0.5, 0, "red"), (-0.5, 0, "black")],
    ),
    (
        {"kind": "imu", "topic": "/t", "size": 1, "axes": False, "acceleration": False},
        "sensor_msgs/msg/Imu",
        "{ header: header(), orientation: pose().orientation, orientation_covariance: [0],"
        " linear_acceleration: { x: 0, y: 0, z: 9.8 } }",
        [(0.3, 0.3, "red"), (0.8, 0, "black")],
    ),
    ({"kind": "grid", "cells": 2, "size": 1, "width": 0.2, "color": "#00ff00", "alpha": 1}, "", "",
     [(0, 0.5, "green"), (0.5, 1, "green"), (0.5, 0.5, "black")]),
    ({"kind": "axes", "length": 1.5, "radius": 0.2}, "", "", [(1, 0, "red"), (0, 1, "green")]),
]  # fmt: skip

MARKERS = {
    "arrow": ("{ type: 0, scale: { x: 1.8, y: 0.4, z: 0.4 } }", (0.5, 0), (0, 0.5)),
    "arrow between points": (
        "{ type: 0, points: points([0, -1], [0, 1]), scale: { x: 0.3, y: 0.5, z: 0.4 } }",
        (0, 0),
        (0.5, 0),
    ),
    "cube": ("{ type: 1, pose: pose(1, 0) }", (1.4, 0.4), (0, 0)),
    "sphere": ("{ type: 2 }", (0.4, 0), (0.45, 0.45)),
    "cylinder": ("{ type: 3 }", (0.4, 0), (0.45, 0.45)),
    "line strip": (
        "{ type: 4, points: points([-1, 0], [1, 0], [1, 1]), scale: { x: 0.3, y: 0, z: 0 } }",
        (1, 0.7),
        (0, 0.5),
    ),
    "line list": (
        "{ type: 5, points: points([-1, 1], [1, 1], [-1, -1], [1, -1]),"
        " scale: { x: 0.3, y: 0, z: 0 } }",
        (0, -1),
        (0, 0),
    ),
    "cube list": (
        "{ type: 6, points: points([-1, 0], [1, 0]), scale: { x: 0.5, y: 0.5, z: 0.5 } }",
        (1.2, 0.2),
        (0, 0),
    ),
    "sphere list": (
        "{ type: 7, points: points([-1, 0], [1, 0]), scale: { x: 0.5, y: 0.5, z: 0.5 } }",
        (-1, 0),
        (0, 0),
    ),
    "points": (
        "{ type: 8, points: square(1, 1).map(([x, y, z]) => ({ x, y, z })),"
        " scale: { x: 0.1, y: 0.1, z: 0 } }",
        (1, 1),
        (0, 0),
    ),
    "text": (
        "{ type: 9, text: '\u2588\u2588\u2588', scale: { x: 0, y: 0, z: 1 } }",
        (0.2, 0),
        (0, 1),
    ),
    "triangles": (
        "{ type: 11, points: points([-1, -1], [1, -1], [0, 1]) }",
        (0, -0.5),
        (-0.8, 0.8),
    ),
    "arrow strip": (
        "{ type: 12, points: points([-1, 0], [0, 0], [1.5, 0]),"
        " scale: { x: 0.3, y: 0.4, z: 0.2 } }",
        (0.5, 0),
        (0, 0.6),
    ),
}  # fmt: skip


@pytest.mark.parametrize("number", range(len(SCENES)), ids=[s[0]["kind"] for s in SCENES])
def test_a_display_draws_its_message(stage: Tab, number: int) -> None:
    display, type_name, message, colors = SCENES[number]
    if type_name:
        add(stage, "publisher", "/node", "/t", type_name)
    panel = view(stage, display)
    if message:
        emit(stage, "/t", message)
    image = pixels(panel)
    assert [at(image, x, y) for x, y, _ in colors] == [color for *_, color in colors]
    expect(panel.locator(".ros-display-list .ros-note")).to_have_text("")


@pytest.mark.parametrize("name", MARKERS)
def test_a_marker_of_each_type(stage: Tab, name: str) -> None:
    own, inside, outside = MARKERS[name]
    add(stage, "publisher", "/node", "/t", "visualization_msgs/msg/Marker")
    panel = view(stage, {"kind": "markers", "topic": "/t"})
    emit(stage, "/t", f"marker({own})")
    image = pixels(panel)
    assert (at(image, *inside), at(image, *outside)) == ("red", "black")


def test_markers_are_changed_and_removed(stage: Tab) -> None:
    add(stage, "publisher", "/node", "/t", "visualization_msgs/msg/MarkerArray")
    panel = view(stage, {"kind": "markers", "topic": "/t"})
    emit(
        stage,
        "/t",
        "{ markers: [marker({ id: 1, pose: pose(-1, 0) }), marker({ id: 2, pose: pose(1, 0) }),"
        " marker({ ns: 'other', pose: pose(0, -1.5) })] }",
    )
    image = pixels(panel)
    assert [at(image, -1, 0), at(image, 1, 0), at(image, 0, -1.5)] == ["red"] * 3
    emit(stage, "/t", "{ markers: [marker({ id: 1, pose: pose(0, 1), color: color(0, 1, 0) })] }")
    image = pixels(panel)
    assert [at(image, -1, 0), at(image, 0, 1), at(image, 1, 0)] == ["black", "green", "red"]
    emit(stage, "/t", "{ markers: [marker({ id: 2, action: 2 })] }")
    assert at(pixels(panel), 1, 0) == "black"
    emit(stage, "/t", "{ markers: [marker({ ns: 'test', action: 3 })] }")
    image = pixels(panel)
    assert [at(image, 0, 1), at(image, 0, -1.5)] == ["black", "red"]
    emit(stage, "/t", "{ markers: [marker({ ns: '', action: 3 })] }")
    assert at(pixels(panel), 0, -1.5) == "black"


def test_a_marker_disappears_when_its_lifetime_is_over(stage: Tab) -> None:
    add(stage, "publisher", "/node", "/t", "visualization_msgs/msg/Marker")
    panel = view(stage, {"kind": "markers", "topic": "/t"})
    emit(stage, "/t", "marker({ lifetime: time(0.6) })")
    assert at(pixels(panel), 0, 0) == "red"
    expect_colors(panel, {(0, 0): "black"})


def test_messages_are_drawn_where_their_frame_was(stage: Tab) -> None:
    """A transform that comes later than the message places it; one between two is interpolated."""
    add(stage, "publisher", "/node", "/t", "geometry_msgs/msg/PointStamped")
    panel = view(stage, {"kind": "point", "topic": "/t", "radius": 0.3, "color": "#ff0000"})
    point = "{ header: header('robot', 10.5), point: { x: 0, y: 0, z: 0 } }"
    emit(stage, "/t", point)
    note = panel.locator(".ros-display-list .ros-note")
    expect(note).to_have_text("no frame 'robot' in /tf")
    emit(stage, "/tf", "{ transforms: [transform('map', 'robot', [-1, 1, 0], 0, 10)] }")
    expect(note).to_have_text("no transform of 'robot' that is new enough")
    emit(stage, "/tf", "{ transforms: [transform('map', 'robot', [1, 1, 0], 0, 11)] }")
    expect(note).to_have_text("")
    image = pixels(panel)
    assert [at(image, 0, 1), at(image, -1, 1), at(image, 1, 1)] == ["red", "black", "black"]


def test_the_fixed_frame_is_chosen(stage: Tab) -> None:
    add(stage, "publisher", "/node", "/t", "geometry_msgs/msg/PointStamped")
    display = {"kind": "point", "topic": "/t", "radius": 0.3, "color": "#ff0000"}
    panel = view(stage, display, frame="odom")
    emit(stage, "/tf_static", "{ transforms: [transform('map', 'odom', [1, 0, 0])] }")
    emit(stage, "/t", "{ header: header('map'), point: { x: 0, y: 0, z: 0 } }")
    assert at(pixels(panel), -1, 0) == "red"
    panel.get_by_label("Fixed frame").select_option("map")
    stage.evaluate("frames()")
    assert at(pixels(panel), 0, 0) == "red"
    assert stage.evaluate("ros.kept().frame") == "map"


def test_without_displays_all_topics_are_shown(stage: Tab) -> None:
    add(stage, "publisher", "/node", "/scan", "sensor_msgs/msg/LaserScan")
    add(stage, "publisher", "/node", "/text", "std_msgs/msg/String")
    panel = view(stage, displays=None)
    labels = panel.locator(".ros-display-list .ros-toggle")
    expect(labels).to_have_text(["Grid ", "Frames ", "Laser scan /scan"])
    add(stage, "publisher", "/node", "/path", "nav_msgs/msg/Path")
    stage.evaluate("frames()")
    assert "/path" in subscribed(stage)
    expect(labels).to_have_count(4)


def test_nothing_is_subscribed_while_nobody_looks(stage: Tab) -> None:
    add(stage, "publisher", "/node", "/t", "nav_msgs/msg/Path")
    panel = view(stage, {"kind": "path", "topic": "/t"})
    assert subscribed(stage) == ["/t", "/tf", "/tf_static"]
    panel.locator("summary").click()
    panel.get_by_role("checkbox", name="Path /t").uncheck()
    assert subscribed(stage) == ["/tf", "/tf_static"]
    panel.get_by_role("checkbox", name="Path /t").check()
    hide_tab(stage, True)
    assert subscribed(stage) == []
    hide_tab(stage, False)
    assert subscribed(stage) == ["/t", "/tf", "/tf_static"]
    stage.evaluate("unmount()")
    assert subscribed(stage) == []


def test_options_are_set_in_the_panel_and_travel_in_links(stage: Tab) -> None:
    add(stage, "publisher", "/node", "/t", "geometry_msgs/msg/PointStamped")
    panel = view(stage, {"kind": "point", "topic": "/t", "radius": 0.1, "color": "#ff0000"})
    emit(stage, "/t", "{ header: header(), point: { x: 0, y: 0, z: 0 } }")
    assert at(pixels(panel), 0.4, 0) == "black"
    panel.locator("summary").click()
    panel.get_by_role("button", name="Options of Point /t").click()
    panel.get_by_label("radius").fill("0.6")
    panel.get_by_label("radius").press("Enter")
    panel.get_by_label("color").fill("#00ff00")
    stage.evaluate("frames()")
    assert at(pixels(panel), 0.4, 0) == "green"
    kept = stage.evaluate("ros.kept().displays")
    assert kept == {"point /t": {"radius": 0.6, "color": "#00ff00"}}
    stage.evaluate("(kept) => { unmount(); ros.given = { displays: kept }; }", kept)
    panel = view(stage, {"kind": "point", "topic": "/t", "radius": 0.1, "color": "#ff0000"})
    emit(stage, "/t", "{ header: header(), point: { x: 0, y: 0, z: 0 } }")
    assert at(pixels(panel), 0.4, 0) == "green"


def test_tools_publish_a_goal_a_pose_and_a_point(stage: Tab) -> None:
    panel = view(stage, {"kind": "grid"}, tools={"goal": "/my_goal"})
    box = panel.locator("canvas").bounding_box()
    assert box
    scale = box["height"] / 4
    middle = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def drag(x: float, y: float, to_x: float, to_y: float) -> None:
        stage.mouse.move(middle[0] + x * scale, middle[1] - y * scale)
        stage.mouse.down()
        stage.mouse.move(middle[0] + to_x * scale, middle[1] - to_y * scale)
        stage.mouse.up()

    panel.get_by_role("button", name="Goal").click()
    drag(1, 0.5, 1, 1.5)
    [goal] = stage.evaluate("ros.published")
    assert (goal["topic"], goal["type"]) == ("/my_goal", "geometry_msgs/msg/PoseStamped")
    pose = goal["message"]["pose"]
    assert goal["message"]["header"]["frame_id"] == "map"
    assert pose["position"] == pytest.approx({"x": 1, "y": 0.5, "z": 0}, abs=0.02)
    assert pose["orientation"]["z"] == pytest.approx(0.707, abs=0.02)
    panel.get_by_role("button", name="Estimate").click()
    drag(0, 0, -1, 0)
    estimate = stage.evaluate("ros.published[1]")
    assert estimate["topic"] == "/initialpose"
    assert abs(estimate["message"]["pose"]["pose"]["orientation"]["z"]) == pytest.approx(
        1, abs=0.01
    )
    panel.get_by_role("button", name="Point", exact=True).click()
    drag(-1, -1, -1, -1)
    point = stage.evaluate("ros.published[2].message.point")
    assert point == pytest.approx({"x": -1, "y": -1, "z": 0}, abs=0.02)
    panel.get_by_role("button", name="Measure").click()
    stage.mouse.move(*middle)
    stage.mouse.down()
    stage.mouse.move(middle[0] + scale, middle[1])
    expect(panel.locator(".ros-scene-note")).to_have_text(re.compile(r"1\.0\d\d m"))
    stage.mouse.up()


def drag(tab: Tab, panel: Locator, begin: tuple[float, float], end: tuple[float, float]) -> None:
    """Drag from a point of the floor to another, in metres from the middle."""
    box = panel.locator("canvas").bounding_box()
    assert box
    for (x, y), act in ((begin, tab.mouse.down), (end, tab.mouse.up)):
        scale = box["height"] / 4
        tab.mouse.move(
            box["x"] + box["width"] / 2 + x * scale, box["y"] + box["height"] / 2 - y * scale
        )
        act()


def test_tools_stamp_with_the_time_of_nodes(stage: Tab) -> None:
    stage.evaluate("void (ros.types['rosgraph_msgs/msg/Clock'] = ros.fields(''))")
    panel = view(stage, {"kind": "grid"})
    add(stage, "publisher", "/player", "/clock", "rosgraph_msgs/msg/Clock")
    goal = panel.get_by_role("button", name="Goal")
    for at_second in (0, 12):
        if at_second:
            emit(stage, "/clock", "{ clock: { sec: 12, nanosec: 5 } }")
        goal.click()
        drag(stage, panel, (0, 0), (0, 1))
        stamp = stage.evaluate("ros.published.at(-1).message.header.stamp")
        assert stamp == {"sec": at_second, "nanosec": 5 if at_second else 0}
    stage.evaluate("ros.graph.remove('/player')")
    goal.click()
    drag(stage, panel, (0, 0), (0, 1))
    assert stage.evaluate("ros.published.at(-1).message.header.stamp.sec") > 1e9


def test_nothing_is_published_in_a_frame_without_a_name(stage: Tab) -> None:
    panel = view(stage, {"kind": "grid"}, frame="")
    panel.get_by_role("button", name="Goal").click()
    drag(stage, panel, (0, 0), (0, 1))
    expect(panel.locator(".ros-scene-note")).to_have_text("not published: no frame is known yet")
    assert stage.evaluate("ros.published") == []


def test_points_are_those_that_are_seen(stage: Tab) -> None:
    add(stage, "publisher", "/node", "/t", "visualization_msgs/msg/Marker")
    panel = view(stage, {"kind": "markers", "topic": "/t"})
    emit(stage, "/t", "marker({})")
    point = panel.get_by_role("button", name="Point", exact=True)
    point.click()
    drag(stage, panel, (0.1, 0.1), (0.1, 0.1))
    assert stage.evaluate("ros.published[0].message.point.z") == pytest.approx(0.5, abs=0.01)
    panel.locator("summary").click()
    panel.get_by_role("checkbox", name="Markers /t").uncheck()
    point.click()
    drag(stage, panel, (0.1, 0.1), (0.1, 0.1))
    assert stage.evaluate("ros.published[1].message.point.z") == pytest.approx(0, abs=0.01)


def test_a_drawing_that_is_lost_says_so(stage: Tab) -> None:
    panel = view(stage, {"kind": "axes", "length": 1, "radius": 0.2})
    alert = panel.get_by_role("alert")
    expect(alert).to_be_hidden()
    stage.evaluate(
        """() => {
          const canvas = document.querySelector(".ros-scene canvas");
          window.lose = canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
          lose.loseContext();
        }"""
    )
    expect(alert).to_contain_text("stopped drawing this view")
    stage.evaluate("lose.restoreContext()")
    expect(alert).to_be_hidden()
    expect_colors(panel, {(0.7, 0): "red"})


HOSTILE = {
    "a cloud that is too short": (
        "point_cloud",
        "sensor_msgs/msg/PointCloud2",
        "cloud([[0, 0, 0]], ['x', 'y', 'z'], { width: 10000000 })",
        "10000000 points need 120000000 bytes, but the message has 12",
    ),
    "a cloud whose field lies outside": (
        "point_cloud",
        "sensor_msgs/msg/PointCloud2",
        "cloud([[0, 0, 0]], ['x', 'y', 'z'], { point_step: 8 })",
        "the field 'z' lies outside of the points",
    ),
    "a cloud without coordinates": (
        "point_cloud",
        "sensor_msgs/msg/PointCloud2",
        "cloud([[0, 0]], ['u', 'v'])",
        "the points have no fields x, y and z",
    ),
    "a map of another size": (
        "map",
        "nav_msgs/msg/OccupancyGrid",
        "{ header: header(), info: { width: 4000000000, height: 4000000000, resolution: 1,"
        " origin: pose() }, data: Int8Array.of(1) }",
        "but the message has 1",
    ),
    "a pose of no numbers": (
        "pose",
        "geometry_msgs/msg/PoseStamped",
        "{ header: header(), pose: pose(NaN) }",
        "the pose is not finite",
    ),
    "a marker of an unknown type": (
        "markers",
        "visualization_msgs/msg/Marker",
        "marker({ type: 77 })",
        "unknown type 77",
    ),
    "a mesh that is not there": (
        "markers",
        "visualization_msgs/msg/Marker",
        "marker({ type: 10, mesh_resource: 'package://none/none.stl' })",
        "the site does not contain package://none/none.stl",
    ),
    "a description that is none": (
        "robot",
        "std_msgs/msg/String",
        "{ data: '<sdf></sdf>' }",
        "not a robot description",
    ),
    "frames in a loop": (
        "pose",
        "geometry_msgs/msg/PoseStamped",
        "(ros.emit('/tf', { transforms: [transform('a', 'b'), transform('b', 'a')] }),"
        " { header: header('a'), pose: pose() })",
        "form a loop",
    ),
    "frames that are not connected": (
        "pose",
        "geometry_msgs/msg/PoseStamped",
        "(ros.emit('/tf', { transforms: [transform('map', 'b'), transform('c', 'd')] }),"
        " { header: header('d'), pose: pose() })",
        "frame 'd' is not connected to 'map'",
    ),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_what_cannot_be_shown_is_said(stage: Tab, name: str) -> None:
    kind, type_name, message, said = HOSTILE[name]
    add(stage, "publisher", "/node", "/t", type_name)
    panel = view(stage, {"kind": kind, "topic": "/t"}, {"kind": "axes", "length": 1, "radius": 0.2})
    emit(stage, "/t", message)
    expect(panel.locator(".ros-display-list .ros-note").first).to_contain_text(said)
    # The rest is still drawn.
    assert at(pixels(panel), 0.7, 0) == "red"


def test_another_type_is_said(stage: Tab) -> None:
    add(stage, "publisher", "/node", "/t", "std_msgs/msg/String")
    panel = view(stage, {"kind": "path", "topic": "/t"})
    note = panel.locator(".ros-display-list .ros-note")
    expect(note).to_have_text("/t is of type std_msgs/msg/String, not nav_msgs/msg/Path")


def test_a_browser_without_webgl_is_told_so(stage: Tab) -> None:
    stage.evaluate("HTMLCanvasElement.prototype.getContext = () => null")
    panel = show(stage, "3d", {})
    expect(panel).to_contain_text("WebGL is not available")
    stage.evaluate("unmount()")
