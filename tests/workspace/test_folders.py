"""Workspaces with packages behind links."""

from __future__ import annotations

from pathlib import Path

import pytest

from sitegen.cache.digest import digest_of
from sitegen.commands.build import build
from sitegen.errors import SiteError
from sitegen.report import Report
from sitegen.workspace import scan

MANIFEST = """<package format="3"><name>{}</name><version>1.0.0</version><depend>rclpy</depend>
<export><build_type>ament_python</build_type></export></package>
"""
SETUP = """from setuptools import setup
setup(packages=["{0}"], entry_points={{"console_scripts": ["run = {0}.node:main"]}})
"""
SITE = """site: {title: Walker}
workspace: ws
nodes: {walker: {package: walker, executable: run}}
pages: [{path: /, title: Walker, content: [{console: walker}]}]
"""


def package(folder: Path, name: str) -> Path:
    (folder / name / name).mkdir(parents=True)
    (folder / name / "package.xml").write_text(MANIFEST.format(name))
    (folder / name / "setup.py").write_text(SETUP.format(name))
    (folder / name / name / "__init__.py").write_text("")
    (folder / name / name / "node.py").write_text("def main(): ...\n")
    return folder / name


def link(path: Path, target: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.symlink_to(target)


@pytest.fixture
def site(tmp_path: Path) -> Path:
    """A site, and a shelf with a package beside its workspace."""
    root = tmp_path / "site"
    package(root / "shelf", "walker")
    (root / "ws/src").mkdir(parents=True)
    (root / "site.yaml").write_text(SITE)
    return root


def built(site: Path) -> list[str]:
    """Build the site, and return the installed files of its node."""
    build(site, output=site / "dist", report=Report())
    return sorted(path.name for path in (site / "dist/nodes").rglob("*") if path.is_file())


@pytest.mark.parametrize(
    ("where", "target"),
    [
        ("ws/src/walker", "../../shelf/walker"),
        ("ws/src/other_name", "../../shelf/walker"),
        ("ws/src/shelf", "../../shelf"),
        ("ws/src", "../shelf"),
    ],
)
def test_packages_behind_links_are_built(site: Path, where: str, target: str) -> None:
    if where == "ws/src":
        (site / where).rmdir()
    link(site / where, target)
    assert "python.zip" in built(site)


def test_links_to_each_other_end(site: Path) -> None:
    link(site / "ws/src/walker", "../../shelf/walker")
    link(site / "ws/src/again", "../../shelf")
    link(site / "ws/src/up", "../..")
    link(site / "ws/loop", ".")
    link(site / "ws/self", "self")
    link(site / "ws/nowhere", "missing")
    link(site / "shelf/walker/inside", ".")
    link(site / "shelf/walker/self", "self")
    link(site / "shelf/walker/nowhere", "missing")
    assert "python.zip" in built(site)
    # An unchanged build reads them all again.
    assert "python.zip" in built(site)
    assert digest_of([site / "shelf/walker"]) == digest_of([site / "ws/src/walker"])


def test_a_package_is_found_once(tmp_path: Path) -> None:
    package(tmp_path / "src", "walker")
    link(tmp_path / "src/a", "walker")
    link(tmp_path / "src/z", "walker")
    found = scan(tmp_path)
    assert {name: one.path for name, one in found.items()} == {"walker": tmp_path / "src/walker"}


def test_an_ignored_folder_is_ignored_behind_a_link(site: Path) -> None:
    (site / "shelf/walker/COLCON_IGNORE").touch()
    link(site / "ws/src/walker", "../../shelf/walker")
    assert scan(site / "ws") == {}


@pytest.mark.parametrize(("name", "target"), [("walker", "far/walker"), ("shelf", "far")])
def test_a_link_that_leads_outside_is_named(site: Path, name: str, target: str) -> None:
    package(site.parent / "far", "walker")
    link(site / f"ws/src/{name}", f"../../../{target}")
    link(site / "ws/src/data", "/usr")
    with pytest.raises(SiteError) as caught:
        build(site, output=site / "dist", report=Report())
    what = "link: leads to packages outside the folder of site.yaml; copy them to this place"
    assert caught.value.lines == [
        "site.yaml:3: nodes.walker.package: no package 'walker' in the workspace; there are none",
        f"ws/src/{name}:1: {what}",
    ]
