"""Turn the Markdown of a page into HTML whose links work in the site, and find its files."""

from sitegen.site.prose.highlight import code, language_of
from sitegen.site.prose.links import Anchor, Library, address
from sitegen.site.prose.media import lasting_name, resourced
from sitegen.site.prose.text import Heading, Prose, plain, without_text

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
    "resourced",
    "without_text",
]
