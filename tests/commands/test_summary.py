"""What a build says of a site that is large: all that matters, on one screen."""

from __future__ import annotations

import itertools
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from pathlib import Path

import pytest

from sitegen import config
from sitegen.commands.summary import summary
from sitegen.model import Artifact, Page, Program, Site

SCREEN = 24


@dataclass
class Made:
    """A program that was built."""

    name: str
    written_in: str = "C++"
    sizes: dict[str, dict[str, int]] = field(default_factory=dict)
    worker: str = ""
    files: tuple[Artifact, ...] = ()
    fault: str = ""

    def types(self, *_: object) -> dict[str, object]:
        return {}

    def entry(self, *_: object) -> dict[str, object]:
        return {}


def cpp(name: str) -> Program:
    return Made(
        name, "C++", {"jspi": {f"{name}.jspi.wasm": 123_000}, "asyncify": {f"{name}.wasm": 289_000}}
    )


def python(name: str) -> Program:
    return Made(name, "Python", {"": {"shared.zip": 2_000_000, f"{name}.zip": 100_000}})


@pytest.fixture
def site(tmp_path: Path) -> Site:
    file = tmp_path / "site.yaml"
    file.write_text("site: {title: T}\npages: [{path: /, title: Home, content: []}]\n")
    return config.load(file)


def pages(site: Site, paths: Iterable[tuple[str, str]]) -> Site:
    (home,) = site.pages
    made: list[Page] = [replace(home, path=p, title=p, level=level) for p, level in paths]
    return replace(site, pages=(home, *made))


def programs(*ones: Program) -> dict[tuple[str, ...], Program]:
    return {(one.name,): one for one in ones}


def test_a_small_site_is_listed(site: Site) -> None:
    site = pages(site, [("demo/", "I2")])
    nodes = programs(cpp("robot/talker"), python("robot/listener"))
    lines = summary(site, nodes)
    assert lines == [
        "  /           Home",
        "  /demo/  I2  demo/",
        "  robot/talker: C++, 123 kB for current browsers, 289 kB for all browsers",
        "  robot/listener: Python, 2.1 MB",
    ]
    assert lines == summary(site, nodes, verbose=True)


def test_pages_that_run_nodes_are_the_last_to_be_left_out(site: Site) -> None:
    texts = [(f"text{number}/", "") for number in range(20)]
    demos = [(f"demos/{number}/", level) for number, level in enumerate(["", "I2", "I4"])]
    lines = summary(pages(site, [*texts, *demos]), {})
    assert lines[-3:] == [
        "  /demos/…  I2-I4  3 pages",
        "  … and 12 pages more",
        "  --verbose lists all",
    ]
    assert len(lines) == 12


@pytest.mark.parametrize(
    ("many_pages", "many_nodes", "notes"),
    list(itertools.product([1, 11, 500], [0, 6, 90], [0, 4, 50])),
)
def test_it_fits_on_a_screen_and_loses_nothing(
    site: Site, many_pages: int, many_nodes: int, notes: int
) -> None:
    site = pages(site, [(f"page{number}/", "I1") for number in range(many_pages)])
    site = replace(site, notes=tuple(f"site.yaml:{number}: note" for number in range(notes)))
    made = [cpp(f"a/{number}") for number in range(many_nodes // 2)]
    made += [python(f"b/{number}") for number in range(many_nodes // 2)]
    # What is said of time and place, and the prompt, take a line each.
    assert len(summary(site, programs(*made))) <= SCREEN - 2
    everything = summary(site, programs(*made), verbose=True)
    assert len(everything) == notes + many_pages + 1 + many_nodes // 2 * 2


def test_files_that_programs_share_count_once(site: Site) -> None:
    nodes = [cpp(f"a/{number}") for number in range(4)] + [python(f"b/{n}") for n in range(4)]
    assert summary(site, programs(*nodes))[1:] == [
        "  4 nodes in C++, 492 kB for current browsers, 1.2 MB for all browsers",
        "  4 nodes in Python, 2.4 MB",
        "  --verbose lists all",
    ]


def test_meshes_are_told_by_size(site: Site) -> None:
    def meshes(number: int) -> list[Artifact]:
        sizes = (1_000 * (number - n) for n in range(number))
        found = [Artifact(f"meshes/arm/{n}.stl", bytes(one)) for n, one in enumerate(sizes)]
        return [Artifact("index.html", b""), *found]

    assert summary(site, {}, meshes(2))[1:] == [
        "  2 files for 3D views, 3 kB",
        "    arm/0.stl: 2 kB",
        "    arm/1.stl: 1 kB",
    ]
    assert summary(site, {}, meshes(20))[1:] == [
        "  20 files for 3D views, 210 kB; the largest is arm/0.stl, 20 kB",
        "  --verbose lists all",
    ]
    assert len(summary(site, {}, meshes(20), verbose=True)) == 22
