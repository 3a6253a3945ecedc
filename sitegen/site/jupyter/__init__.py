"""Put JupyterLab into a site, with the notebooks of its pages."""

from sitegen.site.jupyter.lab import artifacts
from sitegen.site.jupyter.pages import with_pages

__all__ = ["artifacts", "with_pages"]
