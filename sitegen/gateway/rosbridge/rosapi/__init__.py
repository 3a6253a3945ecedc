"""Answer the services of rosapi, which clients ask about the graph."""

from sitegen.gateway.rosbridge.rosapi.answer import PREFIX, answer, node_asked

__all__ = ["PREFIX", "answer", "node_asked"]
