"""The pages for authors say what the program does."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from keytables import TABLES, with_tables
from paths import ROOT

from sitegen.__main__ import main
from sitegen.config import load
from sitegen.config.document import parse
from sitegen.config.level import LEVELS
from sitegen.config.schema import FRONT_MATTER, Key
from sitegen.config.section import conforms
from sitegen.config.widgetkeys import LAYOUTS, WIDGETS
from sitegen.errors import Location, Problems
from sitegen.model import Widget

DOCS = ROOT / "docs"
SITE_YAML = DOCS.joinpath("site-yaml.md").read_text(encoding="utf-8")

WRITING = DOCS.joinpath("writing.md").read_text(encoding="utf-8")
WIDGET_PAGES = "".join(
    DOCS.joinpath(name).read_text(encoding="utf-8")
    for name in (
        *("widgets.md", "panels.md", "node-panels.md", "notebooks.md", "robots.md", "terminal.md"),
        *("views.md", "plots.md", "cameras.md", "bags.md", "gateway.md", "launch.md"),
        "own-panels.md",
    )
)
PAGES_PAGE = DOCS.joinpath("pages.md").read_text(encoding="utf-8")
KEYS = [key for tables in TABLES.values() for keys in tables.values() for key in keys]
PAGES = sorted(
    file
    for pattern in ("*.md", "docs/**/*.md", "demos/*/*.md", "bench/*.md")
    for file in ROOT.glob(pattern)
)


@pytest.mark.parametrize("page", TABLES)
def test_the_tables_of_keys_are_those_of_the_schema(page: str) -> None:
    text = DOCS.joinpath(page).read_text(encoding="utf-8")
    assert text == with_tables(page, text), "run: .venv/bin/python tests/support/keytables.py"


@pytest.mark.parametrize("page", TABLES)
def test_no_row_of_a_table_of_keys_is_long(page: str) -> None:
    text = DOCS.joinpath(page).read_text(encoding="utf-8")
    assert [line for line in text.splitlines() if line[:1] == "|" and len(line) > 110] == []


def test_the_keys_of_front_matter_are_described() -> None:
    [sentence] = re.findall(r"^The front matter .*$", WRITING, flags=re.MULTILINE)
    keys = re.findall(r"`(\w+)`", sentence)
    assert keys == [key.name for key in FRONT_MATTER]


def test_every_widget_is_described() -> None:
    assert re.findall(r"^###? ([a-z3]\w*)$", WIDGET_PAGES, flags=re.MULTILINE) == list(WIDGETS)


def test_every_widget_is_shown() -> None:
    blocks = re.findall(r"^```yaml ros\n(.*?)^```$", WIDGET_PAGES, flags=re.MULTILINE | re.DOTALL)
    shown = {kind for block in blocks for kind in re.findall(r"^- (\w+):", block, re.MULTILINE)}
    # One needs a gateway, the other is twenty megabytes of JupyterLab.
    assert set(WIDGETS) - shown == {"connect", "jupyter"}


def test_the_panel_that_is_explained_is_the_one_that_is_shown() -> None:
    text = DOCS.joinpath("own-panels.md").read_text(encoding="utf-8")
    [code] = re.findall(r'^```js title="panels/height.js"\n(.*?)^```$', text, re.M | re.S)
    assert code == DOCS.joinpath("panels/height.js").read_text(encoding="utf-8")


def test_every_layout_is_described() -> None:
    text = DOCS.joinpath("layouts.md").read_text(encoding="utf-8")
    assert sorted(re.findall(r"^## ([a-z]\w+)$", text, flags=re.MULTILINE)) == sorted(LAYOUTS)


def cells(line: str) -> int:
    """The number of cells of a row: what its bars enclose, without those that are escaped."""
    return len(re.findall(r"(?<!\\)\|", line)) - 1


def malformed_rows(text: str) -> list[str]:
    """The lines that Markdown takes for rows of a table, but whose cells are not the table's."""
    without_code = re.sub(r"^(```+|~~~+).*?^\1$", "", text, flags=re.MULTILINE | re.DOTALL)
    tables = re.findall(r"(\|.*)\n\|[-:| ]+\|\n((?:.*\S.*\n?)*)", without_code)
    return [row for head, rows in tables for row in rows.splitlines() if cells(row) != cells(head)]


@pytest.mark.parametrize("file", PAGES, ids=lambda file: str(file.relative_to(ROOT)))
def test_what_follows_a_table_is_not_a_row_of_it(file: Path) -> None:
    assert malformed_rows(file.read_text(encoding="utf-8")) == []


def test_a_paragraph_right_behind_a_table_is_found() -> None:
    text = "| key | type |\n|---|---|\n| `a\\|b` | text |\nEvery site has one.\n\nMore.\n"
    assert malformed_rows(text) == ["Every site has one."]


def test_every_level_is_described() -> None:
    assert re.findall(r"^\| (I\d) ", PAGES_PAGE, flags=re.MULTILINE) == list(LEVELS)


def test_the_example_is_a_site(tmp_path: Path) -> None:
    examples = re.findall(r"^```yaml\n(.*?)^```", SITE_YAML, flags=re.MULTILINE | re.DOTALL)
    pages = re.findall(r"^````markdown\n(.*?)^````", WRITING, flags=re.MULTILINE | re.DOTALL)
    files = {
        "site.yaml": examples[0],
        "intro.md": "",
        "demos/demo01/page.md": pages[0],
        "themes/default/page.html": "",
        "src/cpp_pubsub/package.xml": "<package><name>cpp_pubsub</name></package>",
        "src/cpp_pubsub/CMakeLists.txt": "add_executable(talker a)\nadd_executable(listener b)",
    }
    for name, text in files.items():
        file = tmp_path / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    site = load(tmp_path / "site.yaml")
    assert [(page.path, page.level) for page in site.pages] == [
        ("", ""),
        ("demo03/", "I3"),
        ("demo01/", "I2"),
    ]
    widgets = [part.kind for part in site.pages[2].content if isinstance(part, Widget)]
    assert widgets == ["buttons", "console"]


@pytest.mark.parametrize("name", ["publish.md", "compiled.md"])
def test_the_examples_of_a_guide_are_sites(name: str, tmp_path: Path) -> None:
    text = DOCS.joinpath(name).read_text(encoding="utf-8")
    examples = re.findall(r"^```yaml\n(.*?)^```", text, flags=re.MULTILINE | re.DOTALL)
    assert examples
    (tmp_path / "nodes.zip").touch()
    for example in examples:
        pages = "" if "pages:" in example else "pages: [{path: /, content: [{markdown: '# A'}]}]\n"
        (tmp_path / "site.yaml").write_text(example + pages, encoding="utf-8")
        assert load(tmp_path / "site.yaml").notes == ()


def test_every_command_is_described(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["--help"])
    commands = re.findall(r"^    (\w+)(?: |$)", capsys.readouterr().out, flags=re.MULTILINE)
    assert {"new", "init", "check", "build", "compile", "deploy"} <= set(commands)
    text = DOCS.joinpath("commands.md").read_text(encoding="utf-8")
    described = re.findall(r"^## `sitegen (\w+)", text, flags=re.MULTILINE)
    assert sorted(set(described)) == sorted(commands)


@pytest.mark.parametrize("key", KEYS, ids=lambda key: key.name)
def test_the_example_of_a_key_is_right(key: Key) -> None:
    problems = Problems(Path())
    value = parse(key.example, Location(Path("example"), 1), problems)
    assert value
    assert conforms(value.entries(problems)[key.name], key, problems), problems.lines
