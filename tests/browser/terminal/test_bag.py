"""`ros2 bag` in a terminal, with what a compiled node publishes and a bag of another library."""

from __future__ import annotations

import io
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import Built, Serve
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from paths import SITES
from playwright.sync_api import Page as Tab
from terminal import Terminal
from waiting import until

STAMP = r"\[INFO\] \[\d{10}\.\d{9}\] "
RECORD = rf"""{STAMP}\[rosbag2_storage\]: Opened database 'talk\.mcap' for READ_WRITE\.
{STAMP}\[rosbag2_recorder\]: Listening for topics\.\.\.
{STAMP}\[rosbag2_recorder\]: Recording\.\.\.
{STAMP}\[rosbag2_recorder\]: Subscribed to topic '/chatter'
{STAMP}\[rosbag2_recorder\]: All requested topics are subscribed\. Stopping discovery\.\.\.
\^C
{STAMP}\[rosbag2_recorder\]: Recording stopped
(\d+) messages, \d+ bytes in this browser\. Save them with: save talk\.mcap"""
TIME = r"[A-Z][a-z]{2} [ \d]\d \d{4} \d\d:\d\d:\d\d\.\d{9} \(\d{10}\.\d{9}\)"
INFO = rf"""
Files:             talk\.mcap
Bag size:          \d+\.\d KiB
Storage id:        mcap
ROS Distro:        unknown
Duration:          \d\.\d{{9}}s
Start:             {TIME}
End:               {TIME}
Messages:          (\d+)
Topic information: Topic: /chatter \| Type: std_msgs/msg/String \| Count: (\d+) \| Serialization Format: cdr
Service:           0
Service information:"""  # noqa: E501
# The size of the file is what it is; 1700000000 is the time of its first message.
DRIVEN = r"""
Files:             drive\.mcap
Bag size:          \d+\.\d KiB
Storage id:        mcap
ROS Distro:        unknown
Duration:          5\.950000000s
Start:             Nov 1[45] 2023 \d\d:13:20\.000000000 \(1700000000\.000000000\)
End:               Nov 1[45] 2023 \d\d:13:25\.950000000 \(1700000005\.950000000\)
Messages:          151
Topic information: Topic: /latched \| Type: std_msgs/msg/String \| Count: 1 \| Serialization Format: cdr
                   Topic: /places \| Type: far_msgs/msg/Place \| Count: 30 \| Serialization Format: cdr
                   Topic: /words \| Type: std_msgs/msg/String \| Count: 120 \| Serialization Format: cdr
Service:           0
Service information:"""  # noqa: E501


@pytest.fixture
def terminal(tab: Tab, serve: Serve, built: Built) -> Iterator[Terminal]:
    tab.goto(serve(built(SITES / "terminal")))
    terminal = Terminal(tab, 140)
    terminal.await_names("/talker", "/chatter")
    yield terminal


@pytest.fixture
def driven(tab: Tab, serve: Serve, built: Built) -> Iterator[Terminal]:
    """A page that plays a bag, and whose node publishes /words."""
    tab.goto(f"{serve(built(SITES / 'bags'))}terminal/")
    terminal = Terminal(tab, 140)
    terminal.await_names("/words")
    yield terminal


def record(terminal: Terminal, line: str, count: int = 5) -> str:
    """Run a recorder until `count` more messages have come, and return what it prints."""
    terminal.begin(line)
    terminal.wait_for("Stopping discovery")
    terminal.tab.evaluate(
        """async (count) => {
          const { ros } = await import(document.querySelector("script[type=module]").src);
          await new Promise((resolve) => ros.subscribe("/chatter", "std_msgs/msg/String",
            () => --count || resolve()));
        }""",
        count,
    )
    terminal.interrupt()
    return terminal.output(line)


@pytest.mark.firefox
def test_a_topic_is_recorded_described_and_played(terminal: Terminal) -> None:
    found = re.fullmatch(RECORD, record(terminal, "ros2 bag record -o talk /chatter"))
    assert found, terminal.text()
    assert int(found[1]) >= 5
    assert terminal.status() == 0
    told = re.fullmatch(INFO, terminal.run("ros2 bag info talk"))
    assert told, terminal.text()
    assert told[1] == told[2] == found[1]
    assert terminal.run("ros2 bag info -t talk.mcap; ls") == "/chatter\ntalk.mcap"
    terminal.run("ros2 bag record -o other -a > b 2>&1 &")
    terminal.run("sleep 0.5; kill %1; wait")
    assert terminal.run("ls; rm other.mcap; rm other.mcap") == (
        "b\nother.mcap\ntalk.mcap\nrm: cannot remove 'other.mcap': No such file or directory"
    )
    terminal.run("ros2 bag play talk --remap /chatter:=/again -d 1 > a 2>&1 &")
    terminal.await_names("/again")
    line = "ros2 topic echo /again --once --field data; wait"
    assert re.fullmatch(r"(?s)hello \d+\n---.*", terminal.run(line)), terminal.text()
    found_again = terminal.run("ros2 bag record -o talk /chatter; echo $?")
    assert found_again == "[ERROR] [ros2bag]: Output folder 'talk' already exists.\n1"
    assert terminal.run("rm talk.mcap; ros2 bag info talk; echo $?") == (
        "The bags of this page: none\nros2 bag info: error: argument bag_path: "
        "Bag path 'talk' does not exist!\n2"
    )


def test_a_recording_is_saved_for_other_programs(terminal: Terminal, tmp_path: Path) -> None:
    record(terminal, "ros2 bag record -o talk --topics /chatter")
    with terminal.tab.expect_download() as download:
        terminal.run("save talk.mcap")
    assert download.value.suggested_filename == "talk.mcap"
    download.value.save_as(tmp_path / "talk.mcap")
    content = io.BytesIO((tmp_path / "talk.mcap").read_bytes())
    messages = list(
        make_reader(content, decoder_factories=[DecoderFactory()]).iter_decoded_messages()
    )
    assert len(messages) >= 5
    assert {channel.topic for _, channel, _, _ in messages} == {"/chatter"}
    texts = [one.data for _, _, _, one in messages]
    numbers = [int(text.removeprefix("hello ")) for text in texts]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))


def test_a_recorder_ends_before_it_has_begun(terminal: Terminal) -> None:
    found = terminal.run("ros2 bag record -a -o none > a 2>&1 & kill %1; wait; tail -1 a")
    assert "0 messages, " in found
    assert "Duration:          0.000000000s" in terminal.run("ros2 bag info none")
    assert "Press SPACE" in terminal.run("ros2 bag play none")


def test_topics_are_chosen_by_expressions(terminal: Terminal) -> None:
    for options, expected in [
        ("-a -x 'param|rosout'", "/chatter\n/points"),
        ("-e '^/(chat|po)' --exclude-topics /points", "/chatter"),
        ("-b 3000 -e ros.ut /points --topics chatter", "/chatter\n/points\n/rosout"),
    ]:
        terminal.run("rm some.mcap > a 2>&1; sleep 0")
        terminal.begin(f"ros2 bag record -o some {options}")
        for topic in expected.split():
            terminal.wait_for(f"Subscribed to topic '{topic}'")
        if "-b" in options:
            terminal.wait_for("The recording has reached its limit")
            terminal.wait()
        else:
            terminal.interrupt()
        assert terminal.run("ros2 bag info -t some") == expected
    for options, error in [
        ("", "Need to specify at least one option out of --all, --all-topics, --topics or --regex"),
        ("-e '('", "'(' is not a regular expression"),
        (
            "-a -o a/b",
            "Output folder 'a/b' needs a name of letters, digits, '_', '-' and '.': "
            "there are no folders here",
        ),
    ]:
        found = terminal.run(f"ros2 bag record {options}; echo $?")
        assert found == f"[ERROR] [ros2bag]: {error}\n1"
    found = terminal.run("ros2 bag record -a -s sqlite3 2>&1 | tail -1")
    assert "error: argument -s/--storage: invalid choice: 'sqlite3'" in found
    found = terminal.run("ros2 bag convert -i some -o out.yaml; echo $?")
    assert found.startswith("ros2 bag convert is not available in a page") and found.endswith("1")


def test_a_bag_of_the_site_is_played_by_keys(driven: Terminal) -> None:
    assert re.fullmatch(DRIVEN, driven.run("ros2 bag info bags/drive.mcap")), driven.text()
    driven.run("ros2 topic echo /heard std_msgs/msg/String --field data > heard &")
    # Slowly, so that its end is far.
    line = "ros2 bag play drive -p -m /words:=/heard --topics /words -r 0.2"
    driven.begin(line)
    driven.wait_for("Press CURSOR_DOWN for Decrease Rate 10%")
    driven.tab.keyboard.press("ArrowUp")
    driven.wait_for("Set rate to 0.22")
    driven.tab.keyboard.press("ArrowRight")
    driven.tab.keyboard.press("ArrowRight")
    driven.tab.keyboard.press("Space")
    driven.wait_for("Resuming play.")
    driven.tab.keyboard.press("Space")
    driven.wait_for("Pausing play.")
    driven.interrupt()
    assert driven.status() == 0
    driven.run("kill %1; wait")
    heard = driven.run("grep bag heard").split("\n")
    assert heard[:2] == ["bag 0", "bag 1"]
    assert heard == [f"bag {number}" for number in range(len(heard))]
    assert len(heard) < 120, "it was paused"


def test_a_bag_is_played_to_its_end(driven: Terminal) -> None:
    driven.run("ros2 topic echo /heard std_msgs/msg/String --field data > heard &")
    line = "ros2 bag play drive --start-offset 5 --remap /words:=/heard --exclude-topics /places"
    found = driven.run(f"{line} -r 5 --clock 100")
    assert "Opened database 'bags/drive.mcap' for READ_ONLY." in found
    assert driven.status() == 0
    driven.run("sleep 0.2; kill %1; wait")
    heard = driven.run("grep bag heard").split("\n")
    assert heard == [f"bag {number}" for number in range(100, 120)]
    for options, error in [
        ("-r 0", "argument -r/--rate: 0 is not in the valid range (> 0.0)"),
        ("-r fast", "argument -r/--rate: fast is not the valid type (float)"),
        ("--remap a=b", "'a=b' is not a remapping of the form old:=new"),
        ("--topics", "argument --topics: expected at least one argument"),
    ]:
        assert error in driven.run(f"ros2 bag play drive {options} 2>&1 | tail -1")


def test_playing_ends_where_it_is_told(driven: Terminal) -> None:
    line = "ros2 bag play drive --start-offset 5 --remap /words:=/heard -r 5"
    for options, last in [
        ("--playback-duration 0.5", 110),
        ("--playback-until-sec 1700000005.25", 105),
        ("--playback-duration 0.5 --playback-until-sec 1700000005.25", 110),
        ("--playback-until-sec 1700000001", None),
        ("--start-offset 60", None),
    ]:
        driven.run("ros2 topic echo /heard std_msgs/msg/String --field data > heard &")
        driven.run(f"{line} {options}")
        driven.run("sleep 0.2; kill %1; wait")
        words = [f"bag {one}" for one in range(100, last + 1)] if last else []
        assert driven.run("grep bag heard") == "\n".join(words)


def test_a_loop_begins_where_playing_did(driven: Terminal) -> None:
    driven.run("ros2 topic echo /heard std_msgs/msg/String --field data > heard &")
    # What is played before it listens would be missing.
    until(lambda: "Subscription count: 1" in driven.run("ros2 topic info /heard"))
    # Not faster than recorded: publishers keep ten messages for a page that is busy, as natively.
    line = "ros2 bag play drive -l --start-offset 5 --remap /words:=/heard"
    driven.run(f"{line} > said 2>&1 &")
    until(lambda: int(driven.run("grep -c 'bag 119' heard")) > 1)
    driven.run("kill %1 %2; wait")
    once = [f"bag {number}" for number in range(100, 120)]
    assert driven.run("grep bag heard").split("\n")[:40] == [*once, *once]


def test_names_are_completed(driven: Terminal) -> None:
    driven.tab.keyboard.type("ros2 bag inf")
    driven.tab.keyboard.press("Tab")
    driven.wait_for("$ ros2 bag info")
    driven.tab.keyboard.type("ba")
    driven.tab.keyboard.press("Tab")
    driven.wait_for("$ ros2 bag info bags/drive.mcap")
