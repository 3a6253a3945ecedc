"""Turn one page of a site into one HTML file that needs no server."""

from sitegen.site.single.bundle import packed_size
from sitegen.site.single.page import HELD, single_file

__all__ = ["HELD", "packed_size", "single_file"]
