"""Find the imports of modules that are not in the module graph of esbuild."""

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


def references(text: str) -> Iterator[Specifier]:
    """Yield all names of files of the site in a module of an author's panel."""
    # Only sites with such a panel need the parser.
    from sitegen.site.ownpanels.module import parsed

    source = text.encode()
    for one in parsed(source).references:
        if one.name.startswith("."):
            # An offset in bytes is one in the text before which all is decoded.
            start, end = (len(source[:at].decode()) for at in (one.start, one.end))
            yield Specifier(one.name, start, end)
