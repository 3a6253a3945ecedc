"""Say which nodes and widgets of a page will not hear each other, as far as sources tell."""

from sitegen.commands.wiring.pages import warnings

__all__ = ["warnings"]
