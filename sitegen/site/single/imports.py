"""Find what a module of a theme imports, whose graph esbuild does not know."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from pygments.lexers.javascript import JavascriptLexer


class Specifier(NamedTuple):
    """The relative path of an import, and where it is written, with its quotes."""

    name: str
    start: int
    end: int


def imports(text: str) -> Iterator[Specifier]:
    """Yield the static imports of a module that name a file of the site."""
    before = ""
    for start, kind, value in JavascriptLexer().get_tokens_unprocessed(text):
        if kind[:1] == ("Comment",) or not value.strip():
            continue
        # Nothing else in the language is one of these words and a string.
        if kind[:2] == ("Literal", "String") and before in ("from", "import") and value[1:2] == ".":
            yield Specifier(value[1:-1], start, start + len(value))
        before = value
