"""The windows of a launch file become widgets of its page."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from paths import ROOT

from sitegen import config
from sitegen.model import Layout, Site, Widget

LAUNCH = """
launch:
- push_ros_namespace: {namespace: robot}
- node: {pkg: rviz2, exec: rviz2, args: "-d $(find-pkg-share mine)/view.rviz -f base"}
- node: {pkg: rqt_plot, exec: rqt_plot, args: "/odom/twist/twist/linear:angular /imu.orientation.x"}
- node: {pkg: rqt_image_view, exec: rqt_image_view, args: camera/image}
- node: {pkg: rqt_graph, exec: rqt_graph}
- node: {pkg: rqt_console, exec: rqt_console}
- node: {pkg: rqt_robot_monitor, exec: rqt_robot_monitor}
- node: {pkg: rqt_reconfigure, exec: rqt_reconfigure}
- node: {pkg: rqt_robot_steering, exec: rqt_robot_steering}
- node:
    pkg: joint_state_publisher_gui
    exec: joint_state_publisher_gui
    param:
    - {name: zeros, param: [{name: elbow, value: 1.5}, {name: lift, value: 1}]}
    - {name: use_sim_time, value: true}
    - {name: rate, value: 30}
- node: {pkg: rqt_bag, exec: rqt_bag}
"""
VIEW = """
Visualization Manager:
  Global Options: {Fixed Frame: map}
  Displays:
    - {Class: rviz_default_plugins/Path, Topic: {Value: /plan}}
    - {Class: my_plugins/Strange}
"""


@pytest.fixture
def site(tmp_path: Path) -> Site:
    package = tmp_path / "src/mine"
    package.mkdir(parents=True)
    (package / "package.xml").write_text(
        '<package format="3"><name>mine</name><version>1.0.0</version>'
        "<export><build_type>ament_cmake</build_type></export></package>"
    )
    (package / "CMakeLists.txt").write_text("project(mine)\n")
    (package / "view.rviz").write_text(VIEW)
    (package / "all.launch.yaml").write_text(LAUNCH)
    (tmp_path / "site.yaml").write_text(
        "site: {title: Robot}\npages: [{path: /, title: Robot, launch: src/mine/all.launch.yaml}]\n"
    )
    return config.load(tmp_path / "site.yaml")


def widgets(site: Site) -> dict[str, Any]:
    found = [part for part in site.pages[0].leaves if isinstance(part, Widget)]
    return {widget.kind: widget.options for widget in found}


def test_each_window_has_its_widget(site: Site) -> None:
    found = widgets(site)
    assert list(found)[:1] == ["3d"]
    assert {"plot", "image", "graph", "log", "teleop", "joints"} <= set(found)
    assert found["3d"] == {"frame": "base", "displays": [{"kind": "path", "topic": "/plan"}]}
    assert found["plot"]["series"] == [
        "/odom/twist/twist/linear",
        "/odom/twist/twist/angular",
        "/imu.orientation.x",
    ]
    assert found["image"]["topic"] == "/robot/camera/image"
    assert found["joints"]["zeros"] == {"elbow": 1.5, "lift": 1}


def test_the_view_stands_beside_the_others(site: Site) -> None:
    [layout] = [part for part in site.pages[0].content if isinstance(part, Layout)]
    assert [cell.size for cell in layout.cells] == [3, 2]
    assert [len(cell.content) for cell in layout.cells] == [1, 1]


def test_what_has_no_counterpart_is_named(site: Site) -> None:
    assert any("my_plugins/Strange: not supported in the 3D view" in note for note in site.notes)
    assert any("'rqt_bag' is skipped" in note for note in site.notes)
    [ignored] = [note for note in site.notes if "is ignored" in note]
    assert "joint_state_publisher_gui: parameter 'rate' is ignored" in ignored


def test_a_page_with_widgets_keeps_its_own(tmp_path: Path, site: Site) -> None:
    text = (tmp_path / "site.yaml").read_text()
    (tmp_path / "site.yaml").write_text(text.replace("}]", ", content: [{log: }]}]"))
    assert list(widgets(config.load(tmp_path / "site.yaml"))) == ["log"]


def test_a_window_may_have_no_arguments(tmp_path: Path, site: Site) -> None:
    file = tmp_path / "src/mine/all.launch.yaml"
    file.write_text("launch:\n- node: {pkg: rviz2, exec: rviz2}\n")
    assert widgets(config.load(tmp_path / "site.yaml")) == {"3d": {}}


@pytest.mark.parametrize(("count", "is_staged"), [(3, False), (4, True)])
def test_a_view_of_many_nodes_is_on_a_stage(
    tmp_path: Path, site: Site, count: int, is_staged: bool
) -> None:
    nodes = "".join(
        f"- node: {{pkg: robot_state_publisher, exec: robot_state_publisher, name: n{number}}}\n"
        for number in range(count)
    )
    file = tmp_path / "src/mine/all.launch.yaml"
    file.write_text(f"launch:\n{nodes}- node: {{pkg: rviz2, exec: rviz2}}\n")
    found = config.load(tmp_path / "site.yaml").pages[0].content
    kinds = [part.kind for part in found if isinstance(part, Layout | Widget)]
    assert kinds == (["stage"] if is_staged else ["3d", *["buttons", "console"] * count])
    if is_staged:
        stage = found[0]
        assert isinstance(stage, Layout)
        assert [cell.title for cell in stage.cells] == ["nodes", "show", "beside"]
        assert [len(cell.content) for cell in stage.cells] == [4, 1, 4]


def test_a_view_from_above_shows_what_the_window_of_rviz_showed(tmp_path: Path, site: Site) -> None:
    view = """
  Views: {Current: {Class: rviz_default_plugins/TopDownOrtho, Scale: 54, X: -5, Y: 1}}
"""
    for geometry, metres in (("", 600 / 54), ("Window Geometry: {Height: 900}\n", 15)):
        (tmp_path / "src/mine/view.rviz").write_text(VIEW + view + geometry)
        found = widgets(config.load(tmp_path / "site.yaml"))["3d"]["view"]
        assert found["target"] == [-5, 1, 0]
        assert 2 / found["zoom"] == pytest.approx(metres)


def test_the_demos_are_what_they_say() -> None:
    rover = widgets(config.load(ROOT / "demos/demo11/site.yaml"))
    assert list(rover)[:4] == ["3d", "teleop", "plot", "log"]
