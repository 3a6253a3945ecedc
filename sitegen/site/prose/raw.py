"""Find HTML in Markdown that the page's policy would block silently."""

from __future__ import annotations

import re
from collections.abc import Iterator

# Most pages contain none of these words; a page that does may use them in its text.
_SUSPECT = re.compile(r"<(?:script|style|object|embed|form|base|meta|link)\b|\s(?:on\w+|style)\s*=")
_TAG = re.compile(r"""<([a-z][\w-]*)((?:[^>"']|"[^"]*"|'[^']*')*)>""", re.IGNORECASE)
_ATTRIBUTE = re.compile(r"""\s([\w:-]+)\s*=\s*(?:"[^"]*"|'[^']*'|[^\s"'>]+)""")

REFUSED = {
    "script": "pages cannot run their own scripts; use a widget",
    "style": "pages cannot have their own styles; use a class, and put the rules in a theme",
    "object": "pages cannot embed other documents; link to the file",
    "embed": "pages cannot embed other documents; link to the file",
    "form": "pages cannot submit forms; remove the form",
    "base": "it would change every link of the page; remove it",
    "meta": "it belongs in the theme; remove it",
    "link": "it belongs in the theme; remove it",
}


def refused(text: str) -> Iterator[tuple[str, str]]:
    """Yield what the page's policy blocks in `text`, HTML: the code as written, and the reason."""
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
