"""The pages that `sitegen init` writes: what stands on them, by what the sources tell."""

from __future__ import annotations

import shutil
from collections.abc import Mapping
from pathlib import Path

import pytest
from paths import ROOT

from sitegen import config
from sitegen.__main__ import main
from sitegen.model import Layout, Page, Source, Widget

CPP = "src/{0}/src/{1}.cpp"
MANIFEST = (
    "<package><name>{0}</name><description>{1}</description>"
    "<export><build_type>{2}</build_type></export></package>"
)


def cpp(name: str, sources: Mapping[str, str], description: str = "") -> dict[str, str]:
    """The files of a package in C++ with these programs; `sources` are their bodies."""
    programs = "".join(f"add_executable({each} src/{each}.cpp)\n" for each in sources)
    return {
        f"src/{name}/package.xml": MANIFEST.format(name, description, "ament_cmake"),
        f"src/{name}/CMakeLists.txt": f"project({name})\nfind_package(rclcpp REQUIRED)\n{programs}",
        **{
            CPP.format(name, each): "int main(int argc, char ** argv) {\n"
            f'auto node = std::make_shared<rclcpp::Node>("{each}");\n{body}\n}}\n'
            for each, body in sources.items()
        },
    }


def python(name: str, sources: Mapping[str, str], description: str = "") -> dict[str, str]:
    """The files of a package in Python with these programs; `sources` are their modules."""
    scripts = [f"{each} = {name}.{each}:main" for each in sources]
    return {
        f"src/{name}/package.xml": MANIFEST.format(name, description, "ament_python"),
        f"src/{name}/setup.py": "from setuptools import setup\n"
        f"setup(packages=['{name}'], entry_points={{'console_scripts': {scripts}}})\n",
        f"src/{name}/{name}/__init__.py": "",
        **{f"src/{name}/{name}/{each}.py": text for each, text in sources.items()},
    }


def publisher(type: str, topic: str) -> str:
    return f'node->create_publisher<{type.replace("/", "::")}>("{topic}", 10);'


def subscription(type: str, topic: str) -> str:
    return f'node->create_subscription<{type.replace("/", "::")}>("{topic}", 10, hear);'


def written(root: Path, *packages: Mapping[str, str]) -> dict[str, Page]:
    """The pages of the site that init writes for packages, by path."""
    for files in packages:
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
    assert main(["init", str(root)]) == 0
    site = config.load(root / "site.yaml")
    assert site.notes == ()
    return {page.path: page for page in site.pages}


def panels(page: Page) -> dict[str, Mapping[str, object]]:
    """The widgets of a page that are not those of a node, with the options that are given."""
    shown = [each for each in page.leaves if isinstance(each, Widget) and not each.target]
    return {
        each.kind: {name: value for name, value in each.options.items() if value} for each in shown
    }


@pytest.mark.parametrize(
    ("body", "kind", "options"),
    [
        (
            'node->create_service<example_interfaces::srv::AddTwoInts>("add", add);',
            "services",
            {"show": ["/add"]},
        ),
        (
            'rclcpp_action::create_server<example_interfaces::action::Fibonacci>(node, "fib", a);',
            "actions",
            {"show": ["/fib"]},
        ),
        ('node->declare_parameter("speed", 1.0);', "parameters", {}),
        (
            publisher("std_msgs/msg/Float64", "level"),
            "plot",
            {"series": ["/level.data"], "window": 30, "time": "received"},
        ),
        (
            publisher("sensor_msgs/msg/JointState", "joint_states"),
            "plot",
            {"series": ["/joint_states.position[:]{name}"], "window": 30, "time": "received"},
        ),
        (publisher("sensor_msgs/msg/LaserScan", "scan"), "3d", {}),
        ("tf2_ros::TransformBroadcaster frames(node);", "3d", {}),
        (publisher("sensor_msgs/msg/Image", "image"), "image", {"topic": "/image"}),
        (publisher("diagnostic_msgs/msg/DiagnosticArray", "/diagnostics"), "diagnostics", {}),
        ("class Managed : public rclcpp_lifecycle::LifecycleNode {};", "lifecycle", {}),
        (
            subscription("geometry_msgs/msg/TwistStamped", "cmd_vel"),
            "teleop",
            {"topic": "/cmd_vel", "stamped": True, "linear": "0.5", "angular": "1.0"},
        ),
        (
            subscription("sensor_msgs/msg/CompressedImage", "view"),
            "camera",
            {"topic": "/view", "compressed": True, "width": 320, "rate": 10, "frame": "camera"},
        ),
        (
            subscription("std_msgs/msg/String", "words"),
            "publish",
            {"topic": "/words", "type": "std_msgs/msg/String"},
        ),
        (publisher("std_msgs/msg/String", "chatter"), "topics", {"echo": "/chatter"}),
    ],
)
def test_what_a_node_offers_has_a_panel(
    tmp_path: Path, body: str, kind: str, options: Mapping[str, object]
) -> None:
    page = written(tmp_path, cpp("robot", {"node": body}))[""]
    found = panels(page)
    assert {name: str(value) for name, value in found[kind].items()} == {
        name: str(value) for name, value in options.items()
    }


def test_a_robot_that_is_only_commanded_is_drawn(tmp_path: Path) -> None:
    page = written(
        tmp_path, cpp("robot", {"circle": publisher("geometry_msgs/msg/Twist", "cmd_vel")})
    )[""]
    robot = panels(page)["robot"]
    assert (robot["kind"], robot["twist"]) == ("diffdrive", "/cmd_vel")


def test_a_node_stands_beside_its_source(tmp_path: Path) -> None:
    page = written(tmp_path, cpp("robot", {"talker": publisher("std_msgs/msg/String", "chatter")}))
    parts = [
        (each.target, each.kind if isinstance(each, Widget) else "source")
        for each in page[""].leaves
        if isinstance(each, Widget | Source)
    ]
    assert parts[:3] == [
        ("talker", "source"),
        ("talker", "buttons"),
        ("talker", "console"),
    ]


def test_numbers_of_own_messages_are_plotted_and_constants_are_not(tmp_path: Path) -> None:
    files = {
        **cpp("robot", {"node": publisher("robot/msg/Tank", "tank")}),
        "src/robot/msg/Tank.msg": "uint8 FULL=1\nstring name\nfloat64 level 0.5 # of it\n"
        "float32[] history\nfloat32 flow\nint32 count\n",
    }
    assert panels(written(tmp_path, files)[""])["plot"]["series"] == ["/tank.level", "/tank.flow"]


def test_many_panels_are_in_tabs(tmp_path: Path) -> None:
    body = publisher("std_msgs/msg/Float64", "level") + 'node->declare_parameter("a", 1);'
    body += 'node->create_service<std_srvs::srv::Empty>("reset", reset);'
    page = written(tmp_path, cpp("robot", {"node": body}))[""]
    [tabs] = [each for each in page.content if isinstance(each, Layout)]
    assert [cell.title for cell in tabs.cells] == ["Plot", "Services", "Parameters", "Topics"]


def test_partners_of_several_packages_share_a_page(tmp_path: Path) -> None:
    talker = cpp("words", {"talker": publisher("std_msgs/msg/String", "chatter")}, "Words.")
    listener = python(
        "ears",
        {
            "listener": "import rclpy\nfrom std_msgs.msg import String\n\n\ndef main():\n"
            "    rclpy.init()\n    node = rclpy.create_node('listener')\n"
            "    node.create_subscription(String, 'chatter', print, 10)\n"
        },
        "Ears.",
    )
    page = written(tmp_path, listener, talker)[""]
    assert list(page.nodes) == ["talker", "listener"]
    assert page.title == "Ears"


def test_a_client_has_its_nearest_server_and_numbers(tmp_path: Path) -> None:
    ask = 'node->create_client<example_interfaces::srv::AddTwoInts>("add");'
    ask += "request->a = std::atoll(argv[1]); request->b = std::stoi(argv[2]);"
    server = 'node->create_service<example_interfaces::srv::AddTwoInts>("add", add);'
    far = {f"a/{name}": text for name, text in cpp("far", {"far": server}).items()}
    near = {f"b/{name}": text for name, text in cpp("near", {"near": server}).items()}
    client = {f"b/{name}": text for name, text in cpp("asks", {"client": ask}).items()}
    pages = written(tmp_path, far, near, client)
    assert set(pages) == {"", "far/", "asks/"}
    nodes = pages["asks/"].nodes
    assert list(nodes) == ["near", "client"]
    assert nodes["client"].arguments == ("1", "2")
    assert nodes["client"].needs == ("near",)


def test_what_gives_commands_has_a_robot_and_visitors_drive_it_too(tmp_path: Path) -> None:
    robot = cpp("robot", {"drive": subscription("geometry_msgs/msg/Twist", "cmd_vel")})
    pages = written(
        tmp_path, robot, cpp("steps", {"dance": publisher("geometry_msgs/msg/Twist", "cmd_vel")})
    )
    assert list(pages["steps/"].nodes) == ["drive", "dance"]
    assert panels(pages["robot/"])["teleop"]["topic"] == "/cmd_vel"


def test_a_source_that_is_made_by_the_build_is_not_shown(tmp_path: Path) -> None:
    files = cpp("robot", {"drive": "", "made": ""})
    del files[CPP.format("robot", "made")]
    page = written(tmp_path, files)[""]
    assert list(page.nodes) == ["drive", "made"]
    assert [each.target for each in page.leaves if isinstance(each, Source)] == ["drive"]


def test_other_arguments_are_for_the_author(tmp_path: Path) -> None:
    text = (
        "import sys\nimport argparse\n\n\ndef main():\n    print(sys.argv[2], int(sys.argv[1]))\n"
    )
    written(tmp_path, python("say", {"words": text}), cpp("rest", {"rest": "puts(argv[1]);"}))
    text = (tmp_path / "site.yaml").read_text(encoding="utf-8")
    advice = "      # It takes command-line arguments; add them like this: arguments: "
    assert f'{advice}["…", "…"]\n      words: {{package: say, executable: words}}\n' in text
    assert f'{advice}["…"]\n      rest: {{package: rest, executable: rest}}\n' in text


def test_what_was_written_for_a_turtle_has_one(tmp_path: Path) -> None:
    shutil.copytree(ROOT / "demos/demo09/src/py_artist", tmp_path / "src/py_artist")
    page = written(tmp_path)[""]
    assert list(page.nodes) == ["turtlesim", "star"]
    assert page.nodes["star"].needs == ("turtlesim",)
    assert panels(page)["robot"]["kind"] == "turtlesim"
    assert "teleop" not in panels(page)
    assert panels(page)["topics"] == {"echo": "/turtle1/pose"}


def test_a_workspace_with_the_turtlesim_of_ros_runs_that_of_sitegen(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    shutil.copytree(ROOT / "demos/demo09/src", tmp_path / "src")
    launch = '<launch><node pkg="turtlesim" exec="turtlesim_node"/></launch>'
    upstream = {
        **cpp("turtlesim", {"turtlesim_node": "", "turtle_teleop_key": ""}),
        "src/turtlesim/launch/one.launch.xml": launch,
    }
    listing = upstream["src/turtlesim/CMakeLists.txt"]
    upstream["src/turtlesim/CMakeLists.txt"] = f"{listing}find_package(Qt5 REQUIRED)\n"
    for name, text in upstream.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    assert main(["init", str(tmp_path)]) == 0
    said = "turtlesim: needs Qt, so pages run the turtlesim that comes with sitegen"
    assert said in capsys.readouterr().out
    site = config.load(tmp_path / "site.yaml")
    assert site.notes == (
        "src/turtlesim/package.xml:1: package: 'turtlesim' needs Qt, so pages run the turtlesim "
        "that comes with sitegen",
    )
    pages = {page.path: list(page.nodes) for page in site.pages}
    assert pages["py_artist/"] == ["turtlesim_node", "star"]
    assert pages["turtlesim/one/"] == ["turtlesim_node"]
    assert site.packages["turtlesim"].path != tmp_path / "src/turtlesim"


def test_packages_of_ros_1_are_left_out(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    old = cpp("old", {"talker": ""})
    manifest = "<package><name>old</name><buildtool_depend>catkin</buildtool_depend></package>"
    pages = written(tmp_path, {**old, "src/old/package.xml": manifest}, cpp("new", {"a": ""}))
    assert list(pages[""].nodes) == ["a"]
    said = "skipped: src/old/package.xml:1: node: package 'old' is for ROS 1 (catkin)"
    assert said in capsys.readouterr().out


def test_large_packages_have_a_page_for_those_that_communicate(tmp_path: Path) -> None:
    alone = {f"alone{number}": "" for number in range(5)}
    talker = publisher("std_msgs/msg/String", "chatter")
    listener = subscription("std_msgs/msg/String", "chatter")
    pages = written(tmp_path, cpp("many", {"talker": talker, **alone, "listener": listener}))
    assert list(pages["many/talker/"].nodes) == ["talker", "listener"]
    assert pages["many/talker/"].title == "talker and listener"
    assert list(pages["many/alone3/"].nodes) == ["alone3"]
    assert len(pages) == 7


@pytest.mark.parametrize(
    ("description", "title", "text"),
    [
        ("Drives a rover.", "Drives a rover", ""),
        ("A rover. It drives on two wheels.", "A rover", "It drives on two wheels."),
        ("Drives with <b>ROS 2.0</b> &amp; care", "Drives with ROS 2.0 & care", ""),
        ("TODO: Package description", "rover", ""),
        ("The rover package", "rover", ""),
        ("", "rover", ""),
        (f"It {'really ' * 9}drives. *Fast*", "rover", f"It {'really ' * 9}drives. *Fast*"),
    ],
)
def test_the_description_of_a_package_introduces_its_page(
    tmp_path: Path, description: str, title: str, text: str
) -> None:
    page = written(tmp_path, cpp("rover", {"drive": ""}, description))[""]
    assert page.title == title
    prose = [str(getattr(each, "text", "")) for each in page.content[:1]]
    assert prose == ([text.replace("*", "\\*")] if text else [""])


def test_equal_titles_are_told_apart(tmp_path: Path) -> None:
    pages = written(tmp_path, cpp("one", {"a": ""}, "A node"), cpp("two", {"b": ""}, "A node"))
    assert [page.title for page in pages.values()][1:] == ["A node (one)", "A node (two)"]


def test_a_launch_file_without_windows_has_panels(tmp_path: Path) -> None:
    body = 'node->create_service<std_srvs::srv::Empty>("reset", reset);'
    launch = '<launch><node pkg="robot" exec="node" namespace="fox"/></launch>'
    same = "launch:\n  - node: {pkg: robot, exec: node, namespace: fox}\n"
    pages = written(
        tmp_path,
        cpp("robot", {"node": body, "other": ""}),
        {"src/robot/launch/all.launch.xml": launch, "src/robot/launch/all.launch.yaml": same},
    )
    assert set(pages) == {"", "robot/", "robot/all/"}
    page = pages["robot/all/"]
    assert panels(page)["services"] == {"show": ["/fox/reset"]}
    shown = [each for each in page.leaves if isinstance(each, Widget)]
    assert [each.options["autostart"] for each in shown if each.kind == "buttons"] == [True]
    assert "# src/robot/launch/all.launch.yaml starts the same nodes." in (
        tmp_path / "site.yaml"
    ).read_text(encoding="utf-8")


def test_a_described_robot_is_shown_and_moved(tmp_path: Path) -> None:
    launch = """<launch><node pkg="robot_state_publisher" exec="robot_state_publisher">
<param name="robot_description" value="$(command 'cat $(find-pkg-share fox)/fox.urdf')" type="str"/>
</node></launch>"""
    files = {
        "src/fox/package.xml": MANIFEST.format("fox", "A fox with four legs.", "ament_cmake"),
        "src/fox/CMakeLists.txt": "project(fox)\n"
        "install(FILES fox.urdf DESTINATION share/${PROJECT_NAME})\n",
        "src/fox/fox.urdf": '<robot name="fox"><link name="base"/></robot>',
        "src/fox/launch/fox.launch.xml": launch,
    }
    page = written(tmp_path, files)[""]
    assert page.title == "A fox with four legs"
    assert {"3d", "joints", "parameters"} <= panels(page).keys()


def test_a_launch_file_with_windows_replaces_the_page_of_its_nodes(tmp_path: Path) -> None:
    shutil.copytree(ROOT / "demos/demo11/src", tmp_path / "src")
    pages = written(tmp_path)
    assert set(pages) == {""}
    assert "3d" in panels(pages[""])
    assert pages[""].title == "A rover with a laser scanner, simulated in a room"


def test_a_component_has_its_source(tmp_path: Path) -> None:
    files = {
        **cpp("parts", {}),
        "src/parts/CMakeLists.txt": "project(parts)\nset(NAME talker)\n"
        "add_library(all SHARED src/a.cpp src/b.cpp)\n"
        'rclcpp_components_register_node(all PLUGIN "::parts::Talker" EXECUTABLE ${NAME})\n'
        'rclcpp_components_register_node(all PLUGIN "parts::Gone" EXECUTABLE gone)\n',
        "src/parts/src/a.cpp": "RCLCPP_COMPONENTS_REGISTER_NODE(parts::Listener)\n",
        "src/parts/src/b.cpp": 'Talker() : Node("talker") {'
        'create_publisher<std_msgs::msg::String>("chatter", 1);}\n'
        "RCLCPP_COMPONENTS_REGISTER_NODE( parts::Talker )\n",
    }
    page = written(tmp_path, files)[""]
    assert list(page.nodes) == ["talker", "gone"]
    assert [each.target for each in page.leaves if isinstance(each, Source)] == ["talker"]
    assert panels(page)["topics"] == {"echo": "/chatter"}


def test_a_launch_file_that_needs_an_argument_gets_its_first_choice(tmp_path: Path) -> None:
    launch = """<launch>
<arg name="type"><choice value="ur3"/><choice value="ur5e"/></arg>
<arg name="side" if="$(eval '\\'$(var type)\\' == \\'ur3\\'')"><choice value="left"/></arg>
<node pkg="robot" exec="node" namespace="$(var type)"/>
</launch>"""
    pages = written(
        tmp_path,
        cpp("robot", {"node": "", "other": ""}),
        {"src/robot/launch/all.launch.xml": launch},
    )
    [node] = pages["robot/all/"].nodes.values()
    assert node.namespace == "/ur3"
    text = (tmp_path / "site.yaml").read_text(encoding="utf-8")
    assert "    launch_arguments:\n      type: ur3  # or: ur5e\n      side: left\n" in text
