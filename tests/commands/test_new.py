"""A workspace from nothing: it is made, built, and its two nodes hear each other."""

from __future__ import annotations

from pathlib import Path

import pytest
from browser import Built, Serve
from playwright.sync_api import Page, expect

from sitegen import config, workspace
from sitegen.__main__ import main
from sitegen.commands.new import TEMPLATE


def test_its_nodes_hear_each_other(
    tmp_path: Path,
    built: Built,
    serve: Serve,
    tab: Page,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["new", "sea_fox"]) == 0
    said = capsys.readouterr().out.splitlines()
    assert "  src/sea_fox_py/sea_fox_py/listener.py" in said
    assert said[-1] == "wrote sea_fox; now: cd sea_fox && sitegen serve"

    site = config.load(Path("sea_fox/site.yaml"))
    assert (site.title, site.notes) == ("Sea fox", ())
    tab.goto(serve(built(tmp_path / "sea_fox")))
    starts = tab.get_by_role("button", name="Start", exact=True)
    expect(starts).to_have_count(2)
    for start in starts.all():
        start.click()
    expect(tab.locator("body")).to_contain_text("Publishing: 'Hello, world! 3'")
    expect(tab.locator("body")).to_contain_text("I heard: 'Hello, world!")


def test_nothing_of_the_template_is_left(tmp_path: Path) -> None:
    assert main(["new", str(tmp_path / "deep" / "r2d2")]) == 0
    made = tmp_path / "deep" / "r2d2"
    for file in [file for file in made.rglob("*") if file.is_file()]:
        assert "my_robot" not in f"{file} {file.read_text()}"
        assert "My robot" not in file.read_text()
    assert sorted(workspace.scan(made)) == ["r2d2_cpp", "r2d2_py"]
    assert (made / ".gitignore").read_text().split() >= ["build/", "dist/"]
    files = sum(file.is_file() for file in TEMPLATE.rglob("*") if file.suffix != ".pyc")
    # The schema is made, not copied.
    assert sum(file.is_file() for file in made.rglob("*")) == files + 1
    # Nothing else beside it, such as what was half-written.
    assert list(made.parent.iterdir()) == [made]


@pytest.mark.parametrize(
    ("name", "like"),
    [
        ("My-Robot", "my_robot"),
        ("2fast", "fast"),
        ("robot_", "robot"),
        ("a__b", "a_b"),
        ("x", "my_robot"),
        ("über", "ber"),
        ("..", "my_robot"),
    ],
)
def test_what_is_no_package_name_is_refused(
    name: str, like: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["new", str(tmp_path / name)]) == 1
    assert capsys.readouterr().err == (
        f"'{name}' is not a valid package name; "
        "use lower-case letters, digits and single '_', starting with a letter"
        f", like '{like}'\n1 problem, nothing was written\n"
    )
    assert list(tmp_path.iterdir()) == []


def test_nothing_is_overwritten(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "robot"
    folder.mkdir()
    (folder / "README.md").write_text("mine")
    assert main(["new", str(folder)]) == 1
    there = f"{folder} already exists and contains README.md; choose another name"
    assert there in capsys.readouterr().err
    assert [file.read_text() for file in folder.iterdir()] == ["mine"]

    (folder / "README.md").unlink()
    assert main(["new", str(folder)]) == 0
    (tmp_path / "fox").write_text("mine")
    assert main(["new", str(tmp_path / "fox")]) == 1
    assert "fox is a file; choose another name" in capsys.readouterr().err
