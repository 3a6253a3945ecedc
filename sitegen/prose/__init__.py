"""Turn a page's Markdown into HTML whose links work in the site, and name the files it needs."""

from sitegen.prose.highlight import code, language_of
from sitegen.prose.links import Anchor, Library, address
from sitegen.prose.media import lasting_name
from sitegen.prose.text import Heading, Prose, plain, without_text

__all__ = [
    "Anchor",
    "Heading",
    "Library",
    "Prose",
    "address",
    "code",
    "language_of",
    "lasting_name",
    "plain",
    "without_text",
]
