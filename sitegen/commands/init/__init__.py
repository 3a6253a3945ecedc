"""Write a site.yaml for a workspace: what can run, on which pages, with which panels."""

from sitegen.commands.init.command import init

__all__ = ["init"]
