"""The headers that the documentation names are there, and a program includes them all."""

from __future__ import annotations

import re

import pytest
from paths import ROOT

from sitegen import workspace

PAGES = (
    *("what-runs.md", "libraries.md", "included-packages.md"),
    *("cpp-packages.md", "launch.md", "nodes.md"),
)
PAGE = "\n".join(ROOT.joinpath("docs", name).read_text(encoding="utf-8") for name in PAGES)
INCLUDE = ROOT / "sitegen/clients/cpp/include"
ROS = ROOT / "sitegen/ros/include"
HEADERS = re.findall(r"`([\w/]+\.hp?p?)`", PAGE)
PACKAGES = ROOT / "sitegen/packages"
SYSTEM = INCLUDE.with_name("system")
INCLUDES = [INCLUDE, SYSTEM, ROS / "rcutils", ROS / "rosidl_runtime_c", *PACKAGES.glob("*/include")]
MISSING = {"`cv_bridge`": "cv_bridge"}


@pytest.mark.parametrize("header", HEADERS)
def test_what_the_page_names_is_there(header: str) -> None:
    assert any((folder / header).exists() for folder in INCLUDES)


@pytest.mark.parametrize("words", MISSING)
def test_what_the_page_says_is_not_there_is_not(words: str) -> None:
    assert words in PAGE
    assert not any((folder / MISSING[words]).exists() for folder in INCLUDES)


def test_each_package_that_cmake_finds_is_on_the_page() -> None:
    shares = {folder.name for folder in ROOT.glob("sitegen/clients/cpp/share/*")}
    tools = {
        name for name in shares if name.startswith(("ament_cmake", "ament_lint", "rosidl_"))
    } | {"launch_testing_ament_cmake", "rclpy", "ros_testing"}
    for package in shares - tools - {"class_loader"}:
        assert f"`{package}`" in PAGE or f"## {package}" in PAGE


def test_each_package_and_module_that_comes_along_is_on_the_page() -> None:
    for name, package in workspace.shipped_packages().items():
        names = {name, *(package.executables or ())}
        if package.build_type == workspace.PYTHON:
            files = package.setup.files if package.setup else {}
            names = {place.split("/")[1] for place in files if place.startswith("python/")}
        for each in names:
            assert f"`{each}`" in PAGE
