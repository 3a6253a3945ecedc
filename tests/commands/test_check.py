"""What `sitegen check` says, and above all what it does not say."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent

import pytest
from paths import ROOT
from PIL import Image

from sitegen.__main__ import main
from sitegen.commands.check import check
from sitegen.errors import SiteError
from sitegen.nodes.cpp import libraries
from sitegen.nodes.cpp.toolchain import Toolchain
from sitegen.report import Report

SITES = [f"demos/demo{number:02}" for number in (3, 4, 5, 6, 9, 10, 11, 13, 14)]

CPP = """\
#include <memory>
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "example_interfaces/srv/add_two_ints.hpp"
using Adder = example_interfaces::srv::AddTwoInts;
// create_publisher<std_msgs::msg::String>("in_a_comment", 10);
int main(int argc, char ** argv)
{
  auto node = rclcpp::Node::make_shared("talker");
  auto greeting = "create_publisher<std_msgs::msg::String>(no_name, 10)";
  auto a = node->create_publisher<std_msgs::msg::String>("chatter", 10);
  auto b = node->create_client<Adder>("add");
}
"""
PYTHON = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

TOPIC = "chatter"


class Listener(Node):
    def __init__(self):
        super().__init__("listener")
        self.create_subscription(String, TOPIC, print, 10)


class Unused(Node):
    def __init__(self):
        super().__init__("unused")
        self.create_subscription(String, "nowhere", print, 10)


def main():
    rclpy.init()
    rclpy.spin(Listener())
"""
SERVER = """\
import rclpy
from example_interfaces.srv import AddTwoInts


def main():
    rclpy.init()
    node = rclpy.create_node("adder")
    node.create_service(srv_type=AddTwoInts, srv_name="/add", callback=print)
"""
SETUP = """\
from setuptools import setup

setup(
    name="py",
    packages=["py"],
    entry_points={"console_scripts": ["listener = py.listener:main", "server = py.server:main"]},
)
"""
SITE = """\
site: {title: Check}
nodes:
  talker: {package: cpp, executable: talker}
  listener: {package: py, executable: listener}
  server: {package: py, executable: server}
pages:
  - path: /
    title: Home
    content:
      - console: talker
      - console: listener
      - console: server
"""


def write(folder: Path, **changed: str) -> Path:
    """Write the site above, with other texts for some of: site, cpp, listener, server."""
    xml = "<package><name>{}</name><export><build_type>{}</build_type></export></package>"
    files = {
        "site.yaml": changed.get("site", SITE),
        "src/cpp/package.xml": xml.format("cpp", "ament_cmake"),
        "src/cpp/CMakeLists.txt": "add_executable(talker talker.cpp)",
        "src/cpp/talker.cpp": changed.get("cpp", CPP),
        "src/py/package.xml": xml.format("py", "ament_python"),
        "src/py/setup.py": SETUP,
        "src/py/py/__init__.py": "",
        "src/py/py/listener.py": changed.get("listener", PYTHON),
        "src/py/py/server.py": changed.get("server", SERVER),
    }
    for name, text in files.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return folder


def warnings(folder: Path) -> list[str]:
    return check(folder, Report())[1]


def test_a_site_whose_nodes_hear_each_other_is_right(tmp_path: Path) -> None:
    assert warnings(write(tmp_path)) == []


@pytest.mark.parametrize("name", SITES)
def test_sites_of_ours_are_right(name: str) -> None:
    assert warnings(ROOT / name) == []


COMMANDS = """\
# Try it

```ros2
ros2 run cpp talker &
ros2 run cpp talkr
ros2 topic echo /chatter --once | head -1
ros2 topic echo /chater
ros2 topic pub /mine std_msgs/msg/String "{data: x}" &
ros2 topic hz /mine
ros2 topic info /rosout; ros2 topic list -t
ros2 interface show std_msgs/msg/Strin
ros2 service call /add \\
  example_interfaces/srv/AddTwoInts "{a: 1}"
ros2 service type /talker/list_parameters
ros2 node info /talker
ros2 param get /talkr use_sim_time
ros2 topic echo 'unfinished
```

- ```console
  $ ros2 service call /ad example_interfaces/srv/AddTwoInts
  ros2 topic echo /printed
  $ ls /nothing
  ```

```bash
ros2 topic echo /elsewhere
```
"""


def test_commands_that_name_what_is_not_there_are_told(tmp_path: Path) -> None:
    site = SITE.replace(
        "      - console: talker", "      - markdown: text.md\n      - console: talker"
    )
    (tmp_path / "text.md").write_text(COMMANDS)
    expected = [
        "text.md:5: ros2: page / has no program 'cpp talkr'; did you mean 'cpp talker'?",
        "text.md:7: ros2: page / has no topic '/chater'; did you mean '/chatter'?",
        "text.md:11: ros2: no type 'std_msgs/msg/Strin'; did you mean 'std_msgs/msg/String'?",
        "text.md:16: ros2: page / has no node '/talkr'; did you mean '/talker'?",
        "text.md:21: ros2: page / has no service '/ad'; did you mean '/add'?",
    ]
    # A terminal opens for them on a page that has none.
    assert warnings(write(tmp_path, site=site)) == expected
    assert warnings(write(tmp_path, site=f"{site}      - terminal:\n")) == expected


def test_who_calls_nobody_is_told() -> None:
    assert warnings(ROOT / "tests/sites/services") == [
        "src/calc/src/callers.cpp:71: service: 'callers' calls '/nobody' on page /, which "
        "has no server; add a node that provides it, or remap the name"
    ]


def test_what_nobody_is_at_the_other_side_of(tmp_path: Path) -> None:
    listener = PYTHON.replace('"chatter"', '"chater"')
    server = SERVER.replace("/add", "/sum")
    found = warnings(write(tmp_path, listener=listener, server=server))
    assert found == [
        "src/cpp/talker.cpp:11: topic: 'talker' publishes '/chatter' on page /, which has no"
        " subscription; did you mean '/chater'?",
        "src/cpp/talker.cpp:12: service: 'talker' calls '/add' on page /, which has no server;"
        " add a node that provides it, or remap the name",
        "src/py/py/listener.py:11: topic: 'listener' subscribes to '/chater' on page /, which"
        " has no publisher; did you mean '/chatter'?",
    ]


def test_types_that_do_not_match(tmp_path: Path) -> None:
    listener = PYTHON.replace("import String", "import Int32 as String")
    server = SERVER.replace("AddTwoInts", "SetBool").replace("example_interfaces", "std_srvs")
    found = warnings(write(tmp_path, listener=listener, server=server))
    assert found == [
        "src/cpp/talker.cpp:12: service: '/add' is example_interfaces/srv/AddTwoInts for 'talker',"
        " but std_srvs/srv/SetBool for 'server' (src/py/py/server.py:8); "
        "use the same type for both",
        "src/py/py/listener.py:11: topic: '/chatter' is std_msgs/msg/Int32 for 'listener', but"
        " std_msgs/msg/String for 'talker' (src/cpp/talker.cpp:11); use the same type for both",
    ]


ACTIONS = """\
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer


def main():
    rclpy.init()
    node = rclpy.create_node("counter")
    ActionServer(node, Fibonacci, "count", print)
    ActionClient(node, Fibonacci, action_name="{name}")
"""
ASK = 'rclcpp_action::create_client<Count>(node->get_node_base_interface(), "count");'
COUNT = "using Count = example_interfaces::action::Fibonacci;"


def test_actions_have_two_sides_of_one_type(tmp_path: Path) -> None:
    cpp = CPP.replace('node->create_client<Adder>("add");', ASK).replace("using", f"{COUNT}\nusing")
    assert warnings(write(tmp_path, cpp=cpp, server=ACTIONS.format(name="count"))) == []
    found = warnings(write(tmp_path, cpp=cpp, server=ACTIONS.format(name="cuont")))
    assert found == [
        "src/py/py/server.py:10: action: 'server' sends goals to '/cuont' on page /, which has no"
        " server; did you mean '/count'?"
    ]
    other = cpp.replace("action::Fibonacci", "action::Other")
    assert warnings(write(tmp_path, cpp=other, server=ACTIONS.format(name="count"))) == [
        "src/cpp/talker.cpp:13: action: '/count' is example_interfaces/action/Other for 'talker',"
        " but example_interfaces/action/Fibonacci for 'server' (src/py/py/server.py:9); "
        "use the same type for both"
    ]


@pytest.mark.parametrize(
    ("of", "named"),
    [
        ("{package: cpp, executable: talker, namespace: /left}", "'/left/chatter'"),
        ("{package: cpp, executable: talker, remap: {chatter: news}}", "'/news'"),
    ],
)
def test_names_are_those_of_the_graph(of: str, named: str, tmp_path: Path) -> None:
    site = SITE.replace("{package: cpp, executable: talker}", of)
    found = warnings(write(tmp_path, site=site))
    assert any(f"publishes {named}" in line for line in found)
    assert any("subscribes to '/chatter'" in line for line in found)


# Each of these takes what the listener waits for out of sight, or gives it by other means.
UNCLEAR_CPP = {
    "a name of a variable": ('create_publisher<std_msgs::msg::String>("chatter"', "create_x(name"),
    "an expression": ('("chatter", 10)', "(prefix + name, 10)"),
    "another library": ("<memory>", "<tf2_ros/transform_broadcaster.h>"),
    "a header that is not there": ("<memory>", '"mine.hpp"'),
    "a namespace that is made": ('make_shared("talker")', 'make_shared("talker", find())'),
    "a condition": ("  auto a", "#ifdef TALKS\n  auto a"),
    "a remap of its own": ('"talker"', '"talker", rclcpp::NodeOptions().arguments({})'),
}


@pytest.mark.parametrize("way", UNCLEAR_CPP)
def test_nothing_is_said_of_cpp_where_nothing_is_known(way: str, tmp_path: Path) -> None:
    old, new = UNCLEAR_CPP[way]
    changed = CPP.replace(old, new).replace("create_x(", "create_publisher<T>(")
    changed = changed.replace('  auto b = node->create_client<Adder>("add");\n', "")
    assert changed != CPP
    if way == "a condition":
        changed = changed.replace("10);\n}", "10);\n#endif\n}")
    assert warnings(write(tmp_path, cpp=changed)) == []


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('"chatter"\n', "input()\n"),
        (
            "import rclpy\n",
            "import rclpy\ntry:\n    import tf2_ros\nexcept ImportError:\n    tf2_ros = None\n",
        ),
        ('super().__init__("listener")', 'super().__init__("listener", namespace=where())'),
        ("self.create_subscription(String, TOPIC", "make = self.create_subscription; make(TOPIC"),
        ("rclpy.init()", 'rclpy.init(args=["--ros-args", "-r", "a:=chatter"])'),
        ("rclpy.init()", "exec(code)"),
    ],
)
def test_nothing_is_said_of_python_where_nothing_is_known(
    old: str, new: str, tmp_path: Path
) -> None:
    cpp = CPP.replace('"chatter"', '"other"')
    assert old in PYTHON
    found = warnings(write(tmp_path, cpp=cpp, listener=PYTHON.replace(old, new)))
    assert [line for line in found if "topic" in line] == []


def test_a_program_of_a_package_with_cmake(tmp_path: Path) -> None:
    """Its `main` is what stands below `if __name__ == "__main__"`."""
    listener = (
        PYTHON.replace('"chatter"', '"chater"') + '\n\nif __name__ == "__main__":\n    main()\n'
    )
    folder = write(
        tmp_path, site=SITE.replace("{package: py, executable: l", "{package: cpp, executable: l")
    )
    (folder / "src/cpp/listener").write_text(f"#!/usr/bin/env python3\n{listener}")
    (folder / "src/cpp/CMakeLists.txt").write_text(
        "find_package(ament_cmake_python)\nadd_executable(talker talker.cpp)\n"
        "install(PROGRAMS listener DESTINATION lib/${PROJECT_NAME})\n"
    )
    found = warnings(folder)
    assert [line.partition(" on page")[0] for line in found] == [
        "src/cpp/listener:12: topic: 'listener' subscribes to '/chater'",
        "src/cpp/talker.cpp:11: topic: 'talker' publishes '/chatter'",
    ]


def test_types_are_not_compared_where_names_may_change(tmp_path: Path) -> None:
    cpp = CPP.replace('"talker"', '"talker", rclcpp::NodeOptions().use_global_arguments(false)')
    listener = PYTHON.replace("import String", "import Int32 as String")
    assert warnings(write(tmp_path, cpp=cpp, listener=listener)) == []
    renamed = listener.replace("rclpy.init()", 'rclpy.init(sys.argv + ["--ros-args"])')
    assert warnings(write(tmp_path, listener=renamed)) == []


@pytest.mark.parametrize(
    ("widget", "alone"),
    [
        ("publish:", "listener"),
        ("publish: {topic: /news, type: std_msgs/msg/String}", "listener"),
        ("topics:", "talker"),
        ("topics: {show: [/chatter]}", "talker"),
    ],
)
def test_a_widget_is_a_side(widget: str, alone: str, tmp_path: Path) -> None:
    """The listener waits for /news, or nobody for /chatter: the widget makes it right."""
    listener = PYTHON.replace('"chatter"', '"news"')
    cpp = CPP if alone == "talker" else CPP.replace("publisher<", "subscription<")
    folder = write(tmp_path, cpp=cpp, listener=listener)
    expected = "'/news'" if alone == "listener" else "'/chatter'"
    assert any(expected in line for line in warnings(folder))
    site = SITE.replace("console: server", f"console: server\n      - {widget}")
    folder = write(tmp_path, site=site, cpp=cpp, listener=listener)
    assert not any(expected in line for line in warnings(folder))


def test_a_widget_may_be_wrong_too(tmp_path: Path) -> None:
    more = """
          - topics: {show: [/chater], echo: /chater}
          - publish: {topic: /chatter, type: std_msgs/msg/Int32}
          - publish: {topic: /chat, type: std_msgs/msg/Int32}
          - robot: {kind: diffdrive, odometry: /chatter}
    """
    site = SITE.rstrip("\n") + dedent(more).replace("\n", "\n      ").rstrip() + "\n"
    found = warnings(write(tmp_path, site=site))
    assert [line.partition(": ")[0] for line in found] == [
        "site.yaml:13",
        "site.yaml:15",
        "site.yaml:16",
        "site.yaml:16",
        "src/py/py/listener.py:11",
    ]
    assert "this widget subscribes to '/chater'" in found[0]
    assert "this widget publishes '/chat'" in found[1]
    assert "but std_msgs/msg/Int32 for this widget (site.yaml:14)" in found[4]


def test_an_alias_of_another_header_is_no_type(tmp_path: Path) -> None:
    cpp = CPP.replace("std_msgs::msg::String", "texts::msg::String")
    cpp = cpp.replace("<memory>", '"texts.hpp"')
    folder = write(tmp_path, cpp=cpp)
    (folder / "src/cpp/texts.hpp").write_text("namespace texts = std_msgs;\n")
    assert warnings(folder) == []


@pytest.mark.parametrize(
    "beyond",
    ["script: own.js", "connect: {addresses: [self]}"],
)
def test_what_is_beyond_the_page_may_be_the_other_side(beyond: str, tmp_path: Path) -> None:
    listener = PYTHON.replace('"chatter"', '"chater"')
    site = SITE.replace("    title: Home", f"    title: Home\n    {beyond}")
    folder = write(tmp_path, site=site, listener=listener)
    (folder / "own.js").write_text('import { ros } from "sitegen";\n')
    assert warnings(folder) == []


def test_a_cell_of_javascript_may_be_the_other_side(tmp_path: Path) -> None:
    listener = PYTHON.replace('"chatter"', '"chater"')
    cell = '      - markdown: "```js ros\\n1;\\n```"\n'
    assert warnings(write(tmp_path, listener=listener)) != []
    assert warnings(write(tmp_path, site=SITE + cell, listener=listener)) == []


@pytest.mark.parametrize("widget", ["3d:", "joints:", "teleop:", "parameters:", "tf:"])
def test_a_panel_silences_nothing(widget: str, tmp_path: Path) -> None:
    listener = PYTHON.replace('"chatter"', '"chater"')
    site = SITE.replace("console: server", f"console: server\n      - {widget}")
    found = warnings(write(tmp_path, site=site, listener=listener))
    told = [line for line in found if "'listener' subscribes to '/chater'" in line]
    # The view shows whatever there is, so it may be the other side of the talker.
    assert len(told) == 1
    own = [line for line in found if "this widget" in line]
    assert [line.partition("this widget ")[2].partition(" on page")[0] for line in own] == {
        "joints:": ["publishes '/joint_states'", "subscribes to '/robot_description'"],
        "teleop:": ["publishes '/cmd_vel'"],
    }.get(widget, [])


@pytest.mark.parametrize(
    ("widget", "count"),
    [
        ("plot: {series: [/chatter/data]}", 0),
        ("value: {path: /chatter/data/size}", 0),
        ("plot: {series: [/chater/data]}", 1),
        ("3d: {displays: [{markers: /chater}]}", 0),
    ],
)
def test_paths_are_read_as_rqt_writes_them(widget: str, count: int, tmp_path: Path) -> None:
    site = SITE.replace("console: server", f"console: server\n      - {widget}")
    found = warnings(write(tmp_path, site=site))
    assert ["this widget subscribes to '/chater/data'" in line for line in found] == [True] * count


def test_packages_that_are_absent(tmp_path: Path) -> None:
    names = ("nav2_util", "cv_bridge", "acme_base", "std_msgs", "tf2_ros", "py")
    depends = "".join(f"<depend>{name}</depend>" for name in names)
    write(tmp_path, cpp=f"#include <cv_bridge/cv_bridge.hpp>\n{CPP}")
    (tmp_path / "src/cpp/package.xml").write_text(f"<package><name>cpp</name>{depends}</package>")
    required = "".join(f"find_package({name} REQUIRED)\n" for name in (*names, "Threads"))
    # What is not always required may be found, or not needed.
    optional = "find_package(absent QUIET)\nif(WIN32)\nfind_package(other REQUIRED)\nendif()\n"
    (tmp_path / "src/cpp/CMakeLists.txt").write_text(
        f"{required}{optional}add_executable(talker talker.cpp)"
    )
    assert warnings(tmp_path) == [
        "src/cpp/CMakeLists.txt: 'cpp' needs 'nav2_util', which is not in the workspace; "
        "clone its sources there: "
        "git clone -b kilted https://github.com/ros-planning/navigation2.git",
        "src/cpp/CMakeLists.txt: 'cpp' needs 'acme_base', which is not in the workspace; "
        "clone its sources there",
        # CMake finds this one for the programs that do not include it.
        "src/cpp: 'talker' needs 'cv_bridge', which has no build for the page",
    ]


def test_libraries_that_are_not_installed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(tmp_path, cpp=f"#include <fmt/core.h>\n{CPP}")
    monkeypatch.setattr(libraries, "ROOTS", [tmp_path])
    assert warnings(tmp_path) == [
        "src/cpp: 'talker' needs 'fmt', which is not installed (apt-get install libfmt-dev)"
    ]
    (tmp_path / "fmt").mkdir()
    (tmp_path / "fmt/core.h").touch()
    assert warnings(tmp_path) == []


def test_eigen_that_is_not_installed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(tmp_path, cpp=f"#include <Eigen/Dense>\n{CPP}")
    assert warnings(tmp_path) == []
    monkeypatch.setattr(libraries, "find_eigen", lambda: None)
    assert warnings(tmp_path) == [
        "src/cpp: 'talker' needs 'Eigen', which is not installed "
        "(pip install 'ros-sitegen[eigen]', or apt-get install libeigen3-dev)"
    ]


def test_images_without_a_text(tmp_path: Path) -> None:
    folder = write(tmp_path, site="site: {title: A}\npages: [{path: /, file: index.md}]\n")
    (folder / "index.md").write_text(
        '# A\n\n![](a.png)\n\n![A fox](a.png) `![](b.png)`\n\n<img src="c.png">\n\n'
        '<img src="c.png" alt="">\n\n```md\n![](d.png)\n```\n'
    )
    for name in ("a.png", "c.png"):
        Image.new("RGB", (2, 2)).save(folder / name)
    found = warnings(folder)
    assert [line.partition("; ")[0] for line in found] == [
        "index.md:3: image: 'a.png' has no alternative text",
        "index.md:7: image: 'c.png' has no alternative text",
    ]


def test_what_build_refuses_is_refused_and_nothing_is_compiled(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def find() -> None:
        raise AssertionError("asked for a compiler")

    monkeypatch.setattr(Toolchain, "find", find)
    folder = write(tmp_path, site=SITE.replace("console: server", "markdown: '[a](b.md#c)'"))
    assert main(["check", str(folder)]) == 1
    error = capsys.readouterr().err
    assert error.startswith("site.yaml:12: link: no file 'b.md'")
    assert error.endswith("\n1 problem\n")

    folder = write(tmp_path, listener=PYTHON.replace('"chatter"', '"chater"'))
    assert main(["check", str(folder)]) == 0
    said = capsys.readouterr()
    assert said.out == "checked 1 page: 2 warnings\n"
    assert len(said.err.splitlines()) == 2
    assert not (folder / "dist").exists()

    assert main(["check", "--strict", str(folder)]) == 1
    assert capsys.readouterr().err == f"{said.err}2 problems\n"
    with pytest.raises(SiteError):
        check(folder, Report(), strict=True)
