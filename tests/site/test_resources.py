"""The files that 3D views load: what is copied, and what is not."""

from __future__ import annotations

import json
import re
from html import unescape
from pathlib import Path

import pytest

from sitegen import config
from sitegen.errors import SiteError
from sitegen.site.pages import render

PACKAGE = (
    '<package format="3"><name>{name}</name><version>1.0.0</version>{depends}'
    "<export><build_type>ament_cmake</build_type></export></package>"
)
URDF = """<?xml version="1.0"?>
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="name" value="arm"/>
  <link name="a"><visual><geometry>
    <mesh filename="package://robot/meshes/${name}.obj"/>
  </geometry></visual></link>
  <link name="b"><visual><geometry>
    <mesh filename="package://robot/meshes/../../../secret.stl"/>
  </geometry></visual></link>
  <link name="c"><visual><geometry>
    <mesh filename="package://robot/meshes/missing.stl"/>
  </geometry></visual></link>
</robot>
"""
PAGE = "site: {title: T}\npages: [{path: a/, title: A, content: [%s]}]\n"


@pytest.fixture
def site(tmp_path: Path) -> Path:
    folder = tmp_path / "src/robot"
    (folder / "meshes/textures").mkdir(parents=True)
    (folder / "package.xml").write_text(PACKAGE.format(name="robot", depends=""))
    (folder / "CMakeLists.txt").write_text("project(robot)\n")
    (folder / "robot.urdf.xacro").write_text(URDF)
    (folder / "meshes/arm.obj").write_text("mtllib arm.mtl\nv 0 0 0\n")
    (folder / "meshes/arm.mtl").write_text(
        "newmtl a\nmap_Kd -clamp on textures/a.png\nmap_Ks ../../../secret.png\nmap_Ka data:x.png\n"
    )
    (folder / "meshes/textures/a.png").write_bytes(b"png")
    (folder / "meshes/unused.stl").write_bytes(b"stl")
    (tmp_path / "secret.stl").write_bytes(b"secret")
    (tmp_path / "secret.png").write_bytes(b"secret")
    view = "{3d: {displays: [{robot: {file: src/robot/robot.urdf.xacro}}]}}"
    (tmp_path / "site.yaml").write_text(PAGE % view)
    return tmp_path / "site.yaml"


def made(file: Path) -> dict[str, bytes]:
    artifacts = render(config.load(file))
    return {
        one.path: one.source if isinstance(one.source, bytes) else one.source.read_bytes()
        for one in artifacts
    }


def policy(files: dict[str, bytes]) -> str:
    html = files["a/index.html"].decode()
    (found,) = re.findall(r'Content-Security-Policy" content="([^"]+)"', html)
    return unescape(found)


def test_what_a_description_names_is_copied_with_what_that_names(site: Path) -> None:
    files = made(site)
    meshes = sorted(path for path in files if path.startswith("meshes/"))
    [description] = [path for path in meshes if path.endswith(".urdf")]
    assert meshes == [
        description,
        "meshes/robot/meshes/arm.mtl",
        "meshes/robot/meshes/arm.obj",
        "meshes/robot/meshes/textures/a.png",
    ]
    [widget] = json.loads(files["a/page.json"])["widgets"]
    resources = widget["options"]["resources"]
    assert resources["package://robot/meshes/arm.obj"] == "../meshes/robot/meshes/arm.obj"
    assert resources["src/robot/robot.urdf.xacro"] == f"../{description}"
    # xacro has done its work.
    assert b"meshes/arm.obj" in files[description]
    assert "img-src 'self' data:;" in policy(files)


def test_only_pages_with_gltf_files_may_load_blobs(site: Path) -> None:
    package = site.parent / "src/robot"
    (package / "robot.urdf.xacro").write_text(URDF.replace(".obj", ".gltf"))
    (package / "meshes/arm.gltf").write_text('{"buffers": [{"uri": "arm.bin"}]}')
    (package / "meshes/arm.bin").write_bytes(b"bin")
    files = made(site)
    assert "meshes/robot/meshes/arm.bin" in files
    assert "img-src 'self' data: blob:;" in policy(files)


def test_a_description_that_is_wrong_is_told(site: Path) -> None:
    (site.parent / "src/robot/robot.urdf.xacro").write_text("<robot>${nothing}</robot>")
    with pytest.raises(SiteError, match=r"3d: src/robot/robot\.urdf\.xacro: xacro"):
        made(site)
