"""A site.yaml of `new` or `init` in an editor: its keys are completed, and wrong ones marked."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from editor import editing
from paths import ROOT

from sitegen import config
from sitegen.__main__ import main

TALKER = ROOT / "demos" / "demo01" / "src"


def made_by(command: str, folder: Path) -> Path:
    """Return the site.yaml that a command writes."""
    site = folder / "fox"
    if command == "init":
        shutil.copytree(TALKER, site / "src")
    assert main([command, str(site)]) == 0
    assert json.loads((site / "site.schema.json").read_text()) == config.json_schema()
    return site / "site.yaml"


@pytest.mark.parametrize("command", ["new", "init"])
def test_an_editor_knows_the_keys(command: str, tmp_path: Path) -> None:
    file = made_by(command, tmp_path)
    with editing(file) as editor:
        assert editor.diagnostics() == []

    text = file.read_text()
    lines = text.splitlines()
    at = next(number for number, line in enumerate(lines) if line.startswith("  title:"))
    lines[at] = lines[at].replace("title:", "titel:")
    lines.insert(at + 1, "  des")
    file.write_text("\n".join(lines) + "\n")
    with editing(file) as editor:
        problems = editor.diagnostics()
        assert (at, "Property titel is not allowed.") in problems
        assert 'Missing property "title".' in [message for _, message in problems]
        found = editor.completions(at + 1, len("  des"))
        assert found["description"] == "one sentence for link previews"
        assert {"title", "url", "theme"} <= found.keys()
        assert "workspace" not in found


def test_a_file_of_the_author_is_not_replaced(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    shutil.copytree(TALKER, tmp_path / "src")
    file = tmp_path / "site.schema.json"
    file.write_text("{}")
    assert main(["init", str(tmp_path)]) == 1
    assert f"{file} already exists and was not written by sitegen" in capsys.readouterr().err
    assert file.read_text() == "{}"
    assert not (tmp_path / "site.yaml").exists()
    assert main(["schema"]) == 0
    file.write_text(capsys.readouterr().out)
    assert main(["init", str(tmp_path)]) == 0
