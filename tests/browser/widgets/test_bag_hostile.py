"""Bags that are damaged, odd or hostile end in one line, and the page goes on."""

from __future__ import annotations

import random
import re
import struct
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import pytest
from bags import DRIVE, RULE, START, player
from browser import opened
from mcap.reader import make_reader
from mcap.writer import CompressionType, IndexType, Writer
from panel import Panel
from playwright.sync_api import Browser, expect
from playwright.sync_api import Page as Tab
from waiting import until

pytestmark = pytest.mark.firefox

TEXT = b"\x00\x01\x00\x00\x06\x00\x00\x00hello\x00"
STRING = ("std_msgs/msg/String", "string data")


@pytest.fixture
def page(browser: Browser, bag_pages: str) -> Iterator[Tab]:
    with opened(browser) as tab:
        tab.goto(bag_pages)
        Panel(tab, "hears").expect_started()
        expect(player(tab).locator(".ros-bag-row")).to_have_count(3)
        yield tab
        # The page draws and the node runs.
        tab.evaluate("() => new Promise((done) => requestAnimationFrame(done))")
        Panel(tab, "hears").expect_state("running")


def drop(tab: Tab, path: Path) -> None:
    player(tab).locator("input[type=file]").set_input_files(path)
    expect(player(tab).locator(".ros-name").first).to_have_text(path.name)


def rows(tab: Tab) -> list[str]:
    lines = player(tab).locator(".ros-bag-row").all_inner_texts()
    return [" | ".join(part for part in line.split("\n") if part) for line in lines]


def made(
    path: Path,
    topics: Sequence[tuple[str, str, str]] = (("/words", *STRING),),
    *,
    encodings: tuple[str, str] = ("cdr", "ros2msg"),
    times: Sequence[int] = (0, 1, 2),
    **options: Any,
) -> Path:
    """Write a bag of topics with their types and schemas, whose messages are all the same."""
    with path.open("wb") as stream:
        writer = Writer(stream, **options)
        writer.start(profile="ros2", library="test")
        for topic, kind, text in topics:
            schema = writer.register_schema(kind, encodings[1], text.encode())
            channel = writer.register_channel(topic, encodings[0], schema)
            for time in times:
                at = START + time * 1_000_000
                writer.add_message(channel, at, TEXT, at)
        writer.finish()  # type: ignore[no-untyped-call]
    return path


def nested(depth: int, item: str) -> str:
    """Definitions of which each has ten of the next."""
    parts = [f"a/T0[10] x\n{RULE}\n"]
    for level in range(depth):
        inside = f"a/T{level + 1}[10] x" if level + 1 < depth else item
        parts.append(f"MSG: a/T{level}\n{inside}\n{RULE if level + 1 < depth else ''}\n")
    return "".join(parts)


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "This is not an MCAP file."),
        (b"hello, I am a text" * 100, "This is not an MCAP file."),
        (DRIVE.read_bytes()[:8], "This bag cannot be read: "),
        (
            DRIVE.read_bytes()[:2000],
            "This bag is cut off or damaged; only its first part is played.",
        ),
    ],
    ids=["empty", "text", "magic", "cut"],
)
def test_what_is_not_a_whole_bag_is_said(
    page: Tab, tmp_path: Path, content: bytes, said: str
) -> None:
    path = tmp_path / "own.mcap"
    path.write_bytes(content)
    drop(page, path)
    expect(player(page).get_by_role("status")).to_contain_text(said)


def test_the_rest_of_a_bag_that_is_cut_off_is_played(page: Tab, tmp_path: Path) -> None:
    path = tmp_path / "own.mcap"
    path.write_bytes(DRIVE.read_bytes()[:2600])
    drop(page, path)
    expect(player(page).locator(".ros-bag-row")).to_have_count(3)
    player(page).get_by_label("Speed").select_option("10")
    player(page).get_by_role("button", name="Play", exact=True).click()
    Panel(page, "hears").wait_for("bag 50")


@pytest.mark.parametrize(
    "options",
    [
        {"use_chunking": False},
        {"index_types": IndexType.NONE},
        {"index_types": IndexType.NONE, "use_chunking": False},
        {"repeat_channels": False, "repeat_schemas": False},
    ],
    ids=["no chunks", "no index", "neither", "no summary"],
)
def test_bags_without_an_index_are_played(
    page: Tab, tmp_path: Path, options: dict[str, Any]
) -> None:
    drop(page, made(tmp_path / "own.mcap", times=range(30), **options))
    expect(player(page).locator(".ros-bag-row")).to_have_count(1)
    player(page).get_by_role("button", name="Play", exact=True).click()
    panel = Panel(page, "hears")
    panel.wait_for("hello")
    expect(player(page).get_by_role("button", name="Play", exact=True)).to_be_visible()

    def heard() -> int:
        return len([one for one in panel.messages() if "'hello'" in one])

    until(lambda: heard() >= 30, told=heard)
    assert heard() == 30


def test_a_schema_in_another_language_is_no_obstacle(page: Tab, tmp_path: Path) -> None:
    drop(page, made(tmp_path / "own.mcap", encodings=("cdr", "ros2idl")))
    expect(player(page).locator(".ros-bag-row")).to_have_count(1)
    player(page).get_by_role("button", name="Play", exact=True).click()
    Panel(page, "hears").wait_for("'hello'")


def test_chunks_that_overlap_are_played_in_the_order_of_time(page: Tab, tmp_path: Path) -> None:
    path = tmp_path / "own.mcap"
    with path.open("wb") as stream:
        writer = Writer(stream, chunk_size=200)
        writer.start(profile="ros2", library="test")
        schema = writer.register_schema(STRING[0], "ros2msg", STRING[1].encode())
        channel = writer.register_channel("/words", "cdr", schema)
        numbers = list(range(60))
        random.Random(1).shuffle(numbers)
        for number in numbers:
            text = f"n{number:02}".encode()
            data = b"\x00\x01\x00\x00" + struct.pack("<I", len(text) + 1) + text + b"\x00"
            writer.add_message(channel, START + number * 2_000_000, data, 0)
        writer.finish()  # type: ignore[no-untyped-call]
    drop(page, path)
    player(page).get_by_role("button", name="Play", exact=True).click()
    panel = Panel(page, "hears")
    panel.wait_for("n59")
    heard = [one.split("'")[1] for one in panel.messages() if "'n" in one]
    assert heard == [f"n{number:02}" for number in range(60)]


def test_topics_that_cannot_be_played_say_why(page: Tab, tmp_path: Path) -> None:
    bag = made(
        tmp_path / "own.mcap",
        [
            ("/words", STRING[0], "int32 data"),
            ("<img src=x onerror=alert(1)>", *STRING),
            ("/fine", "far_msgs/msg/Thing", "string data"),
            ("/odd", "no type at all", "string data"),
        ],
    )
    drop(page, bag)
    expect(player(page).locator(".ros-bag-row")).to_have_count(4)
    assert rows(page) == [
        "/fine | far_msgs/msg/Thing · 3 messages",
        "/odd | not played: its type is not valid in ROS 2",
        "/words | not played: its type differs from the std_msgs/msg/String of this page"
        " | Compare the definitions",
        "<img src=x onerror=alert(1)> | not played: its name is not valid in ROS 2",
    ]
    assert player(page).locator("img").count() == 0
    player(page).get_by_text("Compare the definitions").click()
    both = player(page).locator(".ros-bag-both > div")
    expect(both).to_have_text(["In the bagint32 data", "On this pagestring data"])
    drop(page, made(tmp_path / "json.mcap", encodings=("json", "ros2msg")))
    expect(player(page)).to_contain_text("not played: its messages are not CDR but json")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("a/Loop x\n" + RULE + "\nMSG: a/Loop\na/Loop x\n", "is nested too deep"),
        (nested(12, "uint8 x"), "is too large"),
        (nested(12, ""), "is too large"),
        ("uint8[4000000000] x", "is too large"),
        ("a/Missing x", "has no definition of a/msg/Missing"),
        ("float64 1st", "has an invalid line: float64 1st"),
        ("#" * 1_100_000, "is too long"),
        (f"{RULE}\nMSG: a/B\n" * 600, "has too many types"),
        ("<script>/x y", "have an invalid type: <script>/x"),
    ],
    ids=["loop", "deep", "empty", "array", "missing", "line", "long", "many", "name"],
)
def test_schemas_that_cannot_be_used_are_said(
    page: Tab, tmp_path: Path, text: str, said: str
) -> None:
    drop(page, made(tmp_path / "own.mcap", [("/far", "far_msgs/msg/Thing", text)]))
    # The topic can be played without: only panels need it.
    expect(player(page).get_by_role("checkbox", name="/far")).to_be_checked()
    expect(player(page).get_by_role("status")).to_contain_text(said)


def test_too_many_topics_are_refused(page: Tab, tmp_path: Path) -> None:
    topics = [(f"/t{number}", *STRING) for number in range(5100)]
    drop(page, made(tmp_path / "own.mcap", topics, times=[0], compression=CompressionType.NONE))
    expect(player(page).get_by_role("status")).to_contain_text("has more than 5000 topics")


def patched(content: bytes, size: int) -> bytes:
    """Let the first chunk of a bag, and the index of chunks, claim another size."""
    own = bytearray(content)
    chunk = next(
        at
        for at in range(len(own))
        if own[at] == 6 and own[at + 9 + 28 : at + 9 + 32] == b"\x04\0\0\0"
    )
    [before] = struct.unpack_from("<Q", own, chunk + 9 + 16)
    for at in (
        match.start() for match in re.finditer(re.escape(struct.pack("<Q", before)), content)
    ):
        struct.pack_into("<Q", own, at, size)
    # Without checksums of the summary.
    struct.pack_into("<I", own, len(own) - 12, 0)
    return bytes(own)


@pytest.mark.parametrize("size", [2**40, 2**28, 10])
def test_chunks_whose_size_is_wrong_are_refused(page: Tab, tmp_path: Path, size: int) -> None:
    path = made(tmp_path / "own.mcap", times=range(2000), compression=CompressionType.ZSTD)
    path.write_bytes(patched(path.read_bytes(), size))
    drop(page, path)
    player(page).get_by_role("button", name="Play", exact=True).click()
    said = "chunks of more than 256 MB" if size > 2**28 else "cannot be read|damaged"
    expect(player(page).get_by_role("status")).to_contain_text(re.compile(said))


def test_what_is_whole_of_a_damaged_bag_is_played(page: Tab, tmp_path: Path) -> None:
    content = bytearray(DRIVE.read_bytes())
    with DRIVE.open("rb") as stream:
        summary = make_reader(stream).get_summary()
    assert summary
    _, second, *others = summary.chunk_indexes
    assert others
    content[second.chunk_start_offset + second.chunk_length - 5] ^= 1
    path = tmp_path / "own.mcap"
    path.write_bytes(content)
    drop(page, path)
    player(page).get_by_label("Speed").select_option("10")
    player(page).get_by_role("button", name="Play", exact=True).click()
    panel = Panel(page, "hears")
    panel.wait_for("bag 119")
    said = "A damaged part of this bag is left out."
    expect(player(page).get_by_role("status")).to_have_text(said)
    numbers = [int(one.split("'")[1][4:]) for one in panel.messages() if "'bag " in one]
    left = sorted(set(range(120)) - set(numbers))
    assert numbers == sorted(numbers)
    assert left == list(range(left[0], left[-1] + 1))
    assert 0 < left[0] < left[-1] < 119


def test_whatever_is_changed_in_a_bag_the_page_goes_on(page: Tab, tmp_path: Path) -> None:
    chance = random.Random(4)
    for number in range(10):
        content = bytearray(DRIVE.read_bytes())
        for _ in range(chance.randint(1, 6)):
            content[chance.randrange(8, len(content))] = chance.randrange(256)
        path = tmp_path / f"odd{number}.mcap"
        path.write_bytes(content)
        drop(page, path)
        note = player(page).locator(".ros-note")
        expect(note).not_to_contain_text("Opening")
        play = player(page).get_by_role("button", name="Play", exact=True)
        if play.is_visible():
            time = player(page).locator(".ros-bag-time")
            begun = time.inner_text()
            play.click()
            until(lambda: time.inner_text() != begun or note.inner_text(), told=time.inner_text)  # noqa: B023
        said = note.inner_text()
        assert "\n" not in said
        assert len(said) < 400
