"""Containers in a terminal: components are loaded, listed and unloaded."""

from __future__ import annotations

from browser import Built, Serve
from paths import SITES
from playwright.sync_api import Page as Tab
from terminal import Terminal


def test_components_are_loaded_into_a_container(tab: Tab, serve: Serve, built: Built) -> None:
    tab.goto(serve(built(SITES / "rclcpp")) + "container/terminal/")
    terminal = Terminal(tab, 130)
    assert terminal.run("ros2 pkg executables") == "rclcpp_components component_container_mt"
    terminal.run(
        "ros2 run rclcpp_components component_container_mt --ros-args -r __node:=box > log 2>&1 &"
    )
    terminal.await_names("/box/_container/list_nodes", "/box/_container/unload_node")
    server = "components components::FibonacciServer"
    for line, expected in [
        ("ros2 component list", "/box"),
        (
            f"ros2 component load /box {server} -n third --node-namespace /a",
            "Loaded component 1 into '/box' container node as '/a/third'",
        ),
        (
            f"ros2 component load /box {server} -r __node:=other -q",
            "2  /other",
        ),
        ("ros2 component list", "/box\n  1  /a/third\n  2  /other"),
        ("ros2 component list /box", "1  /a/third\n2  /other"),
        ("ros2 component list box", "Unable to find container node 'box'"),
        ("ros2 component list --containers-only", "/box"),
        ("ros2 component unload /box 1", "Unloaded component 1 from '/box' container node"),
        ("ros2 node list", "/box\n/other"),
        (
            "ros2 component load /box components components::Nothing; echo $?",
            "Failed to load component: Failed to find class with the requested plugin name.\n1",
        ),
        (
            "ros2 component unload /box 77; echo $?",
            "Failed to unload component 77 from '/box' container node\n"
            "    No node found with unique_id: 77\n1",
        ),
        ("ros2 component list /nobody", "Unable to find container node '/nobody'"),
    ]:
        assert terminal.run(line) == expected, line
    terminal.run("kill %1; wait")
    assert terminal.run("ros2 node list") == ""


def test_the_launch_file_of_the_page_is_launched(tab: Tab, serve: Serve, built: Built) -> None:
    tab.goto(serve(built(SITES / "rclcpp")) + "container/terminal/")
    terminal = Terminal(tab, 130)
    assert terminal.run("ros2 launch other x.py; echo $?") == (
        "Package 'other' not found: the page has components container.launch.xml\n1"
    )
    line = "ros2 launch components container.launch.xml"
    assert terminal.run(f"{line} --show-args") == (
        "Arguments (pass arguments as '<name>:=<value>'):\n\n  No arguments."
    )
    assert terminal.run(f"{line} x; echo $?") == (
        "malformed launch argument 'x', expected format '<name>:=<value>'\n1"
    )
    found = terminal.run(line)
    assert found.startswith("[INFO] [component_container_mt-1]: process started\n")
    assert "[component_container_mt-1] [INFO] " in found
    assert "none left: 0" in found
    assert found.endswith("[INFO] [component_container_mt-1]: process has finished cleanly")
