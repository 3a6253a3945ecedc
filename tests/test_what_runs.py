"""docs/what-runs.md names headers: they are there, and a program includes them all."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PAGE = ROOT.joinpath("docs/what-runs.md").read_text(encoding="utf-8")
INCLUDE = ROOT / "sitegen/clients/cpp/include"
ROS = ROOT / "sitegen/ros/include"
HEADERS = re.findall(r"`([\w/]+\.hp?p?)`", PAGE)
MISSING = {
    "`tf2`": "tf2",
    "`message_filters`": "message_filters",
}


@pytest.mark.parametrize("header", HEADERS)
def test_what_the_page_names_is_there(header: str) -> None:
    found = [(folder / header).exists() for folder in (INCLUDE, ROS / "rcutils")]
    assert any(found)


@pytest.mark.parametrize("words", MISSING)
def test_what_the_page_says_is_not_there_is_not(words: str) -> None:
    assert words in PAGE
    assert not (INCLUDE / MISSING[words]).exists()


def test_each_package_that_cmake_finds_is_on_the_page() -> None:
    shares = {folder.name for folder in ROOT.glob("sitegen/clients/cpp/share/*")}
    tools = {name for name in shares if name.startswith(("ament_cmake", "rosidl_"))} | {"rclpy"}
    for package in shares - tools - {"class_loader"}:
        assert f"`{package}`" in PAGE or f"## {package}" in PAGE
