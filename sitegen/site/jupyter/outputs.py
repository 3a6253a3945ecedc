"""Turn the saved outputs of notebooks into HTML that pages allow."""

from __future__ import annotations

import html
import re
from collections.abc import Iterator, Mapping
from typing import Any

# As in ui/cleanHtml.js, which does the same for what cells show in the browser.
TAGS = {
    *("a", "abbr", "b", "blockquote", "br", "caption", "code", "col", "colgroup", "dd", "del"),
    *("details", "div", "dl", "dt", "em", "figcaption", "figure", "h1", "h2", "h3", "h4", "h5"),
    *("h6", "hr", "i", "img", "kbd", "li", "mark", "ol", "p", "pre", "q", "s", "samp", "small"),
    *("span", "strong", "sub", "summary", "sup", "table", "tbody", "td", "tfoot", "th"),
    *("thead", "tr", "u", "ul", "var"),
}
WHOLE = {
    *("button", "canvas", "embed", "form", "frame", "head", "iframe", "input", "link", "math"),
    *("meta", "noscript", "object", "script", "select", "style", "svg", "template", "textarea"),
    "title",
}
ATTRIBUTES = {"alt", "colspan", "height", "open", "rowspan", "scope", "start", "title", "width"}
LINK = re.compile(r"(https?:|mailto:)", re.I)
IMAGE = re.compile(r"data:image/(png|jpeg|gif|webp|svg\+xml)[;,]", re.I)
# Elements without content.
EMPTY = {"br", "col", "hr", "img"}
IMAGES = ("image/png", "image/jpeg", "image/svg+xml")
ESCAPES = re.compile(r"\x1b\[[\d;]*m")


def shown(output: Mapping[str, Any]) -> str:
    """Return an output, as config/ipynb.py reads it, as HTML in Markdown."""
    if output["kind"] != "value":
        return _text(str(output["text"]), str(output["kind"]))
    data = output["data"]
    plain = str(data.get("text/plain", ""))
    for kind in IMAGES:
        if kind in data:
            source = f"data:{kind};base64,{html.escape(data[kind])}"
            alt = html.escape(" ".join(plain.split()) or "output")
            return f'<div class="saved-output"><img src="{source}" alt="{alt}"></div>'
    if "text/html" in data:
        # A blank line would end the HTML for Markdown.
        inside = re.sub(r"\n\s*\n", "\n", clean(data["text/html"]))
        return f'<div class="saved-output">{inside}</div>'
    return _text(plain, "value")


def _text(text: str, kind: str) -> str:
    lines = html.escape(ESCAPES.sub("", text)).replace("\n", "&#10;")
    return f'<pre class="saved-output {kind}" tabindex="0">{lines}</pre>'


def clean(text: str) -> str:
    """Return the harmless parts of HTML: nothing in it loads, runs or submits anything."""
    # Only sites with notebooks need it.
    import html5lib

    tree = html5lib.parseFragment(text, namespaceHTMLElements=False)
    return "".join(_content(tree))


def _content(element: Any) -> Iterator[str]:
    yield html.escape(element.text or "", quote=False)
    for child in element:
        if isinstance(child.tag, str):
            yield from _element(child)
        yield html.escape(child.tail or "", quote=False)


def _element(element: Any) -> Iterator[str]:
    name = element.tag.rpartition("}")[2].lower()
    if name in WHOLE:
        return
    if name not in TAGS:
        yield from _content(element)
        return
    yield f"<{name}{''.join(_attributes(name, element.attrib))}>"
    if name not in EMPTY:
        yield from _content(element)
        yield f"</{name}>"


def _attributes(name: str, given: Mapping[Any, str]) -> Iterator[str]:
    for key, value in given.items():
        fits = key in ATTRIBUTES
        fits = fits or (name == "a" and key == "href" and bool(LINK.match(value)))
        fits = fits or (name == "img" and key == "src" and bool(IMAGE.match(value)))
        if fits:
            yield f' {key}="{html.escape(value)}"'
    if name == "a" and LINK.match(given.get("href", "")):
        yield ' rel="noopener noreferrer" target="_blank"'
