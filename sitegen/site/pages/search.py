"""Write the search index in the format of MiniSearch, one for each language.

The format is that of MiniSearch (serializationVersion 2), so that browsers only have to load it.
"""

from __future__ import annotations

import html
import json
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from sitegen.model import Artifact, NavItem, Page, Site
from sitegen.site.prose import plain

# The same pattern as in searchIndex.js, which splits queries.
WORD = re.compile(r"[^\W_]+")
FIELDS = ("title", "heading", "text")
EXCERPT = 160
LEAST = 0.5
_PART = re.compile(r'<h[1-6](?=[^>]*\sid="([^"]+)")[^>]*>(.*?)</h[1-6]>', re.DOTALL)
_NOT_SAID = re.compile(r"<(math|svg)\b.*?</\1>", re.DOTALL)


class Passage(NamedTuple):
    """A section of a page that a search can find: its heading, the id of that, and its text."""

    id: str
    heading: str
    text: str


def wanted(site: Site) -> bool:
    """Return whether the site has a search: it has more than one page."""
    return len(site.pages) > 1


def path(language: str) -> str:
    """Return the path in `dist/` of the index of a language."""
    return f"search.{language.lower()}.json"


def passages(page: Page, texts: Iterable[str]) -> Iterator[Passage]:
    """Yield the passages of a page: one for each heading, and the text before the first heading."""
    _, *rest = pieces = _PART.split(_NOT_SAID.sub(" ", "\n".join(texts)))
    before = plain(pieces[0])
    if before or not rest:
        yield Passage("", page.title, before)
    for name, heading, text in zip(rest[::3], rest[1::3], rest[2::3], strict=True):
        yield Passage(html.unescape(name), plain(heading), plain(text))


def artifacts(site: Site, found: Iterable[tuple[Page, Sequence[Passage]]]) -> list[Artifact]:
    """Return an index of passages for each language of the site."""
    if not wanted(site):
        return []
    weights = _weights(site)
    by_language: dict[str, list[tuple[Page, Passage]]] = {}
    for page, its_passages in found:
        rows = by_language.setdefault(page.language or site.language, [])
        rows += ((page, section) for section in its_passages)
    return [
        Artifact(path(language), _index(rows, weights)) for language, rows in by_language.items()
    ]


def _weights(site: Site) -> Mapping[str, float]:
    """Return the weight of a match in each page, by the path of the original.

    Authors put first what readers need first, so weights follow the navigation: from 1 for the
    first page to LEAST for the last one and for pages that are not in it.
    """
    order = list(_listed(site.nav)) or [page.path for page in site.pages]
    step = (1 - LEAST) / max(len(order) - 1, 1)
    return {path: round(1 - number * step, 3) for number, path in enumerate(order)}


def _listed(items: Iterable[NavItem]) -> Iterator[str]:
    for item in items:
        if item.page is not None:
            yield item.page
        yield from _listed(item.inside)


def _index(rows: Iterable[tuple[Page, Passage]], weights: Mapping[str, float]) -> bytes:
    terms: dict[str, dict[int, dict[int, int]]] = {}
    ids: dict[int, str] = {}
    lengths: dict[int, list[int]] = {}
    stored: dict[int, dict[str, str | float]] = {}
    begun: set[str] = set()
    for number, (page, section) in enumerate(rows):
        href = page.path + (f"#{section.id}" if section.id else "")
        ids[number] = href
        heading = "" if section.heading == page.title else section.heading
        original = page.path if page.original is None else page.original
        shown = {"href": href, "title": page.title, "excerpt": _excerpt(section.text)}
        weight = weights.get(original, LEAST)
        stored[number] = {**shown, "weight": weight, **({"heading": heading} if heading else {})}
        lengths[number] = []
        # The title counts only for the first passage; otherwise all passages of the page would come
        # first.
        first = page.path not in begun
        title = page.title if first else ""
        begun.add(page.path)
        said = f"{page.description} {section.text}" if first else section.text
        for field, text in enumerate((title, heading, said)):
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
