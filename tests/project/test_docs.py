"""The pages for authors say what the program does."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from paths import ROOT

from sitegen.__main__ import main
from sitegen.config import load
from sitegen.config.document import parse
from sitegen.config.level import LEVELS
from sitegen.config.schema import (
    COMPILED,
    DEPLOY,
    FILE,
    FRONT_MATTER,
    NODE,
    PAGE,
    PYODIDE,
    ROS2WASM,
    SITE,
    WIDGETS,
    Key,
)
from sitegen.config.section import conforms
from sitegen.errors import Location, Problems
from sitegen.model import Widget

DOCS = ROOT / "docs"
SITE_YAML = DOCS.joinpath("site-yaml.md").read_text(encoding="utf-8")

SECTIONS = {
    "The file": FILE,
    "site": SITE,
    "pyodide": PYODIDE,
    "deploy": DEPLOY,
    "A node": NODE,
    "A node compiled elsewhere": COMPILED,
    "A node of ROS2WASM": ROS2WASM,
    "A page": PAGE,
    "A page in Markdown": FRONT_MATTER,
    **WIDGETS,
}
KEYS = [key for keys in SECTIONS.values() for key in keys]


def rows(heading: str) -> list[tuple[str, ...]]:
    section = re.split(r"^#+ ", SITE_YAML.split(f"# {heading}\n")[1], flags=re.MULTILINE)[0]
    table = [line for line in section.splitlines() if line.startswith("| `")]
    return [tuple(cell.strip(" `") for cell in line.split("|")[1:-1]) for line in table]


def default(key: Key) -> str:
    if key.required:
        return "required"
    return str(key.default).lower()


@pytest.mark.parametrize("heading", SECTIONS)
def test_every_key_is_described(heading: str) -> None:
    described = [row[:3] for row in rows(heading)]
    assert described == [(key.name, key.type, default(key)) for key in SECTIONS[heading]]


def test_every_widget_is_described() -> None:
    assert re.findall(r"^### (\w+)$", SITE_YAML, flags=re.MULTILINE) == list(WIDGETS)


def test_every_level_is_described() -> None:
    assert re.findall(r"^\| (I\d) ", SITE_YAML, flags=re.MULTILINE) == list(LEVELS)


def test_the_example_is_a_site(tmp_path: Path) -> None:
    examples = re.findall(r"^```yaml\n(.*?)^```", SITE_YAML, flags=re.MULTILINE | re.DOTALL)
    pages = re.findall(r"^````markdown\n(.*?)^````", SITE_YAML, flags=re.MULTILINE | re.DOTALL)
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
