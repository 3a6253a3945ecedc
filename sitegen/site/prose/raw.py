"""Find HTML in Markdown that the page's policy would block silently."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

# Most pages have neither tags of their author nor any of these words, and reading HTML as browsers
# do takes its time. Attributes can also come from `{: onclick="…" }` in Markdown.
_TAG = re.compile(r"<[a-z]", re.IGNORECASE)
_SUSPECT = re.compile(r"[\s/\"'](?:on\w+|style)\s*=", re.IGNORECASE)
# Browsers ignore these characters in the scheme of an address.
_IGNORED = re.compile(r"[\x00-\x20]")
_SCRIPT = re.compile(r"(?:javascript|vbscript):", re.IGNORECASE)
# Their tags act on the page itself, wherever they are.
_PAGE = re.compile(r"<(html|head|body|frameset)\b", re.IGNORECASE)

THEME = "it belongs in the theme; remove it"
NO_SCRIPTS = "pages cannot run their own scripts; use a widget"
NO_STYLES = "pages cannot have their own styles; use a class, and put the rules in a theme"
NO_DOCUMENTS = "pages cannot embed other documents; link to the file"
NO_FORMS = "pages cannot submit forms; remove it"
TAGS = {
    "script": NO_SCRIPTS,
    "style": NO_STYLES,
    "object": NO_DOCUMENTS,
    "embed": NO_DOCUMENTS,
    "form": NO_FORMS,
    "base": "it would change every link of the page; remove it",
    "meta": THEME,
    "link": THEME,
    "title": THEME,
}
ATTRIBUTES = {
    "style": NO_STYLES,
    "formaction": NO_FORMS,
    "ping": "pages send nothing to other sites; remove it",
    "srcdoc": NO_DOCUMENTS,
}
# The addresses that links.py checks, with the tags that text.py finds them in.
LINKED = {
    *(("img", "srcset"), ("source", "srcset")),
    *((tag, "src") for tag in ("img", "source", "video", "audio", "track", "iframe")),
    *(("a", "href"), ("video", "poster")),
}


def refused(text: str, source: str) -> Iterator[tuple[str, str]]:
    """Yield what the page's policy blocks in `text`, HTML: the code as written, and the reason.

    `source` is the Markdown that became `text`.
    """
    if not _TAG.search(source) and not _SUSPECT.search(text):
        return
    for tag in _PAGE.finditer(text):
        yield tag[0], f"'<{tag[1].lower()}>' is not allowed: {THEME}"
    for element in _elements(text):
        name = _local(element.tag)
        if name in TAGS and not (name == "title" and element.tag.startswith("{")):
            yield _written(rf"<{name}\b", text), f"'<{name}>' is not allowed: {TAGS[name]}"
        for key, value in element.attrib.items():
            attribute = _local(key)
            shown = _written(rf"\b{re.escape(attribute)}\s*=", text)
            if why := ATTRIBUTES.get(attribute) or (attribute.startswith("on") and NO_SCRIPTS):
                yield shown, f"'{shown.rstrip(' =')}=' is not allowed: {why}"
            elif (name, key) not in LINKED and _SCRIPT.match(_IGNORED.sub("", value)):
                yield value, f"'{attribute}' cannot run a script; use a widget"


def _elements(text: str) -> Iterator[Any]:
    # Only pages with HTML of their author need it.
    import html5lib

    tree = html5lib.parseFragment(text, namespaceHTMLElements=False)
    return (element for element in tree.iter() if isinstance(element.tag, str))


def _local(name: str) -> str:
    return name.rpartition("}")[2].lower()


def _written(pattern: str, text: str) -> str:
    found = re.search(pattern, text, re.IGNORECASE)
    return found[0] if found else ""
