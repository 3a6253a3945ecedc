"""Turn the pages of a Site into HTML, a page.json for each page with nodes, and other files."""

from sitegen.site.pages.render import Rendered, Renderer, render

__all__ = ["Rendered", "Renderer", "render"]
