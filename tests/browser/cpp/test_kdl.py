"""The packages that use KDL, which takes minutes to compile for the page."""

from __future__ import annotations

import io
import subprocess
from pathlib import Path

import pytest
from browser import Serve
from configuring import header_folders
from packages import Workspace
from panel import Panel
from playwright.sync_api import Page

from sitegen.cache.folder import cache_folder
from sitegen.nodes.cpp.sources import LibrarySources
from sitegen.nodes.cpp.toolchain import Toolchain
from sitegen.report import Report
from sitegen.shipped import PACKAGES
from sitegen.workspace import shipped_packages

SOURCES = cache_folder() / "sources"
# The inertia of `tool` is 1, 2, 3 along axes that are turned by 90 degrees about z.
MAIN = """\
#include <cstdio>
#include <kdl_parser/kdl_parser.hpp>
#include <tf2_kdl/tf2_kdl.hpp>

constexpr char ARM[] = R"(
<robot name="arm">
  <link name="base"/>
  <link name="lift"/>
  <link name="tool"><inertial>
    <origin xyz="0.5 0 0" rpy="0 0 1.5707963267948966"/>
    <mass value="2"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="3"/>
  </inertial></link>
  <joint name="up" type="prismatic">
    <parent link="base"/><child link="lift"/><origin xyz="1 0 0" rpy="0 1.5707963267948966 0"/>
    <axis xyz="1 0 0"/><limit lower="0" upper="1" effort="1" velocity="1"/>
  </joint>
  <joint name="turn" type="continuous">
    <parent link="lift"/><child link="tool"/><origin xyz="0 0 2"/><axis xyz="0 0 1"/>
  </joint>
</robot>)";

void print(const char * what, const KDL::Vector & v)
{
  std::printf("%s %.3f %.3f %.3f\\n", what, v.x() + 0.0, v.y() + 0.0, v.z() + 0.0);
}

int main()
{
  KDL::Tree tree;
  std::printf("bad: %d\\n", kdl_parser::treeFromString("<robot/>", tree));
  if (!kdl_parser::treeFromString(ARM, tree)) {
    return 1;
  }
  std::printf("joints %u, segments %u\\n", tree.getNrOfJoints(), tree.getNrOfSegments());
  const KDL::Segment lift = GetTreeElementSegment(tree.getSegment("lift")->second);
  const KDL::Segment tool = GetTreeElementSegment(tree.getSegment("tool")->second);
  print("lifted", lift.pose(0.25).p);
  print("tool", (lift.pose(0.25) * tool.pose(1.5707963267948966)).p);
  auto inertia = tool.getInertia();
  const auto about = inertia.RefPoint(inertia.getCOG()).getRotationalInertia();
  std::printf("mass %g, about %.3f %.3f %.3f\\n", inertia.getMass(),
    about.data[0], about.data[4], about.data[8]);

  const auto transform = tf2::kdlToTransform(lift.pose(0.25));
  tf2::Stamped<KDL::Vector> point(KDL::Vector(0, 0, 1), tf2::TimePointZero, "lift"), moved;
  tf2::doTransform(point, moved, transform);
  print("moved", moved);
  const auto message = tf2::toMsg(moved);
  tf2::Stamped<KDL::Vector> back;
  tf2::fromMsg(message, back);
  print("back", tf2::transformToKDL(transform).Inverse() * back);
  return 0;
}
"""
PRINTED = [
    "joints 2, segments 2",
    "lifted 1.000 0.000 -0.250",
    "tool 3.000 0.000 -0.250",
    "mass 2, about 2.000 1.000 3.000",
    "moved 2.000 0.000 -0.250",
    "back 0.000 0.000 1.000",
]


def test_their_sources_are_valid(tmp_path: Path) -> None:
    """The test below compiles them for the page, and KDL with them."""
    sources = LibrarySources(SOURCES, Report(io.StringIO()))
    for name in ("orocos_kdl", "urdfdom_headers"):
        assert sources.of(shipped_packages()[name])
    # The package orocos_kdl gives its headers this name.
    (tmp_path / "kdl").symlink_to(SOURCES / "orocos_kdl/orocos_kdl/src")
    (tmp_path / "config.h").touch()
    (tmp_path / "main.cpp").write_text(MAIN)
    tools = Toolchain.find()
    assert tools.eigen
    folders = [
        *(tmp_path, tools.eigen.parents[2] / "include/eigen3"),
        *(SOURCES / "urdfdom_headers/include", *SOURCES.glob("urdfdom_headers/*/include")),
        *header_folders(tmp_path / "prefix"),
    ]
    done = subprocess.run(
        [
            *(tools.compiler, tmp_path / "main.cpp", PACKAGES / "kdl_parser/src/kdl_parser.cpp"),
            *("-fsyntax-only", "-std=gnu++17", "-Wall", "-Wextra", "-Wpedantic", "-Werror"),
            *(f"-isystem{folder}" for folder in folders),
        ],
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
    )
    assert (done.returncode, done.stdout) == (0, "")


@pytest.mark.exhaustive
def test_a_robot_description_becomes_a_tree(tmp_path: Path, serve: Serve, tab: Page) -> None:
    workspace = Workspace(tmp_path, cache_folder())
    workspace.package(
        "arm",
        """\
        find_package(kdl_parser REQUIRED)
        find_package(tf2_kdl REQUIRED)
        add_executable(arm src/main.cpp)
        ament_target_dependencies(arm kdl_parser tf2_kdl)
        """,
        depends="kdl_parser tf2_kdl",
        main=MAIN,
    )
    node, content = "{package: arm, executable: arm}", "[{buttons: arm}, {console: arm}]"
    workspace.write(
        "site.yaml",
        f"""\
        site: {{title: Arm, asyncify: false}}
        nodes: {{arm: {node}}}
        pages: [{{path: /, title: Arm, content: {content}}}]
        """,
    )
    workspace.build()
    tab.goto(serve(tmp_path / "dist"))
    panel = Panel(tab, "arm")
    panel.start()
    panel.wait_for(PRINTED[-1])
    assert panel.lines()[-len(PRINTED) :] == PRINTED
