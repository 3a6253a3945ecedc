"""Panels of the author: ES modules of the site that are mounted like widgets."""

from sitegen.site.ownpanels.cells import cell_modules
from sitegen.site.ownpanels.files import KIND, ROSLIB, OwnPanels, own_panels, uses_client

__all__ = ["KIND", "ROSLIB", "OwnPanels", "cell_modules", "own_panels", "uses_client"]
