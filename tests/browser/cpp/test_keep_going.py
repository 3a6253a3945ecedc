"""Pages with nodes that did not compile."""

from __future__ import annotations

from pathlib import Path

import pytest
from browser import Serve
from panel import Panel
from playwright.sync_api import Browser, expect

from sitegen.__main__ import main

SITE = """\
site: {title: Test, asyncify: false}
nodes:
  good: {package: mixed, executable: good}
  bad: {package: mixed, executable: bad}
  lost: {package: lost, executable: lost}
pages:
  - path: /
    title: Test
    content: [{buttons: good}, {console: good}, {buttons: bad}, {console: bad}, {console: lost}]
"""
MANIFEST = "<package format='3'><name>{}</name></package>\n"
CMAKE = "cmake_minimum_required(VERSION 3.8)\nproject({})\nfind_package(ament_cmake REQUIRED)\n"
BAD = "bad: did not build: 'mixed' includes 'absent/part.hpp', which was not found; "
LOST = "lost: did not build: 'lost' needs 'PCL', which has no build for the page"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    mixed, lost = tmp_path / "src/mixed", tmp_path / "src/lost"
    for package in (mixed, lost):
        package.mkdir(parents=True)
        (package / "package.xml").write_text(MANIFEST.format(package.name))
    (tmp_path / "site.yaml").write_text(SITE)
    programs = "add_executable(good good.cpp)\nadd_executable(bad bad.cpp)\nament_package()\n"
    (mixed / "CMakeLists.txt").write_text(CMAKE.format("mixed") + programs)
    (mixed / "good.cpp").write_text('#include <cstdio>\nint main() {std::puts("works");}\n')
    (mixed / "bad.cpp").write_text("#include <absent/part.hpp>\nint main() {}\n")
    needs = "find_package(PCL REQUIRED)\nadd_executable(lost lost.cpp)\n"
    (lost / "CMakeLists.txt").write_text(CMAKE.format("lost") + needs)
    (lost / "lost.cpp").write_text("#include <pcl/point_cloud.h>\nint main() {}\n")
    return tmp_path


def test_what_did_not_build_says_so_on_its_page(
    folder: Path, browser: Browser, serve: Serve, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["build", str(folder)]) == 1
    assert not (folder / "dist").exists()
    assert "2 problems, nothing was built" in capsys.readouterr().err

    assert main(["build", "--keep-going", str(folder)]) == 0
    said = capsys.readouterr().out
    assert "src/mixed/bad.cpp:1: 'mixed' includes 'absent/part.hpp'" in said
    assert "  lost/lost: did not build" in said
    page = browser.new_page()
    page.goto(serve(folder / "dist"))
    good, bad, lost = (Panel(page, name) for name in ("good", "bad", "lost"))
    bad.expect_state("failed")
    expect(bad.console).to_contain_text(BAD)
    expect(lost.console).to_contain_text(LOST)
    # Pressing Start says so again.
    bad.button("Clear").click()
    bad.start()
    expect(bad.console).to_contain_text(BAD)
    good.start()
    good.wait_for("works")

    # What failed is tried again by the next build, with the option or without.
    assert main(["build", str(folder)]) == 1


def test_nodes_of_launch_files_may_need_what_no_page_has(
    folder: Path, browser: Browser, serve: Serve, capsys: pytest.CaptureFixture[str]
) -> None:
    launch = folder / "all.launch.xml"
    nodes = ("mixed", "good"), ("lost", "lost")
    tags = "".join(f'<node pkg="{package}" exec="{name}"/>' for package, name in nodes)
    launch.write_text(f"<launch>{tags}</launch>")
    page = "pages: [{path: /, title: Test, launch: all.launch.xml}]"
    (folder / "site.yaml").write_text(f"site: {{title: Test, asyncify: false}}\n{page}\n")
    assert main(["build", str(folder)]) == 0
    said = capsys.readouterr().out.splitlines()
    needs = "src/lost/CMakeLists.txt: 'lost' needs 'PCL', which has no build for the page"
    assert f"{needs} (left out: lost/lost)" in said
    tab = browser.new_page()
    tab.goto(serve(folder / "dist"))
    Panel(tab, "good").wait_for("works")
    expect(Panel(tab, "lost").console).to_contain_text(LOST)

    # What can be mended is an error.
    launch.write_text(f"<launch>{tags}<node pkg='mixed' exec='bad'/></launch>")
    assert main(["build", str(folder)]) == 1
    assert "'absent/part.hpp', which was not found" in capsys.readouterr().err
