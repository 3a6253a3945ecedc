"""Let pages join the native graph by the protocol "sitegen.1" (docs/gateway-protocol.md)."""

from sitegen.gateway.pages.session import run

__all__ = ["run"]
