"""Turn the Markdown of one page into HTML."""

from __future__ import annotations

import html
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from markdown.extensions.toc import slugify_unicode

from sitegen.errors import Location, Problems
from sitegen.model import Markdown, Page
from sitegen.site.prose import raw
from sitegen.site.prose.extensions import converter
from sitegen.site.prose.fences import DIAGRAM
from sitegen.site.prose.links import Library, Links, line_of
from sitegen.site.prose.mathematics import FormulaError, formulas
from sitegen.site.prose.media import resourced, sized

# Every `<` in code is escaped, so these match real tags only, including raw HTML of the author.
_TAG = re.compile(
    r"""<(a|img|source|video|audio|track|iframe)\b(?:[^>"']|"[^"]*"|'[^']*')*>""", re.I
)
_ADDRESS = re.compile(
    r"""([\s/](?:href|src|poster)\s*=\s*)(?:(["'])(?P<quoted>.*?)\2|(?P<bare>[^\s"'>]+))""",
    re.I | re.S,
)
_SRCSET = re.compile(_ADDRESS.pattern.replace("href|src|poster", "srcset"), re.I | re.S)
# A heading, or the start of a table, which the heading above it names.
_HEADING = re.compile(r"<h([1-6])((?:\s[^>]*)?)>(.*?)</h\1>|<table\b", re.I | re.S)
_ID = re.compile(r"""\sid\s*=\s*["']?([^"'\s>]+)""", re.I)
# A checkbox, and the words that label it.
_TASK = re.compile(
    r'(<input type="checkbox" disabled(?: checked)?/>.*?)(?=<[uo]l|</li>|</p>)', re.S
)
# The title of an admonition whose title is its kind.
_TITLE = re.compile(r'(<p class="admonition-title">|<summary>)(\w+)(</p>|</summary>)')
_SRC = re.compile(r"""\ssrc\s*=\s*(["'])(.*?)\1""", re.I | re.S)
_ALT = re.compile(r"""\salt\s*=\s*(?:(["'])(?P<text>.*?)\1|\S+)""", re.I | re.S)
_MARKUP = re.compile(r"<[^>]*>")
_KEYS = {"a": "link", "img": "image", "iframe": "frame"}


class Heading(NamedTuple):
    """A heading of a page: its level from 1, its id, its text."""

    level: int
    id: str
    title: str


@dataclass
class Prose:
    """The Markdown of one page, converted part by part, with ids that are unique in the page.

    `titles` are the default titles of admonitions by kind, in the page's language.
    """

    library: Library
    page: Page
    problems: Problems
    titles: Mapping[str, str] = field(default_factory=dict)
    headings: list[Heading] = field(default_factory=list)
    ids: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        self.links = Links(self.library, self.page, self.problems)
        self._part = 0

    def html(self, source: Markdown) -> str:
        """Return `source` as HTML."""
        self._part += 1
        try:
            text = converter(source.text).convert(source.text)
        except RecursionError:
            self.problems.add(source.location, "markdown", "nested too deeply; flatten it")
            return ""
        self._check(text, source)
        text = self._drawn(text, source)
        text = self._apart(text)
        text = _TITLE.sub(self._title, text) if self.titles else text
        text = _TAG.sub(lambda tag: self._tag(tag, source), text)
        text = _HEADING.sub(self._heading, text)
        text = _TASK.sub(r"<label>\1</label>", text) if "task-list" in text else text
        text = text.replace("</table>", "</table></div>")
        self.ids.update(_ID.findall(text))
        return text

    def _check(self, text: str, source: Markdown) -> None:
        for written, why in raw.refused(text, source.text):
            self.problems.add(line_of(source, written), "html", why)

    def _drawn(self, text: str, source: Markdown) -> str:
        """Return `text` with its formulas and diagrams rendered."""
        wrong: list[FormulaError] = []
        if 'class="arithmatex"' in text:
            text = formulas(text, wrong)
        for each in wrong:
            first = each.formula.strip().split("\n")[0]
            self.problems.add(line_of(source, first), "formula", f"{each}; write it as TeX does")
        if 'class="mermaid"' in text:
            text = DIAGRAM.sub(lambda found: self._diagram(html.unescape(found[1]), source), text)
        return text

    def _diagram(self, written: str, source: Markdown) -> str:
        # Most sites have none.
        from sitegen.site.prose.diagrams import DiagramError, drawn

        try:
            return drawn(written)
        except DiagramError as error:
            self.problems.add(line_of(source, error.line), "mermaid", str(error))
            return ""

    def _apart(self, text: str) -> str:
        """Return `text` with the ids of extensions made different from those of other parts."""
        if "__tabbed_" in text:
            text = text.replace("__tabbed_", f"tab_{self._part}_")
        if self._part > 1 and 'class="footnote' in text:
            text = re.sub(r'(id="|href="#)(fn|fnref)(?=\d*:)', rf"\g<1>\g<2>{self._part}-", text)
        return text

    def _heading(self, found: re.Match[str]) -> str:
        if found[1] is None:
            # It may be wider than the page, and who has no mouse scrolls what has the focus.
            name = self.headings[-1].title if self.headings else self.page.title
            label = html.escape(name)
            return f'<div class="table" role="group" aria-label="{label}" tabindex="0">{found[0]}'
        level, attributes, inner = int(found[1]), found[2], found[3]
        title = plain(inner)
        given = _ID.search(attributes)
        name = given[1] if given else _slug(title, self.ids)
        self.ids.add(name)
        self.headings.append(Heading(level, name, title))
        attributes = attributes if given else f' id="{html.escape(name)}"{attributes}'
        # The table of contents is for the keyboard; this link is for copying the address.
        link = f'<a class="anchor" href="#{name}" aria-hidden="true" tabindex="-1"></a>'
        link = link if 1 < level < 5 else ""
        return f"<h{level}{attributes}>{inner}{link}</h{level}>"

    def _title(self, found: re.Match[str]) -> str:
        return found[1] + self.titles.get(found[2].lower(), found[2]) + found[3]

    def _tag(self, tag: re.Match[str], source: Markdown) -> str:
        name, image = tag[1].lower(), None
        key = _KEYS.get(name, "media")

        def rewrite(found: re.Match[str]) -> str:
            nonlocal image
            url = found["bare"] if found["quoted"] is None else found["quoted"]
            new, file = self.links.resolve(html.unescape(url), key, source)
            image = image or file
            return found[0] if new is None else f'{found[1]}"{html.escape(new)}"'

        def picture(url: str) -> str:
            return self.links.resolve(url, "image", source)[0] or url

        def rewrite_all(found: re.Match[str]) -> str:
            urls = found["bare"] if found["quoted"] is None else found["quoted"]
            return f'{found[1]}"{html.escape(resourced(html.unescape(urls), picture))}"'

        written = _ADDRESS.sub(rewrite, tag[0])
        written = _SRCSET.sub(rewrite_all, written) if name in ("img", "source") else written
        return sized(written, image) if name == "img" and image else written


def without_text(source: Markdown) -> Iterator[tuple[str, Location]]:
    """Yield the images of `source` without alternative text, with their locations.

    An explicit `alt=""` in HTML marks an image as decorative.
    """
    for tag in _TAG.finditer(converter(source.text).convert(source.text)):
        if tag[1].lower() != "img":
            continue
        alt, address = _ALT.search(tag[0]), _SRC.search(tag[0])
        meant = alt and (alt["text"] != "" or tag[0] in source.text)
        if not meant:
            url = html.unescape(address[2]) if address else tag[0]
            yield url, line_of(source, url)


def plain(text: str) -> str:
    """Return the text of HTML without its tags."""
    return " ".join(html.unescape(_MARKUP.sub("", text)).split())


def _slug(title: str, taken: set[str]) -> str:
    """Return an id for a heading in the style of other generators: `über-uns`, `über-uns_1`."""
    slug = name = slugify_unicode(title, "-") or "section"
    number = 0
    while name in taken:
        number += 1
        name = f"{slug}_{number}"
    return name
