"""Answer the services of rosapi, which clients ask about the graph."""

from sitegen.gateway.rosbridge.rosapi.answer import PREFIX, answer

__all__ = ["PREFIX", "answer"]
