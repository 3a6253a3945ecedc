"""Transforms, filters and robot descriptions, in the forms that programs use them."""

from __future__ import annotations

from pathlib import Path

import pytest
from browser import Built, Serve
from launching import nodes
from panel import Panel
from paths import SITES
from playwright.sync_api import Page

from sitegen import rclyaml, workspace
from sitegen.errors import Problems
from sitegen.launch import launched

SITE = SITES / "tf"
FOUND = """
world <- base at 2.000000: 1.000 0.000, yaw 0.785
world <- base at 3.000000: 2.000 0.000, yaw 1.571
world <- laser at 3.000000: 2.000 0.500, yaw -1.571
laser <- world at 3.000000: 0.500 -2.000, yaw 1.571
other <- laser at 2.000000: 2.354 0.354, yaw -2.356
base <- base at 9.000000: 0.000 0.000, yaw 0.000
ExtrapolationException: Lookup would require extrapolation into the future.  Requested time \
4.000000 but the latest data is at time 3.000000, when looking up transform from frame [base] to \
frame [world]
ExtrapolationException: Lookup would require extrapolation into the past.  Requested time 0.500000 \
but the earliest data is at time 1.000000, when looking up transform from frame [base] to frame \
[world]
ExtrapolationException: Lookup would require extrapolation at time 2.500000, but only time \
2.000000 is in the buffer, when looking up transform from frame [laser] to frame [other]
LookupException: "nowhere" passed to lookupTransform argument source_frame does not exist.
ConnectivityException: Could not find a connection between 'world' and 'away' because they are not \
part of the same tree.Tf has two or more unconnected trees.
""".strip().split("\n")
NOWHERE = next(line for line in FOUND if "nowhere" in line)
OF_CPP = """
moved 0.000 2.000
can 1
can 0: Invalid frame ID "nowhere" passed to canTransform argument source_frame - frame does not \
exist
Frame laser exists with parent base.
  broadcaster: 'test'
  rate: 1.000
  most_recent_transform: 3.000000
  buffer_length: 2.000
pose world 2.000 1.000 yaw 1.571
converted 2.000 1.000
of Eigen 2.000 1.000 in world, back 1.000 0.000
cloud in world: -1.000 1.000 3.000 of 64 bytes
world <- late is there
""".strip("\n").split("\n")
# The form is that of the tutorials of tf2.
ECHOED = """
At time 0.0
- Translation: [1.000, 0.000, 0.000]
- Rotation: in Quaternion (xyzw) [0.000, 0.000, 0.707, 0.707]
- Rotation: in RPY (radian) [0.000,  0.000, 1.571]
- Rotation: in RPY (degree) [0.000,  0.000, 90.000]
- Matrix:
  0.000 -1.000  0.000  1.000
  1.000  0.000  0.000  0.000
  0.000  0.000  1.000  0.000
  0.000  0.000  0.000  1.000
""".strip().split("\n")
MATCHED = """
exact 1000 1000
by reference 1000 1000
exact 1400 1400
by reference 1400 1400
dropped 1100 none
dropped none 1120
dropped 1200 none
dropped 1300 none
dropped none 1320
approximate 1000 1000
approximate 1100 1120
approximate 1300 1320
approximate 1400 1400
strict 1000 1000
strict 1400 1400
epsilon 1000 1000
epsilon 1100 1120
epsilon 1300 1320
epsilon 1400 1400
epsilon 1500 1520
pairs 15
cache from 2 to 4
between: 2
before 3: 2000
after 4: none
second filter: one
third filter: none
chain 7000
/temperature 1
/temperature 2
""".strip().split("\n")
ALIGNED = """
delta 20
delta 21
delta 20
aligned a 1
aligned a 2
a is silent
aligned b 3
aligned b 4
aligned b 9
passed 2, dropped 1, waiting 0
latest 2 1
latest 3 1
latest 4 2
""".strip().split("\n")
MATCHED_BY_PYTHON = """
exact 1000 1000
close 1000 1000
close 1100 1120
exact 1200 1200
close 1200 1200
close 1300 1320
exact 1400 1400
close 1400 1400
cache 1.2 1400
""".strip().split("\n")


def lines(node: Panel) -> list[str]:
    """Return what a program printed, once it has ended, without the marks of the console."""
    node.expect_state("stopped")
    return [line.rstrip().replace("-0.000", "0.000") for line in node.lines()]


def test_a_buffer_finds_what_upstream_finds_and_says_what_it_says(
    tab: Page, serve: Serve, built: Built
) -> None:
    tab.goto(f"{serve(built(SITE))}buffer/")
    node = Panel(tab, "buffer")
    node.start()
    printed = lines(node)
    for line in (*FOUND, *OF_CPP):
        assert line in printed, line
    assert any("TF_SELF_TRANSFORM" in line for line in printed)
    assert any("TF_OLD_DATA" in line for line in printed)


def test_messages_match_by_their_times(tab: Page, serve: Serve, built: Built) -> None:
    tab.goto(f"{serve(built(SITE))}matching/")
    node = Panel(tab, "matching")
    node.start()
    assert lines(node)[-len(MATCHED) :] == MATCHED


def test_filters_align_and_pass_on_what_changes(tab: Page, serve: Serve, built: Built) -> None:
    tab.goto(f"{serve(built(SITE))}matching/")
    node = Panel(tab, "aligning")
    node.start()
    said = [line for line in lines(node) if "arrived too late" not in line]
    assert said == ALIGNED


def test_a_client_asks_the_buffer_of_a_server(tab: Page, serve: Serve, built: Built) -> None:
    tab.goto(f"{serve(built(SITE))}waiting/")
    node = Panel(tab, "serving")
    node.start()
    assert lines(node) == [
        "server 1",
        'can 0: "map" passed to lookupTransform argument target_frame does not exist.',
        "map <- base: 2.0",
        NOWHERE,
    ]


def test_the_programs_of_tf2_ros_tell_and_print_what_there_is(
    tab: Page, serve: Serve, built: Built
) -> None:
    tab.goto(f"{serve(built(SITE))}asking/")
    asking, echo = Panel(tab, "asking"), Panel(tab, "told")
    asking.start()
    echo.start()
    Panel(tab, "answering").start()
    echo.wait_for('Invalid frame ID "world" passed to canTransform argument target_frame')
    Panel(tab, "fixed").start()
    assert lines(asking) == ["server 1", "world <- map: 1.0", NOWHERE]
    echo.wait_for("At time 0.0")
    echo.stop()
    printed = echo.lines()
    shown = printed[printed.index("At time 0.0") :]
    assert [line.rstrip().replace("-0.000", " 0.000") for line in shown[:10]] == ECHOED


@pytest.mark.firefox
def test_a_callback_waits_for_transforms_that_a_thread_takes_in(
    tab: Page, serve: Serve, built: Built
) -> None:
    tab.goto(f"{serve(built(SITE))}waiting/")
    node = Panel(tab, "waiting")
    node.start()
    Panel(tab, "fixed").start()
    node.expect_state("stopped")
    said = "\n".join(node.messages())
    assert 'Invalid frame ID "nowhere" passed to canTransform argument target_frame' in said
    assert "world <- map: 1.000" in said
    assert "Timed out waiting for transform from nowhere to world" in said
    assert "point in world: 1.000 3.000" in said


def test_programs_in_python_find_and_match_the_same(tab: Page, serve: Serve, built: Built) -> None:
    tab.goto(f"{serve(built(SITE))}python/")
    node, waiting = Panel(tab, "py_buffer"), Panel(tab, "py_waiting")
    node.start()
    waiting.start()
    Panel(tab, "fixed").start()
    printed = lines(node)
    for line in FOUND:
        assert line in printed, line
    assert "pose world 2.000 1.000" in printed
    assert printed[-len(MATCHED_BY_PYTHON) :] == MATCHED_BY_PYTHON
    said = [line.partition("[waiting_py]: ")[2] for line in lines(waiting)]
    assert said[-2:] == ["point in world: 1.000 3.000", "nowhere: False"]


def test_a_robot_moves_as_its_description_says(tab: Page, serve: Serve, built: Built) -> None:
    tab.goto(f"{serve(built(SITE))}arm/")
    echo = Panel(tab, "echo")
    # The shoulder is in the middle of its limits, 1 rad; the finger turns back by 1 - 0.25.
    expected = "- Rotation: in RPY (radian) [0.000, 0.000, 1.821]"
    tab.wait_for_function(
        "text => document.body.innerText.includes(text)", arg="- Translation: [0.000, 1.000, 2.300]"
    )
    assert expected in [line.replace("-0.000", "0.000") for line in echo.lines()]
    assert "Robot initialized" in Panel(tab, "robot_state_publisher").messages()


@pytest.mark.parametrize("name", ["display.launch.py", "display.launch.xml", "processed.launch.py"])
def test_launch_files_give_the_description_as_a_text(name: str) -> None:
    found, wrong = nodes(SITE, f"src/arm/launch/{name}")
    assert wrong == []
    description = rclyaml.value(found[0].parameters["robot_description"])
    assert isinstance(description, str)
    assert description.startswith("<?xml")
    # Of four meters, it stands on a half; an apostrophe of a comment is what it was.
    assert 'xyz="0 0 2.0"' in description
    assert str(SITE) not in description
    assert "it's turned" in description


def test_launch_files_may_include_those_of_urdf_launch() -> None:
    problems = Problems(SITE)
    packages = {**workspace.shipped_packages(), **workspace.scan(SITE)}
    file = SITE / "src/arm/launch/shown.launch.py"
    found = launched(file, {"gui": "false"}, packages, problems)
    assert problems.lines == []
    assert [node.executable for node in found.nodes] == [
        "robot_state_publisher",
        "joint_state_publisher",
    ]
    assert "<robot name=" in found.nodes[0].parameters["robot_description"]
    found = launched(file, {}, packages, problems)
    assert [node.executable for node in found.nodes] == ["robot_state_publisher"]
    assert [window.kind for window in found.windows] == ["joints", "3d"]


def test_what_draws_on_a_screen_is_a_window() -> None:
    problems, notes = Problems(SITE), Problems(SITE)
    file = SITE / "src/arm/launch/display.launch.py"
    found = launched(file, {}, workspace.scan(SITE), problems, notes)
    assert "rviz2" not in [node.package for node in found.nodes]
    assert [window.executable for window in found.windows] == ["rviz2"]
    assert notes.lines == []


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("<robot><a></robot>", "param: xacro: x.xacro: mismatched tag"),
        ("<robot a='${1 +}'/>", "xacro: x.xacro: "),
        (
            "<robot xmlns:xacro='x'><xacro:no/></robot>",
            "xacro: x.xacro: unknown macro name: xacro:no",
        ),
        ("<robot a='$(find other)'/>", "no package 'other' in the workspace"),
    ],
)
def test_what_is_wrong_with_a_description_is_one_line(
    tmp_path: Path, text: str, expected: str
) -> None:
    (tmp_path / "x.xacro").write_text(text)
    (tmp_path / "x.launch.xml").write_text(
        "<launch>\n<node pkg='a' exec='b'>"
        "<param name='c' value=\"$(command 'xacro $(dirname)/x.xacro')\"/></node></launch>"
    )
    found, [line] = nodes(tmp_path, "x.launch.xml")
    assert found == []
    assert line.startswith("x.launch.xml:2: ")
    assert expected.removeprefix("param: ") in line


def test_packages_of_ros_are_given_to_who_needs_them(tmp_path: Path) -> None:
    package = tmp_path / "mine"
    package.mkdir()
    (package / "package.xml").write_text(
        "<package format='3'><name>mine</name><depend>rclcpp</depend></package>"
    )
    (package / "CMakeLists.txt").write_text("project(mine)\nfind_package(tf2_geometry_msgs)\n")
    packages = workspace.with_shipped(workspace.scan(tmp_path))
    order = [one.name for one in workspace.with_dependencies(packages, "mine")]
    assert {"tf2", "tf2_ros", "tf2_geometry_msgs", "message_filters"} < set(order)
    assert order[-1] == "mine"
    assert "robot_state_publisher" not in packages
    assert "robot_state_publisher" in workspace.with_shipped({}, ["robot_state_publisher"])


def test_a_workspace_may_have_them_itself(tmp_path: Path) -> None:
    package = tmp_path / "tf2_ros"
    package.mkdir()
    (package / "package.xml").write_text("<package format='3'><name>tf2_ros</name></package>")
    packages = workspace.with_shipped(workspace.scan(tmp_path), ["tf2_ros"])
    assert packages["tf2_ros"].path == package
