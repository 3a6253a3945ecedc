"""What displays of a 3D view do when frames, topics, limits and what visitors want change."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from paths import ROOT
from playwright.sync_api import Locator, Route, expect
from playwright.sync_api import Page as Tab
from scenes import at, emit, expect_colors, pixels, view
from stage import add, hide_tab, subscribed

MARKERS = "visualization_msgs/msg/MarkerArray"
POINT = "geometry_msgs/msg/PointStamped"


def note(panel: Locator) -> Locator:
    return panel.locator(".ros-display-list .ros-note").first


def count(panel: Locator) -> int:
    """The number of pixels that are not dark."""
    return sum(pixels(panel).convert("L").histogram()[30:])


def markers(stage: Tab, **options: Any) -> Locator:
    add(stage, "publisher", "/node", "/t", MARKERS)
    return view(stage, {"kind": "markers", "topic": "/t"}, **options)


@pytest.mark.parametrize(
    ("bad", "said"),
    [
        ("{ id: 2, type: 77 }", "marker test 2: unknown type 77"),
        ("{ id: 2, action: 9 }", "marker test 2: unknown action 9"),
        ("{ id: 2, pose: pose(NaN) }", "marker test 2: its pose is not finite"),
        ("{ id: 2, color: color(NaN, 0, 0) }", "marker test 2: its color is not finite"),
        (
            "{ id: 2, type: 7, points: points([1, 1], [NaN, 0]) }",
            "marker test 2: its points are not finite",
        ),
    ],
    ids=["type", "action", "pose", "color", "points"],
)
def test_a_bad_marker_costs_no_other(stage: Tab, bad: str, said: str) -> None:
    panel = markers(stage)
    ends = "marker({ id: 1, pose: pose(-1, 0) })", "marker({ id: 3, pose: pose(1, 0) })"
    emit(stage, "/t", f"{{ markers: [{ends[0]}, marker({bad}), {ends[1]}] }}")
    image = pixels(panel)
    assert [at(image, -1, 0), at(image, 0, 0), at(image, 1, 0)] == ["red", "black", "red"]
    expect(note(panel)).to_have_text(said)
    # It is still wrong in the frames that follow, and until it is replaced.
    emit(stage, "/tf", "{ transforms: [transform('map', 'other')] }")
    expect(note(panel)).to_have_text(said)
    emit(stage, "/t", "{ markers: [marker({ id: 2, color: color(0, 1, 0) })] }")
    expect(note(panel)).to_have_text("")
    assert at(pixels(panel), 0, 0) == "green"


def test_a_mesh_that_comes_too_late_says_nothing(stage: Tab) -> None:
    waiting: list[Route] = []
    stage.route("**/late.gltf", lambda route: waiting.append(route))
    url = "package://robot/late.gltf"
    panel = markers(stage, resources={url: "late.gltf"})
    with stage.expect_request("**/late.gltf"):
        emit(stage, "/t", f"{{ markers: [marker({{ type: 10, mesh_resource: '{url}' }})] }}")
    emit(stage, "/t", "{ markers: [marker({ action: 2 }), marker({ id: 1 })] }")
    [route] = waiting
    with stage.expect_response("**/late.gltf"):
        route.fulfill(body="{")
    stage.evaluate("frames(5)")
    expect(note(panel)).to_have_text("")
    assert at(pixels(panel), 0, 0) == "red"


def test_only_the_first_markers_move_the_camera(stage: Tab) -> None:
    panel = markers(stage, view=None, top=True)
    emit(stage, "/t", "{ markers: [marker({})] }")
    seen = count(panel)
    assert seen > 1000
    emit(stage, "/t", "{ markers: [marker({ id: 1, pose: pose(50, 50) })] }")
    assert count(panel) == seen


def test_spheres_are_simpler_the_more_there_are(stage: Tab) -> None:
    """So that a million are drawn; more of all markers together are not, and that is said."""
    panel = markers(stage)
    # All but the first are out of view: what covers the same pixels is painted again and again.
    spheres = (
        "marker({{ id: {}, type: 7, points: "
        "Array({}).fill({{ x: 500, y: 0, z: 0 }}).fill({{ x: 0, y: 0, z: 0 }}, 0, 1) }})"
    )
    emit(stage, "/t", f"{{ markers: [{spheres.format(1, 200_000)}] }}")
    # A sphere with four sides is a square.
    image = pixels(panel)
    assert (at(image, 0.45, 0), at(image, 0.35, 0.35)) == ("red", "black")
    emit(stage, "/t", f"{{ markers: [{spheres.format(2, 900_000)}] }}")
    expect(note(panel)).to_have_text("the markers have more than 1000000 points")
    emit(stage, "/t", f"{{ markers: [{spheres.format(1, 4)}] }}")
    expect(note(panel)).to_have_text("")
    assert at(pixels(panel), 0.33, 0.33) == "red"


def test_points_have_their_size_in_perspective(stage: Tab) -> None:
    add(stage, "publisher", "/node", "/t", "sensor_msgs/msg/PointCloud2")
    beside = {"top": False, "eye": [-5, 0, 0], "target": [0, 0, 0], "zoom": 1}
    display = {"kind": "point_cloud", "topic": "/t", "size": 2, "color_by": "color"}
    panel = view(stage, display, view=beside)
    emit(stage, "/t", "cloud([[0, 0, 0]])")
    image = pixels(panel)
    column = [image.getpixel((image.width // 2, y)) for y in range(image.height)]
    white = sum(color[0] > 200 for color in column if isinstance(color, tuple))
    # Two metres, 5 m away, in a view of 45 degrees.
    assert white / image.height == pytest.approx(2 / (2 * 5 * 0.41421), rel=0.03)


def test_each_option_has_a_name_in_words(stage: Tab) -> None:
    """Other languages translate it; letters of axes are the same in all."""
    kinds = json.loads((ROOT / "sitegen/bundles/displays.json").read_text()).values()
    keys = {key for kind in kinds for key in kind["defaults"]}
    choices = {each for kind in kinds for every in kind["choices"].values() for each in every}
    module = "./runtime/widgets/3d/optionNames.js"
    named = stage.evaluate(f"async () => Object.keys((await import('{module}')).NAMES)")
    letters = {"x", "y", "z", "rgb", "XY", "XZ", "YZ"}
    assert set(named) == (keys | choices) - letters


def test_a_phone_has_room_for_options(stage: Tab) -> None:
    stage.set_viewport_size({"width": 390, "height": 844})
    panel = view(stage, {"kind": "robot", "topic": "/t"})
    panel.locator("summary").click()
    panel.get_by_role("button", name="Options of").click()
    field, whole = panel.get_by_label("topic").bounding_box(), panel.bounding_box()
    assert field
    assert whole
    assert field["x"] + field["width"] <= whole["x"] + whole["width"] - 8
    assert field["width"] > 120


def test_a_display_waits_for_its_frame(stage: Tab) -> None:
    panel = view(stage, {"kind": "axes", "length": 1, "radius": 0.2, "frame": "robot"})
    expect(note(panel)).to_have_text("no frame 'robot' in /tf")
    assert at(pixels(panel), 0.7, 0) == "black"
    emit(stage, "/tf", "{ transforms: [transform('map', 'robot', [0, 1, 0])] }")
    expect(note(panel)).to_have_text("")
    assert at(pixels(panel), 0.7, 1) == "red"


def test_what_has_no_place_is_not_shown(stage: Tab) -> None:
    add(stage, "publisher", "/node", "/t", POINT)
    panel = view(stage, {"kind": "point", "topic": "/t", "radius": 0.3, "color": "#ff0000"})
    emit(stage, "/tf_static", "{ transforms: [transform('a', 'b')] }")
    emit(stage, "/t", "{ header: header(), point: { x: 0, y: 0, z: 0 } }")
    assert at(pixels(panel), 0, 0) == "red"
    panel.get_by_label("Fixed frame").select_option("b")
    expect(note(panel)).to_have_text("no frame 'map' in /tf")
    assert at(pixels(panel), 0, 0) == "black"
    emit(stage, "/tf_static", "{ transforms: [transform('map', 'a', [1, 0, 0])] }")
    expect(note(panel)).to_have_text("")
    assert at(pixels(panel), -1, 0) == "red"


SHAPES = {
    "path": (
        "nav_msgs/msg/Path",
        "{ header: header(), poses: [pose(-1, 0), pose(1, 0)].map((pose) => ({ pose })) }",
    ),
    "polygon": (
        "geometry_msgs/msg/PolygonStamped",
        "{ header: header(), polygon: { points: points([-1, 0], [1, 0]) } }",
    ),
}


@pytest.mark.parametrize("kind", SHAPES)
def test_another_topic_begins_with_nothing(stage: Tab, kind: str) -> None:
    type_name, message = SHAPES[kind]
    add(stage, "publisher", "/node", "/t", type_name)
    add(stage, "publisher", "/node", "/other", type_name)
    panel = view(stage, {"kind": kind, "topic": "/t", "width": 0.4, "color": "#00ff00"})
    emit(stage, "/t", message)
    assert at(pixels(panel), 0, 0) == "green"
    panel.locator("summary").click()
    panel.get_by_role("button", name="Options of").click()
    panel.get_by_label("topic").fill("/other")
    panel.get_by_label("topic").press("Enter")
    stage.evaluate("frames()")
    assert at(pixels(panel), 0, 0) == "black"


def test_a_scanner_without_a_limit_sees_nothing_at_infinity(stage: Tab) -> None:
    add(stage, "publisher", "/node", "/t", "sensor_msgs/msg/LaserScan")
    display = {"kind": "laser_scan", "topic": "/t", "size": 1, "color": "#00ff00"}
    panel = view(stage, display, view=None, top=True)
    emit(
        stage,
        "/t",
        "{ header: header(), angle_min: 0, angle_increment: 1, range_min: 0, range_max: Infinity,"
        " ranges: Float32Array.of(9, Infinity), intensities: [] }",
    )
    # The camera shows what there is.
    assert at(pixels(panel), 0, 0) == "green"


def test_odometry_keeps_all_arrows_if_asked(stage: Tab) -> None:
    add(stage, "publisher", "/node", "/t", "nav_msgs/msg/Odometry")
    display = {"kind": "odometry", "topic": "/t", "length": 1, "color": "#ff0000"}
    panel = view(stage, {**display, "keep": 0})
    for position in ["pose(-1.5, 0)", *["pose(1, 1)", "pose(1, 0.5)"] * 60]:
        stage.evaluate(
            f"async () => {{ ros.emit('/t', {{ header: header(), pose: {{ pose: {position} }} }});"
            " await frames(1); }"
        )
    assert at(pixels(panel), -1, 0) == "red"


def test_former_points_stay_where_they_were(stage: Tab) -> None:
    """A scanner turns: its points of before do not turn with it."""
    add(stage, "publisher", "/node", "/t", "sensor_msgs/msg/LaserScan")
    display = {"kind": "laser_scan", "topic": "/t", "size": 0.3, "color": "#00ff00", "decay": 60}
    panel = view(stage, display)
    scan = (
        "{{ header: header('laser', {}), angle_min: 0, angle_increment: 1, range_min: 0,"
        " range_max: 9, ranges: Float32Array.of(1), intensities: [] }}"
    )
    emit(stage, "/tf", "{ transforms: [transform('map', 'laser', [0, 0, 0], 0, 1)] }")
    emit(stage, "/t", scan.format(1))
    emit(stage, "/tf", "{ transforms: [transform('map', 'laser', [0, 0, 0], Math.PI / 2, 2)] }")
    emit(stage, "/t", scan.format(2))
    image = pixels(panel)
    found = [at(image, 1, 0), at(image, 0, 1), at(image, 0, -1), at(image, -1, 0)]
    assert found == ["green", "green", "black", "black"]
    panel.locator("summary").click()
    panel.get_by_role("checkbox", name="Laser scan /t").uncheck()
    stage.evaluate("frames()")
    image = pixels(panel)
    assert [at(image, 1, 0), at(image, 0, 1)] == ["black", "black"]


def test_a_map_is_updated_in_parts(stage: Tab) -> None:
    updates = "map_msgs/msg/OccupancyGridUpdate"
    add(stage, "publisher", "/node", "/t", "nav_msgs/msg/OccupancyGrid")
    panel = view(stage, {"kind": "map", "topic": "/t", "alpha": 1})
    emit(
        stage,
        "/t",
        "{ header: header(), info: { width: 4, height: 4, resolution: 1, origin: pose(-2, -2) },"
        " data: new Int8Array(16) }",
    )
    # Before somebody publishes them, and only while somebody looks.
    assert subscribed(stage) == ["/t", "/t_updates", "/tf", "/tf_static"]
    add(stage, "publisher", "/node", "/t_updates", updates)
    part = "{{ header: header(), x: {}, y: {}, width: 1, height: 2, data: Int8Array.of(100, 100) }}"
    emit(stage, "/t_updates", part.format(2, 1))
    image = pixels(panel)
    cells = [(0.5, -0.5), (0.5, 0.5), (-0.5, 0.5), (0.5, 1.5), (1.5, -0.5)]
    assert [at(image, *cell) for cell in cells] == ["black", "black", "white", "white", "white"]
    emit(stage, "/t_updates", part.format(0, 3))
    expect(note(panel)).to_have_text("an update lies outside of the map")
    emit(stage, "/t_updates", part.format(0, 2))
    expect(note(panel)).to_have_text("")
    assert at(pixels(panel), -1.5, 0.5) == "black"
    # Colours of another scheme, and a part of them at once.
    panel.locator("summary").click()
    panel.get_by_role("button", name="Options of").click()
    panel.get_by_label("scheme").select_option("raw")
    stage.evaluate(f"ros.emit('/t_updates', {part.format(3, 0)})")
    stage.evaluate("frames()")
    image = pixels(panel)
    assert (at(image, -0.5, 0.5), at(image, -1.5, -1.5)) == ("black", "black")
    hide_tab(stage, True)
    assert subscribed(stage) == []


def test_frames_that_are_heard_of_no_more_disappear(stage: Tab) -> None:
    add(stage, "publisher", "/old", "/tf", "tf2_msgs/msg/TFMessage")
    display = {"kind": "tf", "names": False, "arrows": False, "scale": 5, "timeout": 0.5}
    panel = view(stage, display)
    old = "{ transforms: [transform('map', 'old', [-1, 0, 0], 0, 1)] }"
    # The one that grows old is the last one, however long a frame takes to draw.
    emit(stage, "/tf_static", "{ transforms: [transform('map', 'fixed', [-1, 1, 0])] }")
    emit(stage, "/tf", old)
    assert at(pixels(panel), -0.5, 0) == "red"
    # All are silent, as when a bag is paused: nothing grows old.
    stage.wait_for_timeout(700)
    panel.locator("canvas").press("+")
    panel.locator("canvas").press("-")
    stage.evaluate("frames()")
    assert at(pixels(panel), -0.5, 0) == "red"
    # Others go on.
    moving = "ros.emit('/tf', {{ transforms: [transform('map', 'new', [-1, -1, 0], 0, {})] }})"
    stage.evaluate("void (window.second = 1)")
    stage.evaluate(f"setInterval(() => {moving.format('++window.second')}, 50)")
    expect_colors(panel, {(-0.5, 0): "black", (-0.5, -1): "red", (-0.5, 1): "red"})
    # It is heard of again, and again: once would be over before a slow machine has looked.
    again = f"ros.emit('/tf', {old.replace('0, 1)', '0, ++window.second)')})"
    stage.evaluate(f"setInterval(() => {again}, 50)")
    expect_colors(panel, {(-0.5, 0): "red"})
    # Nobody publishes any more.
    stage.evaluate("for (let id = 0; id < 1000; id++) clearInterval(id); ros.graph.remove('/old')")
    expect_colors(panel, {(-0.5, 0): "black", (-0.5, -1): "black", (-0.5, 1): "red"})


def test_a_replaced_robot_leaves_nothing_on_the_graphics_card(stage: Tab) -> None:
    stage.evaluate(
        """() => {
          window.buffers = 0;
          const card = WebGL2RenderingContext.prototype;
          for (const [name, step] of [["createBuffer", 1], ["deleteBuffer", -1]]) {
            const real = card[name];
            card[name] = function (...all) {
              window.buffers += step;
              return real.apply(this, all);
            };
          }
        }"""
    )
    add(stage, "publisher", "/node", "/t", "std_msgs/msg/String", transientLocal=True)
    panel = view(stage, {"kind": "robot", "topic": "/t"})
    robot = """`<robot name="r"><link name="base"><visual><geometry><box size="1 1 ${size}"/>
      </geometry></visual></link></robot>`"""
    show = f"async (size) => {{ ros.emit('/t', {{ data: {robot} }}); await frames(); }}"
    stage.evaluate(show, 1)
    before = stage.evaluate("buffers")
    for size in range(2, 8):
        stage.evaluate(show, size)
    assert at(pixels(panel), 0.3, 0.3) == "white"
    assert stage.evaluate("buffers") == before


def test_displays_of_one_mesh_have_their_own_opacity(stage: Tab, tmp_path: Path) -> None:
    (tmp_path / "square.dae").write_text(DAE)
    resources = {"package://robot/square.dae": "square.dae"}
    shown: list[dict[str, Any]] = [
        {"kind": "robot", "topic": "/a"},
        {"kind": "robot", "topic": "/b", "alpha": 0},
    ]
    panel = view(stage, *shown, frame="", resources=resources)
    for name, x in (("/a", -1), ("/b", 1)):
        add(stage, "publisher", "/node", name, "std_msgs/msg/String", transientLocal=True)
        robot = (
            f'<robot name="r"><link name="base"/><link name="l"><visual><geometry><mesh'
            f' filename="package://robot/square.dae" scale="0.5 0.5 1"/></geometry></visual></link>'
            f'<joint name="j" type="fixed"><parent link="base"/><child link="l"/>'
            f'<origin xyz="{x} 0 0"/></joint></robot>'
        )
        emit(stage, name, repr({"data": robot}))
    expect_colors(panel, {(-1, 0): "green", (1, 0): "black"})


DAE = """<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
  <library_effects><effect id="e"><profile_COMMON><technique sid="t"><lambert>
    <diffuse><color>0 1 0 1</color></diffuse></lambert></technique></profile_COMMON></effect>
  </library_effects>
  <library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
  <library_geometries><geometry id="g"><mesh>
    <source id="p"><float_array id="pa" count="12">-1 -1 0 1 -1 0 1 1 0 -1 1 0</float_array>
      <technique_common><accessor source="#pa" count="4" stride="3">
        <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
      </accessor></technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <triangles count="2" material="mm"><input semantic="VERTEX" source="#v" offset="0"/>
      <p>0 1 2 0 2 3</p></triangles>
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"><bind_material>
    <technique_common><instance_material symbol="mm" target="#m"/></technique_common>
  </bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>"""
