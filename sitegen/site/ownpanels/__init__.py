"""Panels of the author: ES modules of the site that are mounted like widgets."""

from sitegen.site.ownpanels.files import KIND, OwnPanels, own_panels, uses_client

__all__ = ["KIND", "OwnPanels", "own_panels", "uses_client"]
