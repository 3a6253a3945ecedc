"""What widgets say, in the languages that sitegen brings."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from browser import Serve
from paths import ROOT
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from stage import add, chatter, show

RUNTIME = ROOT / "sitegen/runtime"
# say("…") or say('…'), also with several pieces: "…" + "…"; said("…"), Fault("…") and Damage("…")
# in workers, whose texts the page says
SAID = re.compile(
    r"""\b(?:say|said|Fault|Damage)\(\s*((?:"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*')(?:\s*\+\s*"(?:[^"\\]|\\.)*")*)"""
)
TRANSLATIONS = sorted((RUNTIME / "ui/words").glob("*.js"))


def plain(literal: str) -> str:
    """The text that a literal of JavaScript means."""
    pieces = re.findall(r"""("(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*')""", literal)
    texts = (
        json.loads(piece if piece[0] == '"' else '"' + piece[1:-1].replace('"', '\\"') + '"')
        for piece in pieces
    )
    return "".join(texts)


def said() -> set[str]:
    files = [file for file in RUNTIME.rglob("*.js") if "vendor" not in file.parts]
    texts = {plain(match[1]) for file in files for match in SAID.finditer(file.read_text())}
    assert len(texts) > 100
    return texts


def words(file: Path) -> dict[str, str]:
    parts = [file, *file.with_suffix("").glob("*.js")]
    text = "".join(part.read_text() for part in parts)
    pairs = re.findall(r"^  (\"(?:[^\"\\]|\\.)*\"):\s+(\"(?:[^\"\\]|\\.)*\"),$", text, re.M)
    return {json.loads(english): json.loads(text) for english, text in pairs}


@pytest.mark.parametrize("file", TRANSLATIONS, ids=lambda file: file.stem)
def test_a_language_has_all_words_and_no_others(file: Path) -> None:
    table = words(file)
    assert sorted(said() - set(table)) == []
    assert sorted(set(table) - said()) == []
    for english, text in table.items():
        assert text
        assert text.count("{}") == english.count("{}"), english
    assert f'"{file.stem}"' in (RUNTIME / "ui/words.js").read_text()


def test_panels_speak_the_language_of_the_page(stage: Tab, tmp_path: Path, serve: Serve) -> None:
    page = tmp_path / "index.html"
    page.write_text(page.read_text().replace('lang="en"', 'lang="de-AT"'))
    stage.reload()
    stage.wait_for_selector("body[data-ready]")
    panel = show(stage, "topics")
    expect(panel).to_contain_text("Verborgene zeigen")
    expect(panel).to_contain_text("Gerade kein Topic. Sie kommen, wenn Nodes starten.")
    chatter(stage)
    panel.get_by_role("button", name="/chatter").click()
    expect(panel.get_by_role("button", name="Pause")).to_be_visible()
    expect(panel).to_contain_text("Noch keine Nachricht")
    stage.evaluate("unmount()")
    panel = show(stage, "services")
    add(stage, "service", "/adder", "/add", "tutorial_interfaces/srv/AddTwoInts")
    panel.get_by_role("button", name="/add").click()
    panel.get_by_label("a int64").fill("x")
    panel.get_by_role("button", name="Aufrufen").click()
    expect(panel).to_contain_text("„x“ ist keine ganze Zahl")


def test_other_languages_fall_back_to_english(stage: Tab, tmp_path: Path) -> None:
    page = tmp_path / "index.html"
    page.write_text(page.read_text().replace('lang="en"', 'lang="fr"'))
    stage.reload()
    stage.wait_for_selector("body[data-ready]")
    expect(show(stage, "topics")).to_contain_text("No topics now. They appear when nodes start.")
