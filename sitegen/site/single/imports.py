"""Find the imports of a theme's module, which are not in the module graph of esbuild."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from pygments.lexers.javascript import JavascriptLexer


class Specifier(NamedTuple):
    """The relative path in an import, and its position with quotes."""

    name: str
    start: int
    end: int


def imports(text: str) -> Iterator[Specifier]:
    """Yield the static imports of files of the site in a module."""
    before = ""
    for start, kind, value in JavascriptLexer().get_tokens_unprocessed(text):
        if kind[:1] == ("Comment",) or not value.strip():
            continue
        # No other syntax of JavaScript has one of these words followed by a string.
        if kind[:2] == ("Literal", "String") and before in ("from", "import") and value[1:2] == ".":
            yield Specifier(value[1:-1], start, start + len(value))
        before = value
