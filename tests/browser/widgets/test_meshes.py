"""Meshes of each format, and the transforms of robots."""

from __future__ import annotations

import base64
import json
import math
import random
import struct
from pathlib import Path

import pytest
from PIL import Image
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from scenes import at, emit, expect_colors, pixels, view
from stage import add

# A square from -1 to 1, as two triangles.
CORNERS = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, -1, 0), (1, 1, 0), (-1, 1, 0)]


def stl() -> bytes:
    found = bytearray(80) + struct.pack("<I", 2)
    for start in (0, 3):
        corners = [part for corner in CORNERS[start : start + 3] for part in corner]
        found += struct.pack("<12fH", 0, 0, 1, *corners, 0)
    return bytes(found)


def obj() -> bytes:
    lines = [f"v {x} {y} {z}" for x, y, z in CORNERS]
    return "\n".join([*lines, "f 1 2 3", "f 4 5 6"]).encode()


def dae() -> bytes:
    numbers = " ".join(str(part) for corner in CORNERS for part in corner)
    return f"""<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
  <library_geometries><geometry id="g"><mesh>
    <source id="p"><float_array id="pa" count="18">{numbers}</float_array><technique_common>
      <accessor source="#pa" count="6" stride="3">
        <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
      </accessor></technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <triangles count="2"><input semantic="VERTEX" source="#v" offset="0"/>
      <p>0 1 2 3 4 5</p></triangles>
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="s">
    <node><instance_geometry url="#g"/></node>
  </visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>""".encode()


def gltf() -> bytes:
    data = struct.pack("<18f", *(part for corner in CORNERS for part in corner))
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    description = {
        "asset": {"version": "2.0"},
        "buffers": [{"byteLength": len(data), "uri": uri}],
        "bufferViews": [{"buffer": 0, "byteLength": len(data)}],
        "accessors": [
            {
                **{"bufferView": 0, "componentType": 5126, "count": 6, "type": "VEC3"},
                **{"min": [-1, -1, 0], "max": [1, 1, 0]},
            }
        ],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "nodes": [{"mesh": 0}],
        "scenes": [{"nodes": [0]}],
        "scene": 0,
    }
    return json.dumps(description).encode()


MESHES = {"stl": stl, "obj": obj, "dae": dae, "gltf": gltf}


@pytest.mark.parametrize("kind", MESHES)
def test_a_mesh_of_each_format_is_drawn(stage: Tab, tmp_path: Path, kind: str) -> None:
    (tmp_path / f"square.{kind}").write_bytes(MESHES[kind]())
    url = f"package://robot/square.{kind}"
    add(stage, "publisher", "/node", "/t", "visualization_msgs/msg/Marker")
    panel = view(stage, {"kind": "markers", "topic": "/t"}, resources={url: f"square.{kind}"})
    emit(stage, "/t", f"marker({{ type: 10, mesh_resource: '{url}' }})")
    expect_colors(panel, {(0.8, 0.8): "red", (-0.8, 0.5): "red", (1.3, 0): "black"})


def test_a_mesh_without_normals_is_lit(stage: Tab, tmp_path: Path) -> None:
    facet = "facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n"
    corners = [f"vertex {x} {y} {z}\n" for x, y, z in CORNERS]
    facets = [facet.format("".join(corners[at : at + 3])) for at in (0, 3)]
    (tmp_path / "square.stl").write_text(f"solid square\n{''.join(facets)}endsolid square\n")
    url = "package://robot/square.stl"
    add(stage, "publisher", "/node", "/t", "visualization_msgs/msg/Marker")
    panel = view(stage, {"kind": "markers", "topic": "/t"}, resources={url: "square.stl"})
    # A program may name the file by the folder of its package, too.
    named = "file:///ros/share/robot/square.stl"
    emit(stage, "/t", f"marker({{ type: 10, mesh_resource: '{named}' }})")
    expect_colors(panel, {(0.8, 0.8): "red", (-0.8, 0.5): "red", (1.3, 0): "black"})


def test_a_mesh_that_is_damaged_is_told(stage: Tab, tmp_path: Path) -> None:
    (tmp_path / "bad.gltf").write_bytes(b"{")
    url = "package://robot/bad.gltf"
    add(stage, "publisher", "/node", "/t", "visualization_msgs/msg/Marker")
    panel = view(stage, {"kind": "markers", "topic": "/t"}, resources={url: "bad.gltf"})
    emit(stage, "/t", f"marker({{ type: 10, mesh_resource: '{url}' }})")
    note = panel.locator(".ros-display-list .ros-note")
    expect(note).to_contain_text("package://robot/bad.gltf could not be loaded")


ROBOT = """<robot name="r">
  <material name="red"><color rgba="1 0 0 1"/></material>
  <link name="base"><visual>
    <geometry><box size="1 1 0.1"/></geometry><material name="red"/>
  </visual></link>
  <link name="mast"><visual>
    <geometry><mesh filename="package://robot/square.stl" scale="0.3 0.3 1"/></geometry>
    <material name="green"><color rgba="0 1 0 1"/></material>
  </visual></link>
  <joint name="j" type="fixed">
    <parent link="base"/><child link="mast"/><origin xyz="1.2 0 0" rpy="0 0 0.785"/>
  </joint>
</robot>"""


def test_a_robot_stands_where_its_frames_are(stage: Tab, tmp_path: Path) -> None:
    (tmp_path / "square.stl").write_bytes(stl())
    resources = {"package://robot/square.stl": "square.stl"}
    add(stage, "publisher", "/node", "/t", "std_msgs/msg/String", transientLocal=True)
    panel = view(stage, {"kind": "robot", "topic": "/t"}, resources=resources)
    emit(stage, "/t", json.dumps({"data": ROBOT}))
    note = panel.locator(".ros-display-list .ros-note")
    expect(note).to_have_text("no transforms of base, mast")
    # Without transforms, it stands as the description says.
    expect_colors(panel, {(0, 0): "red", (1.2, 0): "green", (0.7, 0): "black"})
    emit(stage, "/tf", "{ transforms: [transform('map', 'base', [0, 1, 0])] }")
    expect(note).to_have_text("no transforms of mast")
    expect_colors(panel, {(0, 1): "red", (1.2, 1): "green", (0, 0): "black"})
    emit(stage, "/tf", "{ transforms: [transform('base', 'mast', [0, -2, 0])] }")
    expect(note).to_have_text("")
    assert at(pixels(panel), 0, -1) == "green"


def box(name: str, x: float, material: str) -> str:
    """A link with a box, and the joint that puts it at `x`."""
    joint = f'''<joint name="to_{name}" type="fixed"><parent link="base"/><child link="{name}"/>
      <origin xyz="{x} 0 0"/></joint>'''
    return f'''<link name="{name}"><visual><geometry><box size="0.4 0.4 0.1"/></geometry>
      {material}</visual></link>{joint}'''


GREEN, BLUE = '<color rgba="0 1 0 1"/>', '<color rgba="0 0 1 1"/>'
MATERIALS = f"""<robot name="r"><link name="base"/>
  {box("a", -1.5, f'<material name="one">{GREEN}</material>')}
  {box("b", -0.9, '<material name="one"/>')}
  {box("c", -0.3, f'<material name="one">{BLUE}</material>')}
  {box("d", 0.3, f'<material name="two">{BLUE}</material>')}
  {box("e", 0.9, f'<material name="">{BLUE}</material>')}
  {box("f", 1.5, '<material name="none"/>')}
  <material name="two"><color rgba="1 0 0 1"/></material>
  <material name="two">{GREEN}</material>
</robot>"""


def test_materials_are_shared_by_the_rules_of_urdfdom(stage: Tab) -> None:
    """The first definition of a name holds; those of the robot come before those of its links."""
    add(stage, "publisher", "/node", "/t", "std_msgs/msg/String", transientLocal=True)
    panel = view(stage, {"kind": "robot", "topic": "/t"}, frame="")
    emit(stage, "/t", json.dumps({"data": MATERIALS}))
    colors: dict[tuple[float, float], str] = {
        **{(-1.5, 0): "green", (-0.9, 0): "green", (-0.3, 0): "green"},
        **{(0.3, 0): "red", (0.9, 0): "blue", (1.5, 0): "white"},
    }
    expect_colors(panel, colors)
    # A robot without frames is complete, so this is only about its materials.
    expect(panel.locator(".ros-display-list .ros-note")).to_have_text(
        "material 'two' is defined twice; material 'none' of link 'f' is not defined"
    )


def test_a_material_may_be_a_texture_alone(stage: Tab, tmp_path: Path) -> None:
    Image.new("RGB", (2, 2), (0, 255, 0)).save(tmp_path / "green.png")
    texture = '<texture filename="{}"/>'
    url = "package://robot/green.png"
    robot = f"""<robot name="r"><link name="base"/>
      {box("a", -0.5, f'<material name="one">{texture.format(url)}</material>')}
      {box("b", 0.5, f'<material name="one">{BLUE}</material>')}
      {box("c", 1.5, f'<material name="two">{texture.format("package://robot/no.png")}</material>')}
    </robot>"""
    add(stage, "publisher", "/node", "/t", "std_msgs/msg/String", transientLocal=True)
    panel = view(stage, {"kind": "robot", "topic": "/t"}, frame="", resources={url: "green.png"})
    emit(stage, "/t", json.dumps({"data": robot}))
    expect_colors(panel, {(-0.5, 0): "green", (0.5, 0): "green", (1.5, 0): "white"})
    expect(panel.locator(".ros-display-list .ros-note")).to_have_text(
        "the site does not contain package://robot/no.png"
    )


Matrix = list[list[float]]


def matrix(position: list[float], rotation: list[float]) -> Matrix:
    """A transform as a matrix with four rows, from the textbook."""
    x, y, z, w = rotation
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), position[0]],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), position[1]],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), position[2]],
        [0, 0, 0, 1],
    ]


def product(a: Matrix, b: Matrix) -> Matrix:
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def test_chains_of_transforms_are_their_product(stage: Tab) -> None:
    """From a leaf of a tree of random transforms to another one."""
    chance = random.Random(17)
    parents = {f"f{n}": f"f{chance.randrange(n)}" for n in range(1, 30)}
    poses: dict[str, tuple[list[float], list[float]]] = {}
    for frame in parents:
        q = [chance.gauss(0, 1) for _ in range(4)]
        length = math.hypot(*q)
        poses[frame] = [chance.uniform(-5, 5) for _ in range(3)], [part / length for part in q]

    def to_root(frame: str) -> Matrix:
        if frame not in parents:
            return matrix([0, 0, 0], [0, 0, 0, 1])
        return product(to_root(parents[frame]), matrix(*poses[frame]))

    found = stage.evaluate(
        """async ([parents, poses]) => {
          const { Transforms } = await import("./runtime/widgets/tf/transforms.js");
          const transforms = new Transforms();
          for (const [child, parent] of Object.entries(parents)) {
            const [[x, y, z], [a, b, c, d]] = poses[child];
            const header = { frame_id: parent, stamp: { sec: 5, nanosec: 0 } };
            const rotation = { x: a, y: b, z: c, w: d };
            const transform = { translation: { x, y, z }, rotation };
            transforms.add({ header, child_frame_id: child, transform }, false);
          }
          return Object.keys(parents).map((frame) => transforms.lookup("f29", frame).pose);
        }""",
        [parents, poses],
    )
    for frame, pose in zip(parents, found, strict=True):
        there = product(to_root("f29"), matrix(pose["position"], pose["rotation"]))
        for got, wanted in zip(there, to_root(frame), strict=True):
            assert got == pytest.approx(wanted, abs=1e-9)
