"""Put JupyterLab into a site, with the notebooks of its pages."""

from sitegen.site.jupyter.lab import artifacts

__all__ = ["artifacts"]
