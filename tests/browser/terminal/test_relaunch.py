"""`ros2 launch` with arguments: the page reads its launch file again."""

from __future__ import annotations

from browser import Built, Serve
from paths import SITES
from playwright.sync_api import Page as Tab
from terminal import Terminal

LAUNCH = "ros2 launch speaking speak.launch.xml"
ERROR = "[ERROR] [launch]: Caught exception in launch (see debug for traceback): "


def test_arguments_change_what_is_launched(tab: Tab, serve: Serve, built: Built) -> None:
    # So that no line is cut.
    tab.set_viewport_size({"width": 2000, "height": 900})
    tab.goto(serve(built(SITES / "terminal")) + "launch/")
    terminal = Terminal(tab, 170)
    terminal.await_names("/first/list_parameters")
    assert terminal.run("ros2 node list") == "/first"
    assert terminal.run("ros2 param get /first greeting") == "String value is: psst"
    terminal.run(f"{LAUNCH} who:=loud space:=/a twice:=true > log 2>&1 &")
    terminal.await_names("/a/first/list_parameters", "/second/list_parameters")
    for line, expected in [
        ("ros2 node list", "/a/first\n/first\n/second"),
        ("ros2 param get /a/first greeting", "String value is: HELLO"),
        ("ros2 param get /second greeting", "String value is: told"),
        ("ros2 param get /first greeting", "String value is: psst"),
    ]:
        assert terminal.run(line) == expected, line
    terminal.run("kill %1; wait")
    assert terminal.run("ros2 node list") == "/first"
    log = terminal.run("cat log")
    assert log.startswith("[INFO] [launch]: Loading Python to read the launch file\n")
    assert "[INFO] [talker-2]: process started" in log
    assert "HELLO" in log
    # What the page starts by itself is as the author wrote it.
    wrong = terminal.run(f"{LAUNCH} twice:=maybe; echo $?")
    assert wrong == (
        f"{ERROR}speaking/launch/speak.launch.xml:8: group: 'maybe' is not a boolean; "
        "write 'true' or 'false'\n1"
    )
    missing = terminal.run(f"{LAUNCH} who:=nobody; echo $?")
    assert missing.startswith(f"{ERROR}speaking/launch/speak.launch.xml:5: node: no file ")
    assert missing.endswith("1")
    assert terminal.run(f"{LAUNCH} who:; echo $?") == (
        "malformed launch argument 'who:', expected format '<name>:=<value>'\n1"
    )


def test_functions_of_python_files_are_called_again(tab: Tab, serve: Serve, built: Built) -> None:
    # So that no line is cut.
    tab.set_viewport_size({"width": 2000, "height": 900})
    tab.goto(serve(built(SITES / "terminal")) + "count/")
    terminal = Terminal(tab, 170)
    launch = "ros2 launch speaking count.launch.py"
    terminal.run(f"{launch} count:=3 > log 2>&1 &")
    terminal.await_names("/talker_3/list_parameters")
    assert terminal.run("ros2 param get /talker_3 greeting") == "String value is: 3 of 3"
    terminal.run("kill %1; wait")
    assert terminal.run(f"{launch} other:=nobody; echo $?") == (
        f"{ERROR}executable 'nobody' of package 'speaking' is not on this page\n1"
    )
    assert "ValueError: invalid literal" in terminal.run(f"{launch} count:=many")
    # Ctrl-C while it is read.
    terminal.begin(f"{launch} count:=2")
    tab.keyboard.press("Control+c")
    terminal.wait()
    tab.keyboard.type(f"{launch} cou")
    tab.keyboard.press("Tab")
    terminal.wait_for("count:=")
