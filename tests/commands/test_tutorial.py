"""The tutorial does what it says: its files are written and its commands run, in their order."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from browser import Serve
from panel import Panel
from paths import ROOT
from playwright.sync_api import Page, expect

from sitegen.__main__ import main

TUTORIAL = ROOT / "docs" / "tutorial.md"
BLOCK = re.compile(r'^(```|~~~)(\w+)(?: title="([^"]+)")?\n(.*?)^\1$', re.MULTILINE | re.DOTALL)
# What goes on until Ctrl-C has tests of its own.
NOT_RUN = {"serve"}


def test_who_follows_the_tutorial_has_a_site(
    tmp_path: Path, serve: Serve, tab: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    commands = []
    for _, language, title, text in BLOCK.findall(TUTORIAL.read_text(encoding="utf-8")):
        if title:
            # Each replaces a file, or stands beside one.
            assert Path(title).parent.is_dir()
            Path(title).write_text(text, encoding="utf-8")
        for line in text.splitlines() if language == "sh" else ():
            command, *words = line.split("#")[0].split()
            if command == "cd":
                monkeypatch.chdir(words[0])
            elif command == "sitegen":
                commands.append(words[0])
                assert words[0] in NOT_RUN or main(words) == 0
    assert commands == ["new", "serve", "check", "build"]

    tab.goto(f"{serve(Path('dist'))}look/")
    Panel(tab, "talker").start()
    counter = Panel(tab, "counter")
    counter.start()
    counter.wait_for("so far, the last was 'Hello, world!")
    topics = tab.get_by_role("region", name="Topics")
    topics.scroll_into_view_if_needed()
    expect(topics).to_contain_text("data:")
