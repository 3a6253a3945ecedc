"""Turn site.yaml, and the Markdown that it names, into a Site."""

from sitegen.config.site import load

__all__ = ["load"]
