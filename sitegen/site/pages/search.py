"""Write the index that the page searches: an index of MiniSearch, one for each language.

The format is MiniSearch's own (serializationVersion 2), so that the browser only has to load it.
"""

from __future__ import annotations

import html
import json
import re
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from sitegen.model import Artifact, Page, Site
from sitegen.site.prose import plain

# As searchIndex.js splits what a visitor asks for.
WORD = re.compile(r"[^\W_]+")
FIELDS = ("title", "heading", "text")
EXCERPT = 160
_PART = re.compile(r'<h[1-6](?=[^>]*\sid="([^"]+)")[^>]*>(.*?)</h[1-6]>', re.DOTALL)
_NOT_SAID = re.compile(r"<(math|svg)\b.*?</\1>", re.DOTALL)


class Passage(NamedTuple):
    """A stretch of a page that a search can find: the id of its heading, that heading, its text."""

    id: str
    heading: str
    text: str


def wanted(site: Site) -> bool:
    """Return whether there is anything to search: more than one page."""
    return len(site.pages) > 1


def path(language: str) -> str:
    """Return where the index of a language is in `dist/`."""
    return f"search.{language.lower()}.json"


def passages(page: Page, texts: Iterable[str]) -> Iterator[Passage]:
    """Yield the passages of a page: one for each heading, and the text before the first one."""
    _, *rest = pieces = _PART.split(_NOT_SAID.sub(" ", "\n".join(texts)))
    before = plain(pieces[0])
    if before or not rest:
        yield Passage("", page.title, before)
    for name, heading, text in zip(rest[::3], rest[1::3], rest[2::3], strict=True):
        yield Passage(html.unescape(name), plain(heading), plain(text))


def artifacts(site: Site, found: Iterable[tuple[Page, Sequence[Passage]]]) -> list[Artifact]:
    """Return an index for each language that a site has pages in, of their passages."""
    if not wanted(site):
        return []
    by_language: dict[str, list[tuple[Page, Passage]]] = {}
    for page, its_passages in found:
        rows = by_language.setdefault(page.language or site.language, [])
        rows += ((page, section) for section in its_passages)
    return [Artifact(path(language), _index(rows)) for language, rows in by_language.items()]


def _index(rows: Iterable[tuple[Page, Passage]]) -> bytes:
    terms: dict[str, dict[int, dict[int, int]]] = {}
    ids: dict[int, str] = {}
    lengths: dict[int, list[int]] = {}
    stored: dict[int, dict[str, str]] = {}
    for number, (page, section) in enumerate(rows):
        href = page.path + (f"#{section.id}" if section.id else "")
        ids[number] = href
        heading = "" if section.heading == page.title else section.heading
        shown = {"href": href, "title": page.title, "excerpt": _excerpt(section.text)}
        stored[number] = {**shown, **({"heading": heading} if heading else {})}
        lengths[number] = []
        # A page's title counts where it begins only, or all its passages would come first.
        title = page.title if not heading else ""
        for field, text in enumerate((title, heading, section.text)):
            words = WORD.findall(text.lower())
            lengths[number].append(len(set(words)))
            for word in words:
                counts = terms.setdefault(word, {}).setdefault(field, {})
                counts[number] = counts.get(number, 0) + 1
    count = len(ids)
    averages = [sum(row[field] for row in lengths.values()) / max(count, 1) for field in range(3)]
    index = {
        "documentCount": count,
        "nextId": count,
        "documentIds": ids,
        "fieldIds": {name: number for number, name in enumerate(FIELDS)},
        "fieldLength": lengths,
        "averageFieldLength": averages,
        "storedFields": stored,
        "dirtCount": 0,
        "index": [[word, terms[word]] for word in sorted(terms)],
        "serializationVersion": 2,
    }
    return json.dumps(index, separators=(",", ":"), ensure_ascii=False).encode()


def _excerpt(text: str) -> str:
    if len(text) <= EXCERPT:
        return text
    return text[:EXCERPT].rpartition(" ")[0] + " …"
