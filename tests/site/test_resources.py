"""The files that 3D views load: what is copied, and what is not."""

from __future__ import annotations

import io
import json
import re
from html import unescape
from pathlib import Path
from urllib.parse import unquote
from xml.sax.saxutils import quoteattr

import pytest

from sitegen import config
from sitegen.build import make
from sitegen.errors import SiteError
from sitegen.options import Options
from sitegen.report import Report
from sitegen.site.pages import Renderer, render

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


LAUNCH = """<launch><node pkg="robot" exec="node" name="node">
<param name="robot_description" value="$(command 'cat $(find-pkg-share robot)/robot.urdf')"/>
</node></launch>
"""
NAMES = (
    *("left_wheel(v2).stl", "piñon.stl", "rear,axle.STL", "a&b.stl", "part#1.stl", "it's.stl"),
    *("v1~2.stl", "my wheel.stl", "50%.dae", "what?.stl"),
)


def described(site: Path, *urls: str) -> Path:
    """Let the page show a description that names meshes, with a package that has all of NAMES."""
    other = site.parent / "src/gripper-description"
    other.mkdir()
    (other / "package.xml").write_text(PACKAGE.format(name="gripper-description", depends=""))
    (other / "CMakeLists.txt").write_text("project(gripper-description)\n")
    (other / "finger.stl").write_bytes(b"stl")
    for name in NAMES:
        (site.parent / "src/robot/meshes" / name).write_bytes(b"stl")
    links = "".join(
        f"<link name='l{at}'><visual><geometry>\n<mesh filename={quoteattr(url)}/>"
        "</geometry></visual></link>\n"
        for at, url in enumerate(urls)
    )
    file = site.parent / "src/robot/robot.urdf"
    file.write_text(f"<?xml version='1.0' encoding='utf-8'?>\n<robot name='r'>{links}</robot>\n")
    site.write_text(PAGE % "{3d: {displays: [{robot: {file: src/robot/robot.urdf}}]}}")
    return file


def checked(file: Path) -> tuple[dict[str, str], tuple[str, ...]]:
    """What the views of a page with nodes load, and the notes of the site."""
    made = make(file.parent, Report(io.StringIO()), options=Options(compile=False))
    page = next(one.source for one in made.artifacts if one.path == "a/page.json")
    assert isinstance(page, bytes)
    return addresses({"a/page.json": page}), made.site.notes


def notes(file: Path) -> list[str]:
    return [note for page in Renderer(config.load(file), {}).every_page() for note in page.notes]


def addresses(files: dict[str, bytes]) -> dict[str, str]:
    [widget] = [one for one in json.loads(files["a/page.json"])["widgets"] if one["kind"] == "3d"]
    found: dict[str, str] = widget["options"]["resources"]
    return found


def test_meshes_have_any_name(site: Path) -> None:
    urls = [f"package://robot/meshes/{name}" for name in NAMES]
    described(site, *urls, "package://gripper-description/finger.stl")
    found = made(site)
    assert {path for path in found if path.startswith("meshes/") and ".urdf" not in path} == {
        *(f"meshes/robot/meshes/{name}" for name in NAMES),
        "meshes/gripper-description/finger.stl",
    }
    known = addresses(found)
    for url in urls:
        path = url.replace("package://", "../meshes/")
        assert unquote(known[url]) == path
        # A static server finds the file by this address.
        assert not set(known[url]) & set("#?& '")
    assert notes(site) == []


@pytest.mark.parametrize(
    "written",
    [
        "file://{folder}/meshes/a&b.stl",
        "{folder}/meshes/a&b.stl",
        "file://{folder}/urdf/../meshes/a&b.stl",
        "file:///ros/share/robot/meshes/a&b.stl",
        "package://robot/meshes/a%26b.stl",
    ],
)
def test_a_mesh_is_named_by_any_address(site: Path, written: str) -> None:
    folder = site.parent / "src/robot"
    described(site, written.format(folder=folder))
    found = made(site)
    assert "meshes/robot/meshes/a&b.stl" in found
    [(url, address)] = [one for one in addresses(found).items() if one[0].endswith("b.stl")]
    assert url.startswith("package://robot/")
    assert address == "../meshes/robot/meshes/a%26b.stl"
    assert notes(site) == []
    for path, content in found.items():
        assert str(site.parent).encode() not in content, path


def test_xacro_publishes_no_path_of_the_author(site: Path) -> None:
    described(site)
    package = site.parent / "src/robot"
    (package / "robot.urdf.xacro").write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:property name="at" value="file://$(find robot)/meshes"/><link name="a"><visual>'
        '<geometry><mesh filename="${at}/a&amp;b.stl"/></geometry></visual></link>'
        '<gazebo><plugin name="p"><parameters>$(find robot)/config/p.yaml</parameters></plugin>'
        f"<a>{site.parent}/else.yaml</a></gazebo></robot>"
    )
    site.write_text(PAGE % "{3d: {displays: [{robot: {file: src/robot/robot.urdf.xacro}}]}}")
    found = made(site)
    assert "meshes/robot/meshes/a&b.stl" in found
    [text] = [content.decode() for path, content in found.items() if path.endswith(".urdf")]
    assert "<parameters>/ros/share/robot/config/p.yaml</parameters>" in text
    assert "<a>/ros/workspace/else.yaml</a>" in text
    assert str(site.parent) not in text


def test_meshes_that_programs_name_are_copied(site: Path) -> None:
    described(site)
    folder = site.parent / "src/robot"
    (folder / "node.py").write_text(
        'mesh = "file://" + get_package_share_directory("robot") + "/meshes/part#1.stl"\n'
        'other = "package://robot/meshes/it\'s.stl"\n'
    )
    (folder / "node.cpp").write_text('auto name = "package://robot/meshes/my wheel.stl";\n')
    (folder / "CMakeLists.txt").write_text("project(robot)\nadd_executable(node node.cpp)\n")
    node = "\nnodes: {node: {package: robot, executable: node}}"
    page = PAGE % "{3d: {displays: [markers]}}, {console: node}"
    site.write_text(page.replace("\n", f"{node}\n", 1))
    assert set(checked(site)[0]) >= {
        *("package://robot/meshes/part#1.stl", "package://robot/meshes/it's.stl"),
        "package://robot/meshes/my wheel.stl",
    }


@pytest.mark.parametrize(
    ("url", "why"),
    [
        ("package://robot/meshes/mising.stl", "no file 'meshes/mising.stl' in package 'robot'; "),
        ("package://nobody/a.stl", "no package 'nobody' in the workspace"),
        ("package://robot/../../secret.stl", "no file '../../secret.stl' in package 'robot'; "),
        ("meshes/arm.obj", "is not in a package; write package://PACKAGE/PATH"),
        ("file:///home/else/a.stl", "is not in a package; write package://PACKAGE/PATH"),
        ("package://robot/meshes/arm.ply", "is not an STL, COLLADA, OBJ or glTF file"),
    ],
)
def test_a_mesh_that_is_missing_is_told_with_its_line(site: Path, url: str, why: str) -> None:
    described(site, "package://robot/meshes/piñon.stl", url, "https://example.org/a.stl")
    [note] = notes(site)
    assert note.startswith(f"src/robot/robot.urdf:5: mesh: '{url}'")
    assert why in note


def test_a_description_that_is_not_xml_is_told_with_its_line(site: Path) -> None:
    described(site).write_text("<robot name='r'>\n<link>\n</robot>\n")
    with pytest.raises(SiteError, match=r"^src/robot/robot\.urdf:3: not well-formed XML"):
        made(site)


def test_a_description_of_a_launch_file_names_meshes(site: Path) -> None:
    described(site, "package://robot/meshes/it's.stl", "package://robot/meshes/no.stl")
    folder = site.parent / "src/robot"
    (folder / "CMakeLists.txt").write_text("project(robot)\nadd_executable(node node.cpp)\n")
    (folder / "node.cpp").write_text("int main() {}\n")
    (folder / "view.launch.xml").write_text(LAUNCH)
    site.write_text(
        "site: {title: T}\npages: [{path: a/, title: A, launch: src/robot/view.launch.xml, "
        "content: [{3d: {displays: [robot]}}]}]\n"
    )
    found, (note,) = checked(site)
    assert "package://robot/meshes/it's.stl" in found
    assert note.startswith("src/robot/robot.urdf:5: mesh: 'package://robot/meshes/no.stl'")
