"""What the terminal's `ros2` prints, against a table that was compared with ros2cli's sources."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from shellnode import shell

TABLE = (Path(__file__).parent / "native.txt").read_text()
ENTRY = re.compile(
    r"^# (?P<source>ros2\w+/\S+\.py:\d+)(?:, (?P<wait>[\d.]+) s)?\n\$ (?P<line>.*)\n"
    r"(?P<shown>(?s:.*?))^\[(?P<status>\d+)\]$(?=\n\n|\n?\Z)",
    re.M,
)
ENTRIES = [match.groupdict() for match in ENTRY.finditer(TABLE)]


@pytest.fixture(scope="module")
def found() -> list[tuple[str, int]]:
    return shell([(one["line"], float(one["wait"] or 10)) for one in ENTRIES])


def pattern(shown: str) -> str:
    """Return a pattern of an output in the table."""
    escaped = re.escape(shown.rstrip("\n")).replace(re.escape("{n}"), r"-?[\d.a-f]+")
    return re.sub(r"(\\ )+", r" +", escaped)


def plain(shown: str) -> str:
    return (
        re.sub(r"=+", "=", re.sub(r"^ +| +$", "", shown, flags=re.M)) if "===" in shown else shown
    )


def test_the_table_is_read() -> None:
    assert len(ENTRIES) == TABLE.count("\n# ros2") > 75


@pytest.mark.parametrize("index", range(len(ENTRIES)))
def test_a_command_prints_what_ros2cli_prints(index: int, found: list[tuple[str, int]]) -> None:
    entry, (shown, status) = ENTRIES[index], found[index]
    assert re.fullmatch(pattern(entry["shown"]), plain(shown).rstrip("\n")), (
        f"{entry['source']}: {entry['line']}\n{shown}"
    )
    assert status == int(entry["status"]), entry["line"]


def test_help_goes_on_screen_with_status_0() -> None:
    [(shown, status), (usage, wrong)] = shell(["ros2 topic -h", "ros2 topic frob"])
    assert shown.startswith("usage: ros2 topic [-h] [--include-hidden-topics]") and status == 0
    assert "argument Call `ros2 topic <command> -h` for more detailed usage.:" in usage
    assert "invalid choice: 'frob' (choose from 'bw', 'delay', 'echo', " in usage and wrong == 2
