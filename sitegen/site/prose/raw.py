"""Find HTML of the author that the page's policy would stop without a word."""

from __future__ import annotations

import re
from collections.abc import Iterator

# Most pages have none of these; the words may stand in the text as well.
_SUSPECT = re.compile(r"<(?:script|style|object|embed|form|base|meta|link)\b|\s(?:on\w+|style)\s*=")
_TAG = re.compile(r"""<([a-z][\w-]*)((?:[^>"']|"[^"]*"|'[^']*')*)>""", re.IGNORECASE)
_ATTRIBUTE = re.compile(r"""\s([\w:-]+)\s*=\s*(?:"[^"]*"|'[^']*'|[^\s"'>]+)""")

REFUSED = {
    "script": "a page runs no script of its own; write a widget",
    "style": "a page has no style of its own; give it a class, and put the rules into a theme",
    "object": "a page embeds nothing; link to the file",
    "embed": "a page embeds nothing; link to the file",
    "form": "a page sends nothing anywhere; leave the form out",
    "base": "it would change every link of the page; leave it out",
    "meta": "it belongs into the theme; leave it out",
    "link": "it belongs into the theme; leave it out",
}


def refused(text: str) -> Iterator[tuple[str, str]]:
    """Yield what the policy of the page stops in `text`, HTML: as written, and why."""
    if not _SUSPECT.search(text):
        return
    for tag in _TAG.finditer(text):
        name = tag[1].lower()
        if name in REFUSED:
            yield f"<{tag[1]}", f"'<{name}>' is not allowed: {REFUSED[name]}"
        for attribute in _ATTRIBUTE.findall(tag[2]):
            if attribute.lower() == "style":
                yield f"{attribute}=", f"'style=' is not allowed: {REFUSED['style']}"
            elif attribute.lower().startswith("on"):
                yield attribute, f"'{attribute}=' is not allowed: {REFUSED['script']}"
