"""The navigation: from folders, from paths, or as site.yaml says."""

from __future__ import annotations

from pathlib import Path

import pytest

from sitegen.config import load
from sitegen.errors import SiteError
from sitegen.model import Page, Site
from sitegen.site.pages.nav import WHOLE, Link, Navigation


def write(folder: Path, pages: str, *files: str, more: str = "") -> Path:
    for name in files:
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(f"# {file.stem}\n")
    (folder / "site.yaml").write_text(f"site: {{title: T}}\npages:\n{pages}\n{more}")
    return folder / "site.yaml"


def page(site: Site, path: str) -> Page:
    return next(page for page in site.pages if page.path == path)


def lines(links: tuple[Link, ...] | list[Link]) -> list[object]:
    return [
        [link.title, lines(link.inside)] if link.inside else link.title + "*" * link.current
        for link in links
    ]


def test_a_folder_is_pages_in_the_order_of_their_names(tmp_path: Path) -> None:
    file = write(
        tmp_path,
        "  - {path: guide/, folder: docs}",
        *("docs/10-share.md", "docs/2-build it.md", "docs/index.md", "docs/_draft.md"),
        *("docs/03_nodes/README.md", "docs/03_nodes/Talker.md", "docs/.hidden/x.md", "docs/a.txt"),
    )
    site = load(file)
    assert [page.path for page in site.pages] == [
        *("guide/", "guide/build-it/", "guide/nodes/", "guide/nodes/talker/", "guide/share/"),
    ]
    assert page(site, "guide/nodes/talker/").title == "Talker"


@pytest.mark.parametrize(
    ("pages", "files", "fault"),
    [
        (
            "  - {path: /, folder: docs}",
            ("docs/1-a.md", "docs/2-a.md"),
            "'a/' from 2-a.md is already used by",
        ),
        ("  - {path: /, folder: docs}", ("docs/a.txt",), "no Markdown file in 'docs'; add"),
        ("  - {path: /, folder: dcos}", ("docs/a.md",), "no folder 'dcos'; did you mean 'docs'?"),
        (
            "  - {path: /, folder: docs, title: A}",
            ("docs/a.md",),
            "cannot be combined with 'folder'; write it",
        ),
        (
            "  - {path: /, folder: docs, file: docs/a.md}",
            ("docs/a.md",),
            "cannot be combined with 'file'; keep",
        ),
    ],
)
def test_what_is_wrong_with_a_folder(
    tmp_path: Path, pages: str, files: tuple[str, ...], fault: str
) -> None:
    with pytest.raises(SiteError) as wrong:
        load(write(tmp_path, pages, *files))
    assert fault in wrong.value.lines[0]


def test_paths_are_the_navigation(tmp_path: Path) -> None:
    site = load(
        write(
            tmp_path,
            "  - {path: /, file: home.md}\n  - {path: a/one/, file: one.md}\n"
            "  - {path: a/two/, file: two.md}\n  - {path: b/, file: b.md}\n"
            "  - {path: b/x/y/, file: y.md}",
            *("home.md", "one.md", "two.md", "b.md", "y.md"),
        )
    )
    navigation = Navigation(site)
    # A folder of several pages without its own is a group, which is no link.
    menu = navigation.menu(page(site, ""))
    assert lines(menu) == ["home*", ["A", ["one", "two"]], "b"]
    assert (menu[1].href, menu[1].open) == ("", False)
    assert navigation.menu(page(site, "a/two/"))[1].open
    assert lines(navigation.menu(page(site, "a/two/"))) == ["home", ["A", ["one", "two*"]], "b"]
    assert [link.title for link in navigation.trail(page(site, "b/x/y/"))] == ["b"]
    previous, following = navigation.around(page(site, "a/two/"))
    assert previous == Link("one", "../../a/one/")
    assert following == Link("b", "../../b/")


def test_a_large_site_has_the_groups_of_the_page_alone(tmp_path: Path) -> None:
    """Otherwise its size would grow with the square of its pages."""
    names = [f"{folder}/{number}" for folder in "ab" for number in range(WHOLE)]
    pages = "\n".join(f"  - {{path: {name}/, file: {name}.md}}" for name in names)
    site = load(write(tmp_path, pages, *(f"{name}.md" for name in names)))
    one, other = Navigation(site).menu(page(site, "b/7/"))
    assert (one.href, one.inside) == ("../../a/0/", ())
    assert (other.href, len(other.inside)) == ("", WHOLE)


NAV = """\
nav:
  - two/
  - Group:
      - First: one/
      - Inner: [/]
  - ROS: https://docs.ros.org/
"""
THREE = (
    "  - {path: /, file: home.md}\n  - {path: one/, file: one.md}\n  - {path: two/, file: two.md}",
    *("home.md", "one.md", "two.md"),
)


def test_site_yaml_may_say_it(tmp_path: Path) -> None:
    site = load(write(tmp_path, *THREE, more=NAV))
    navigation = Navigation(site)
    menu = navigation.menu(page(site, ""))
    assert lines(menu) == ["two", ["Group", ["First", ["Inner", ["home*"]]]], "ROS"]
    assert menu[2].href == "https://docs.ros.org/"
    assert [link.title for link in navigation.trail(page(site, ""))] == ["Group", "Inner"]
    assert [link and link.title for link in navigation.around(page(site, "one/"))] == [
        "two",
        "home",
    ]


def test_what_is_wrong_with_nav_is_told(tmp_path: Path) -> None:
    wrong = "nav:\n  - tow/\n  - A: []\n  - {a: one/, b: two/}\n  - 7\n  - https://docs.ros.org/\n"
    with pytest.raises(SiteError) as raised:
        load(write(tmp_path, *THREE, more=wrong))
    assert raised.value.lines == [
        "site.yaml:7: nav[0]: no page 'tow/'; did you mean 'two/'?",
        "site.yaml:8: nav[1].A: expected a path, an address or a list of them, found a list; "
        "write it like 'A: demo01/'",
        "site.yaml:9: nav[2]: expected the path of a page or a title, found keys and values; "
        "write it like 'demo01/' or 'Demos: [demo01/, demo02/]'",
        "site.yaml:10: nav[3]: expected the path of a page or a title, found the number 7; "
        "write it like 'demo01/' or 'Demos: [demo01/, demo02/]'",
        "site.yaml:11: nav[4]: no page 'https://docs.ros.org/'; known: /, one/, two/",
    ]


def test_a_page_that_is_not_in_nav_exists(tmp_path: Path) -> None:
    site = load(write(tmp_path, *THREE, more="nav: [one/, two/]\n"))
    navigation = Navigation(site)
    assert navigation.around(page(site, "")) == (None, None)
    assert lines(navigation.menu(page(site, ""))) == ["one", "two"]
