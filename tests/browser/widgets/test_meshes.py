"""Meshes of each format, and the transforms of robots."""

from __future__ import annotations

import base64
import json
import math
import random
import struct
from pathlib import Path

import pytest
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
