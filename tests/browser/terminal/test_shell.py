"""The terminal itself: keys, completion, jobs, pipes and programs, and what hostile nodes print."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from browser import Built, Serve
from paths import SITES
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from terminal import ROWS, Terminal

# The longest time between two frames, in ms, over some frames.
LONGEST_FRAME = """() => new Promise((resolve) => {
  let [count, longest, last] = [0, 0, performance.now()];
  const frame = () => {
    const now = performance.now();
    longest = Math.max(longest, now - last);
    last = now;
    if (++count < 60) requestAnimationFrame(frame);
    else resolve(longest);
  };
  requestAnimationFrame(frame);
})"""


@pytest.fixture
def terminal(tab: Tab, serve: Serve, built: Built) -> Iterator[Terminal]:
    tab.goto(serve(built(SITES / "terminal")))
    terminal = Terminal(tab)
    tab.get_by_role("region", name="talker", exact=True).get_by_text("running").wait_for()
    yield terminal


def test_lists_pipes_files_and_statuses(terminal: Terminal) -> None:
    for line, expected in [
        ("echo a  'b  c' \"$?\"", "a b  c 0"),
        ("false || echo no; true && echo yes", "no\nyes"),
        ("false; echo $?", "1"),
        ("nothing; echo $?", "sh: nothing: command not found\n127"),
        ("echo one > f; echo two >> f; cat f; wc f; ls", "one\ntwo\n      2       2       8\nf"),
        ("cat f | grep -v one", "two"),
        ("grep -c o < f", "2"),
        ("grep nothing f; echo $?", "1"),
        ("grep '(' f; echo $?", "grep: invalid pattern: (\n2"),
        ("rm f; cat f; echo $?", "cat: f: No such file or directory\n1"),
        ("echo 'a;b' | tail -1", "a;b"),
        ("echo $(date)", "sh: command substitution is not supported here"),
        ("| x", "sh: syntax error near unexpected token `|'"),
        ("head -2 nothing", "head: nothing: No such file or directory"),
        ("sleep x", "sleep: invalid time interval 'x'"),
        ("kill %4; echo $?", "kill: %4: no such job\n1"),
    ]:
        assert terminal.run(line) == expected, line
    assert "cat, ls, rm, save, > and <" in terminal.run("help")
    assert terminal.run("history | grep -c echo") != "0"


def test_a_line_is_edited_and_recalled(terminal: Terminal) -> None:
    keyboard = terminal.tab.keyboard
    terminal.begin("echo first")
    terminal.wait()
    keyboard.type("echo secnd")
    keyboard.press("ArrowLeft")
    keyboard.press("ArrowLeft")
    keyboard.type("o")
    keyboard.press("End")
    keyboard.press("Enter")
    terminal.wait_for("\nsecond\n")
    for key in ["ArrowUp", "ArrowUp", "Control+a", "Delete", "Delete", "Control+k"]:
        keyboard.press(key)
    keyboard.press("Control+y")
    keyboard.press("Enter")
    terminal.wait_for("sh: ho: command not found")
    terminal.run("echo found me")
    keyboard.press("Control+r")
    keyboard.type("fou")
    terminal.wait_for("(search)`fou': echo found me")
    keyboard.press("Enter")
    terminal.wait_for("found me\n$ echo found me\nfound me")
    # An open quote goes on in the next line; Ctrl-C leaves it.
    keyboard.type("echo 'a\nb'\n")
    terminal.wait_for("a\nb\n$")
    keyboard.type("echo 'a\n")
    terminal.wait_for("\n>")
    keyboard.press("Control+c")
    terminal.wait_for("> ^C\n$")
    # A line longer than the screen.
    long = "x" * 250
    terminal.begin(f"echo {long}")
    terminal.wait()
    assert terminal.text().replace("\n", "").count("x") == 500


def test_the_history_is_kept_for_the_next_visit(terminal: Terminal) -> None:
    terminal.run("echo remembered")
    terminal.run("echo other")
    address = terminal.tab.url
    with terminal.tab.context.new_page() as tab:
        tab.goto(address)
        again = Terminal(tab)
        tab.keyboard.press("ArrowUp")
        again.wait_for("$ echo other")
        tab.keyboard.press("ArrowUp")
        again.wait_for("$ echo remembered")
        # Ctrl-R again finds an earlier line.
        tab.keyboard.press("Control+c")
        tab.keyboard.press("Control+r")
        tab.keyboard.type("echo")
        again.wait_for("(search)`echo': echo other")
        tab.keyboard.press("Control+r")
        again.wait_for("(search)`echo': echo remembered")


def test_a_command_is_stopped_and_goes_on(terminal: Terminal) -> None:
    keyboard = terminal.tab.keyboard
    terminal.begin("ros2 topic echo /chatter")
    terminal.wait_for("data: hello")
    keyboard.press("Control+z")
    terminal.wait_for("^Z\n[1]  Stopped                 ros2 topic echo /chatter\n$")
    assert terminal.status() == 148
    # Nothing more is printed until it goes on.
    assert terminal.run("ros2 topic echo /points --once --field point.x") == "1.5\n---"
    assert terminal.run("jobs").split() == [
        "[1]",
        "Stopped",
        *["ros2", "topic", "echo", "/chatter"],
    ]
    terminal.begin("fg")
    terminal.wait_for("fg\nros2 topic echo /chatter\ndata: hello")
    keyboard.press("Control+z")
    terminal.wait_for("Stopped")
    terminal.run("kill %1; wait")
    assert terminal.run("jobs") == ""
    terminal.begin("ros2 topic echo /chatter | grep hello > heard")
    keyboard.press("Control+z")
    terminal.wait_for("Stopped")
    assert terminal.run("bg").endswith("ros2 topic echo /chatter | grep hello > heard &")
    before = int(terminal.run("grep -c hello heard"))
    terminal.run("ros2 topic echo /chatter --once --field data")
    assert int(terminal.run("sleep 0.3; grep -c hello heard")) > before
    terminal.run("kill %1; wait")


def test_less_shows_a_page_at_a_time(terminal: Terminal) -> None:
    keyboard = terminal.tab.keyboard
    terminal.run("ros2 interface list > all")
    terminal.begin("cat all | less")
    terminal.wait_for("\n:")
    before = terminal.text()
    assert before.count("/msg/") > 10
    keyboard.press("Enter")
    # The next line takes the place of the sign, which goes below it.
    later = f"(before) => ({ROWS})() !== before && ({ROWS})().endsWith('\\n:')"
    terminal.tab.wait_for_function(later, arg=before)
    keyboard.press("q")
    terminal.wait()
    assert terminal.status() == 0


def test_tab_completes(terminal: Terminal) -> None:
    keyboard = terminal.tab.keyboard
    for typed, expected in [
        ("ro", "$ ros2"),
        ("ros2 ser", "$ ros2 service"),
        ("ros2 topic ec", "$ ros2 topic echo"),
        ("ros2 topic echo /ch", "$ ros2 topic echo /chatter"),
        ("ros2 topic echo /points --field poi", "$ ros2 topic echo /points --field point"),
        ("ros2 topic echo /points --on", "$ ros2 topic echo /points --once"),
        ("ros2 topic pub /said ", "$ ros2 topic pub /said std_msgs/msg/String"),
        (
            "ros2 topic pub /p geometry_msgs/msg/Point ",
            '$ ros2 topic pub /p geometry_msgs/msg/Point "{x: 0.0, y: 0.0, z: 0.0}"',
        ),
        ("ros2 service call /mu", "$ ros2 service call /mute"),
        (
            "ros2 service call /mute std_srvs/srv/SetBool ",
            '$ ros2 service call /mute std_srvs/srv/SetBool "{data: false}"',
        ),
        ("ros2 param get /talker vol", "$ ros2 param get /talker volume"),
        ("ros2 run sp", "$ ros2 run speaking"),
        ("ros2 run speaking ta", "$ ros2 run speaking talker"),
        ("ros2 topic list | gr", "$ ros2 topic list | grep"),
        ("echo x; ros2 no", "$ echo x; ros2 node"),
    ]:
        keyboard.type(typed)
        keyboard.press("Tab")
        terminal.wait_for(expected)
        keyboard.press("Control+c")
        keyboard.press("Control+l")
    # Several are listed, and the line stays.
    keyboard.type("ros2 topic ")
    keyboard.press("Tab")
    terminal.wait_for("bw     delay  echo   find   hz     info   list   pub    type\n$ ros2 topic")
    keyboard.press("Control+c")
    # Esc, then Tab leaves the terminal.
    keyboard.press("Escape")
    keyboard.press("Tab")
    assert terminal.tab.evaluate("!document.activeElement.closest('.ros-screen')")


def test_jobs_run_in_the_background(terminal: Terminal) -> None:
    terminal.run("ros2 topic echo /chatter > heard &")
    assert " ".join(terminal.run("jobs").split()) == "[1] Running ros2 topic echo /chatter > heard"
    terminal.begin("fg")
    terminal.wait_for("fg\nros2 topic echo /chatter > heard")
    terminal.interrupt()
    assert terminal.status() == 2
    assert terminal.run("jobs") == ""
    assert int(terminal.run("grep -c hello heard")) > 0
    terminal.run("sleep 100 &")
    terminal.run("kill %1; wait")
    assert terminal.run("jobs") == ""
    # Typed ahead, a line waits.
    terminal.begin("sleep 0.5")
    terminal.tab.keyboard.type("echo ahead\n")
    terminal.wait_for("$ echo ahead\nahead\n$")
    # Ctrl-C ends the whole line.
    terminal.begin("sleep 100; echo next")
    terminal.interrupt()
    assert "\nnext" not in terminal.text()
    assert terminal.status() == 130


def test_a_program_runs_as_a_new_process(terminal: Terminal) -> None:
    terminal.begin("ros2 run speaking talker --ros-args -r __node:=other -p greeting:=moin")
    terminal.wait_for("[other]: moin")
    terminal.tab.locator(".ros-nodes").scroll_into_view_if_needed()
    programs = terminal.tab.locator(".ros-nodes .ros-head .ros-name")
    expect(programs).to_have_text(["flood", "talker", "typist", "talker-2"])
    terminal.focus()
    terminal.interrupt()
    expect(programs).to_have_text(["flood", "talker", "typist"])
    assert terminal.run("ros2 node list") == "/talker"
    # Its parameters may be in a file of the tab.
    terminal.run("echo 'other: {ros__parameters: {greeting: ahoy, volume: 9}}' > p.yaml")
    terminal.run(
        "ros2 run speaking talker --ros-args -r __node:=other --params-file p.yaml > l 2>&1 &"
    )
    terminal.begin("ros2 topic echo /chatter --timeout 20 | grep -m 1 ahoy")
    terminal.wait_for("data: ahoy ")
    terminal.wait()
    assert terminal.run("ros2 param get /other volume") == "Integer value is: 9"
    assert terminal.run("ros2 node list") == "/other\n/talker"
    terminal.run("kill %1; wait")
    assert terminal.run("ros2 node list") == "/talker"


def test_a_program_reads_the_keyboard_and_ends_with_its_code(terminal: Terminal) -> None:
    terminal.begin("ros2 run speaking typist a 'b c'")
    terminal.wait_for("argument a\nargument b c\ncode?")
    terminal.tab.keyboard.type("33")
    terminal.tab.keyboard.press("Backspace")
    terminal.tab.keyboard.press("Enter")
    terminal.wait_for("3\nending with 3\n[ros2run]: Process exited with failure 3\n$")
    assert terminal.status() == 3
    terminal.begin("ros2 run speaking typist")
    terminal.wait_for("code?")
    terminal.tab.keyboard.press("Control+d")
    terminal.wait()
    assert terminal.status() == 7


def test_a_flood_neither_freezes_the_page_nor_drives_the_terminal(terminal: Terminal) -> None:
    terminal.run("ros2 run speaking flood &")
    terminal.await_names("/flood")
    terminal.begin("ros2 topic echo /flood")
    # The control sequences in the texts are shown, by YAML.
    terminal.wait_for('data: "\\e[2J\\e]0;owned\\a ')
    longest = terminal.tab.evaluate(LONGEST_FRAME)
    assert longest < 1000
    terminal.interrupt()
    assert "owned" not in terminal.tab.title()
    # A raw field is made harmless, too.
    found = terminal.run("ros2 topic echo /flood --once --field data")
    assert found.startswith("^[[2J^[]0;owned^G ")
    # The reader of a pipe ends its writer.
    assert len(terminal.run("ros2 topic echo /flood | grep data | head -3").split("\n")) == 3
    terminal.begin("ros2 topic echo /flood | grep never")
    terminal.tab.evaluate(LONGEST_FRAME)
    terminal.interrupt()
    terminal.run("kill %1; wait")


def test_terminals_are_opened_and_closed(terminal: Terminal) -> None:
    panel = terminal.tab.locator(".ros-terminal")
    terminal.run("echo shared > file")
    panel.get_by_role("button", name="New terminal").click()
    expect(panel.get_by_role("tab")).to_have_count(2)
    terminal.tab.keyboard.type("cat file\n")
    terminal.wait_for("shared\n$")
    panel.get_by_role("tab", name="Terminal 1").click()
    terminal.wait_for("$ echo shared > file")
    panel.get_by_role("button", name="Close terminal").click()
    expect(panel.get_by_role("tab", include_hidden=True)).to_have_count(1)
    terminal.wait_for("cat file")
    panel.get_by_label("Screen reader").check()
    expect(panel.locator(".xterm-accessibility")).to_have_count(1)


def test_commands_of_the_text_run_in_the_terminal(tab: Tab, serve: Serve, built: Built) -> None:
    tab.goto(serve(built(SITES / "terminal")) + "tutorial/")
    expect(tab.locator(".ros-terminal")).to_be_hidden()
    runs = tab.locator("button.run")
    expect(runs).to_have_count(4)
    runs.nth(3).click()
    # The tab with the terminal is selected; its first command has run, and no node has started.
    expect(tab.locator(".ros-terminal")).to_be_in_viewport()
    terminal = Terminal(tab)
    terminal.wait_for("$ ros2 pkg list\nspeaking\n$ ros2 node list\n$")
    tab.get_by_role("button", name="Run ros2 run speaking talker").click()
    terminal.wait_for("[other]: moin")
    tab.get_by_role("button", name="Run ros2 service call").click()
    terminal.wait_for("std_srvs.srv.SetBool_Response(success=True, message='muted')")
    code = tab.locator("code.language-ros2").first
    assert "ros2 topic echo /chatter --once" in code.inner_text().split("\n")
