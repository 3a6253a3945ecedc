"""The bags that pages play: found, converted, and shown in panels that suit them."""

from sitegen.site.bags.played import Bags, bags, convert
from sitegen.site.bags.views import with_views

__all__ = ["Bags", "bags", "convert", "with_views"]
