"""Speak version 2 of the protocol of rosbridge."""

from sitegen.gateway.rosbridge.run import run

__all__ = ["run"]
