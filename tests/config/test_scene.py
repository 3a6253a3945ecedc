"""3D views in site.yaml, and what `.rviz` files say of them."""

from __future__ import annotations

import json
import textwrap
from pathlib import Path
from typing import Any

import pytest
from paths import ROOT

from sitegen import config
from sitegen.config import windows
from sitegen.config.displays import kinds
from sitegen.config.rviz import CLASSES, read_configuration
from sitegen.errors import Location, Problems, SiteError
from sitegen.launch import Window
from sitegen.model import Site, Widget

HEAD = """
    site: {title: Robot}
    pages:
      - path: /
        title: Robot
        content:
"""


def loaded(folder: Path, content: str) -> Site:
    lines = textwrap.indent(textwrap.dedent(content).strip(), " " * 10)
    (folder / "site.yaml").write_text(textwrap.dedent(HEAD).strip() + "\n" + lines + "\n")
    return config.load(folder / "site.yaml")


def options(site: Site) -> Any:
    [widget] = [part for part in site.pages[0].leaves if isinstance(part, Widget)]
    assert widget.kind == "3d"
    return widget.options


def test_displays_are_given_by_name_by_topic_or_with_options(tmp_path: Path) -> None:
    site = loaded(
        tmp_path,
        """
        - 3d:
            frame: map
            top: true
            background: "#102030"
            tools: {goal: /my_goal}
            displays:
              - grid
              - laser_scan: /front/scan
              - point_cloud: {topic: /points, size: 0.05, color_by: intensity, enabled: false}
              - tf:
        """,
    )
    assert options(site) == {
        "frame": "map",
        "top": True,
        "background": "#102030",
        "tools": {"goal": "/my_goal"},
        "displays": [
            {"kind": "grid"},
            {"kind": "laser_scan", "topic": "/front/scan"},
            {
                "kind": "point_cloud",
                "topic": "/points",
                "size": 0.05,
                "color_by": "intensity",
                "enabled": False,
            },
            {"kind": "tf"},
        ],
    }
    assert options(loaded(tmp_path, "- 3d:")) == {}


WRONG = {
    "- 3d: /scan": "3d: expected its options or nothing, found the text '/scan'; write",
    "- 3d: view.rviz": "write it like '3d: {rviz: view.rviz}'",
    "- 3d: {rviz: view.rviz}": "3d.rviz: no file 'view.rviz'",
    "- 3d: {displays: [lidar]}": "displays[0]: unknown display 'lidar'",
    "- 3d: {displays: [laser_scn]}": "did you mean 'laser_scan'?",
    "- 3d: {displays: [{laser_scn: /scan}]}": "did you mean 'laser_scan'?",
    "- 3d: {displays: [7]}": "expected a display, found the number 7; write it like",
    "- 3d: {displays: [{grid: /a}]}": "expected its options, found the text '/a'; write",
    "- 3d: {displays: [{grid: {cell: 3}}]}": "unknown option; did you mean 'cells'?",
    "- 3d: {displays: [{grid: {cells: many}}]}": "expected a number, found the text 'many'",
    "- 3d: {displays: [{grid: {plane: XW}}]}": "expected one of XY, XZ, YZ, found the text 'XW'",
    "- 3d: {displays: [{grid: {color: red}}]}": "#2b4bd8\", found the text 'red'",
    "- 3d: {displays: [{tf: {names: maybe}}]}": "expected true or false, found the text 'maybe'",
    "- 3d: {displays: [{path: plan}]}": "expected a topic like /plan, found the text 'plan'",
    "- 3d: {displays: [{robot: {file: none.urdf}}]}": "no file 'none.urdf'",
    "- 3d: {tools: {goa: /goal}}": "no tool 'goa'; there are goal, estimate, point",
}  # fmt: skip


@pytest.mark.parametrize("content", WRONG)
def test_what_is_wrong_is_told_with_its_line(tmp_path: Path, content: str) -> None:
    with pytest.raises(SiteError) as found:
        loaded(tmp_path, content)
    [line] = str(found.value).splitlines()
    assert line.startswith("site.yaml:6: pages[0].content[0].3d")
    assert WRONG[content] in line


def test_a_chosen_background_of_rviz_is_kept(tmp_path: Path) -> None:
    file = tmp_path / "own.rviz"
    file.write_text(
        "Visualization Manager: {Global Options: {Background Color: 20; 24; 34}, Displays: []}"
    )
    assert read_configuration(file).options["background"] == "#141822"


def test_a_file_of_rviz_becomes_a_view(tmp_path: Path) -> None:
    found = read_configuration(ROOT / "demos/demo11/src/rover/rviz/rover.rviz")
    assert found.unsupported == ()
    assert found.options["frame"] == "map"
    # The one with which RViz begins, so the view has that of the theme.
    assert "background" not in found.options
    assert found.options["tools"] == {"goal": "/goal_pose"}
    assert [one["kind"] for one in found.options["displays"]] == [
        *("grid", "map", "robot", "laser_scan", "markers", "odometry"),
    ]
    scan = found.options["displays"][3]
    assert scan == {
        "kind": "laser_scan",
        "topic": "/scan",
        "size": 0.06,
        "alpha": 1,
        "decay": 0,
        "color": "#ff6040",
        "color_by": "color",
    }
    view = found.options["view"]
    assert view["target"] == [4, 2.2, 0]
    # 9.5 m away, 0.85 rad above the floor.
    assert view["eye"][2] == pytest.approx(7.137, abs=0.001)


def test_groups_are_opened_and_what_has_no_counterpart_is_named_once(tmp_path: Path) -> None:
    file = tmp_path / "a.rviz"
    shown: list[dict[str, Any]] = [
        {"Class": "rviz_default_plugins/DepthCloud"},
        {"Class": "rviz_default_plugins/DepthCloud"},
        {
            "Class": "rviz_common/Group",
            "Enabled": False,
            "Displays": [{"Class": "rviz_default_plugins/TF", "Enabled": True}],
        },
        {"Class": "rviz_default_plugins/Path", "Topic": "/former/plan", "Alpha": float("nan")},
    ]
    file.write_text(json.dumps({"Visualization Manager": {"Displays": shown}}))
    found = read_configuration(file)
    assert found.unsupported == ("rviz_default_plugins/DepthCloud",)
    assert found.options["displays"] == [
        {"kind": "tf", "enabled": False},
        {"kind": "path", "topic": "/former/plan"},
    ]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Panels: []", "has no 'Visualization Manager'"),
        ("a: [", "cannot be read as YAML"),
        ("[]", "has no 'Visualization Manager'"),
        ("", "has no 'Visualization Manager'"),
        ("a: &a [*a]", "cannot be read as YAML"),
    ],
)
def test_other_files_are_refused(tmp_path: Path, text: str, said: str) -> None:
    (tmp_path / "a.rviz").write_text(text)
    with pytest.raises(ValueError, match=r"a\.rviz") as found:
        read_configuration(tmp_path / "a.rviz")
    assert said in str(found.value)
    with pytest.raises(SiteError, match=r"site\.yaml:6: .*a\.rviz"):
        loaded(tmp_path, "- 3d: {rviz: a.rviz}")


def test_odd_values_are_left_out(tmp_path: Path) -> None:
    file = tmp_path / "a.rviz"
    odd = {name: {"Class": f"x/{name}"} for name in CLASSES}
    for one in odd.values():
        one |= {"Topic": {"Value": 7}, "Color": "1; 2", "Alpha": "x", "Shape": [], "Enabled": None}  # type: ignore[dict-item]
    views = {"Current": {"Class": "rviz_default_plugins/Orbit", "Distance": "far", "Yaw": None}}
    manager = {"Displays": list(odd.values()), "Views": views, "Tools": 3, "Global Options": []}
    file.write_text(json.dumps({"Visualization Manager": manager}))
    found = read_configuration(file)
    known = [name for name, (kind, _) in CLASSES.items() if kind in kinds()]
    assert [one["kind"] for one in found.options["displays"]] == [CLASSES[n][0] for n in known]
    assert found.options["view"]["target"] == [0, 0, 0]


def test_every_option_of_the_table_exists() -> None:
    for kind, properties in CLASSES.values():
        if kind in kinds():
            assert set(properties) <= set(kinds()[kind].defaults), kind


def test_topics_of_a_window_are_those_of_its_node(tmp_path: Path) -> None:
    """RViz subscribes as any node does: in its namespace, by its remapping rules."""
    file = tmp_path / "a.rviz"
    displays = [
        {"Class": "rviz_default_plugins/LaserScan", "Topic": {"Value": "scan"}},
        {"Class": "rviz_default_plugins/Map", "Topic": {"Value": "/map"}},
        {"Class": "rviz_default_plugins/Path", "Topic": {"Value": "/plan"}},
        {
            "Class": "rviz_default_plugins/InteractiveMarkers",
            "Interactive Markers Namespace": "menu",
        },
    ]
    tools = [
        {"Class": "rviz_default_plugins/SetGoal", "Topic": {"Value": "/goal_pose"}},
        {"Class": "rviz_default_plugins/PublishPoint", "Topic": {"Value": "point"}},
    ]
    file.write_text(json.dumps({"Visualization Manager": {"Displays": displays, "Tools": tools}}))
    rules = {"/map": "map", "/goal_pose": "goal_pose", "point": "/clicked"}
    problems, here = Problems(tmp_path), Location(tmp_path / "x.launch.py", 1)
    window = Window("rviz2", ["-d", str(file)], rules, {}, "/one", here)
    [view] = windows.shown([window], ["simulator"], problems, problems)
    assert isinstance(view, Widget)
    shown: Any = view.options
    # What the nodes of the launch file print shows over the view.
    assert shown["captions"] == ["simulator"]
    topics = [display["topic"] for display in shown["displays"]]
    assert topics == ["/one/scan", "/one/map", "/plan", "/one/menu/update"]
    assert shown["tools"] == {"goal": "/one/goal_pose", "point": "/clicked"}
    assert problems.lines == []
    # Without a namespace, as for a file that site.yaml names.
    assert read_configuration(file).options["displays"][0]["topic"] == "/scan"
