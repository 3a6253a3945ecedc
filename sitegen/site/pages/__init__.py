"""Turn the Site's pages into HTML, one page.json for each that runs nodes, and their files."""

from sitegen.site.pages.render import Rendered, Renderer, render

__all__ = ["Rendered", "Renderer", "render"]
