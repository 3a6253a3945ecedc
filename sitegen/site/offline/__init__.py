"""Write the service worker of a site that works without a network."""

from sitegen.site.offline.worker import RETIRED, artifacts

__all__ = ["RETIRED", "artifacts"]
