"""The characters in what visitors see: those that each system has a font for."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from paths import ROOT

# Latin letters with their signs, and what the fonts of all systems contain besides: a part of the
# Windows Glyph List 4. Icons are drawings.
COMMON = {
    *map(chr, (*range(0x20, 0x180), *range(0x2010, 0x2015), *range(0x2018, 0x203B))),
    *"\n\t€™∞−≈≠≤≥√←↑→↓",  # noqa: RUF001
}


def files() -> Iterator[Path]:
    for pattern in ("*.js", "*.css", "*.html"):
        yield from (ROOT / "themes").rglob(pattern)
    for file in (ROOT / "sitegen/runtime").rglob("*.js"):
        if "vendor" not in file.parts:
            yield file


def test_no_system_shows_an_empty_box() -> None:
    found = {file: set(file.read_text(encoding="utf-8")) - COMMON for file in files()}
    assert len(found) > 300
    assert {file: odd for file, odd in found.items() if odd} == {}
