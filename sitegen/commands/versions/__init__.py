"""Versions of a site side by side, and the way to one of them."""
