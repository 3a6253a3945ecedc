"""The dialect of Markdown: the extensions of Python-Markdown that pages may use."""

from __future__ import annotations

import functools
import re
from collections.abc import Callable
from typing import NamedTuple

import markdown
from markdown.extensions import Extension
from markdown.extensions.admonition import AdmonitionExtension
from markdown.extensions.attr_list import AttrListExtension
from markdown.extensions.def_list import DefListExtension
from markdown.extensions.footnotes import FootnoteExtension
from markdown.extensions.md_in_html import MarkdownInHtmlExtension
from markdown.extensions.sane_lists import SaneListExtension
from markdown.extensions.tables import TableExtension
from pymdownx.arithmatex import ArithmatexExtension
from pymdownx.details import DetailsExtension
from pymdownx.quotes import QuotesExtension
from pymdownx.superfences import SuperFencesCodeExtension
from pymdownx.tabbed import TabbedExtension
from pymdownx.tasklist import TasklistExtension
from pymdownx.tilde import DeleteSubExtension

from sitegen.site.prose.fences import FENCES


class Syntax(NamedTuple):
    """An extension, and what every text that needs it contains; each extension costs time."""

    made: Callable[[], Extension]
    sign: re.Pattern[str]


def _syntax(sign: str, made: Callable[[], Extension]) -> Syntax:
    return Syntax(made, re.compile(sign, re.MULTILINE))


EXTENSIONS = (
    # ``` fences, in lists and tabs too; `mermaid` fences are diagrams.
    _syntax(r"```|~~~", lambda: SuperFencesCodeExtension(custom_fences=FENCES)),
    # !!! note, ??? note (folded), > [!NOTE] as on GitHub.
    _syntax(r"!!!", AdmonitionExtension),
    _syntax(r"\?\?\?", DetailsExtension),
    _syntax(r"> ?\[!", lambda: QuotesExtension(callouts=True)),
    # === "Tab"
    _syntax(r"=== ?", lambda: TabbedExtension(alternate_style=True)),
    # $x$, $$x$$, \(x\), \[x\]
    _syntax(r"\$|\\[(\[]|\\begin", lambda: ArithmatexExtension(generic=True)),
    # | a | b |; the page's policy forbids the style attributes that tables align with otherwise.
    _syntax(r"\|", lambda: TableExtension(use_align_attribute=True)),
    # [^1]
    _syntax(r"\[\^", FootnoteExtension),
    # - [ ] and - [x]
    _syntax(r"\[[ xX]\]", TasklistExtension),
    # {#id .class width=300}
    _syntax(r"\{[:\s]*[#.\w]", AttrListExtension),
    # term, and a line that begins with a colon
    _syntax(r"^ {0,3}:", DefListExtension),
    # ~~deleted~~
    _syntax(r"~~", lambda: DeleteSubExtension(subscript=False)),
    # <div markdown="1">
    _syntax(r"markdown=", MarkdownInHtmlExtension),
    # A list of numbers after one of dots is another list.
    _syntax(r"^\s*([-*+]|\d+\.) ", SaneListExtension),
)


# Patterns of Python-Markdown itself that few texts need, with what such texts contain. Each pattern
# is tried at every character, which is most of the time that a page takes.
PATTERNS = {
    ("reference", "image_reference", "short_reference", "short_image_ref"): re.compile(r"\]:"),
    ("autolink", "automail", "html"): re.compile("<"),
    ("image_link",): re.compile(r"!\["),
    ("escape",): re.compile(r"\\"),
    ("entity",): re.compile("&"),
    ("linebreak",): re.compile("  \n"),
}


def converter(text: str) -> markdown.Markdown:
    """Return a converter with the extensions that `text` needs."""
    signs = (*(syntax.sign for syntax in EXTENSIONS), *PATTERNS.values())
    return _converter(tuple(bool(sign.search(text)) for sign in signs)).reset()


@functools.cache
def _converter(needed: tuple[bool, ...]) -> markdown.Markdown:
    made = [syntax.made() for syntax, need in zip(EXTENSIONS, needed, strict=False) if need]
    converter = markdown.Markdown(output_format="html", extensions=made)
    for names, need in zip(PATTERNS, needed[len(EXTENSIONS) :], strict=True):
        for name in () if need else names:
            converter.inlinePatterns.deregister(name)
    return converter
