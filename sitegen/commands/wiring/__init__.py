"""Find nodes and widgets of a page that cannot communicate, as far as sources tell."""

from sitegen.commands.wiring.pages import warnings

__all__ = ["warnings"]
