"""Join the graphs of several gateways over Zenoh, in the way of rmw_zenoh.

    session = open_session(["robot"], "0.0.0.0", 7447, None)
    link = Link(native, session, rules, guard, write)
    await link.start(1)  # Nodes of peers are in the native graph now, and those of the graph there
    await link.close()

Only this package imports zenoh. Endpoints of peers become native ones (`peer.py`), as those of
pages do; native ones, also those of pages, are told as rmw_zenoh tells its own (`outbound.py`).
"""

from sitegen.gateway.zenoh.link import Link, check
from sitegen.gateway.zenoh.network import PORT, open_session

__all__ = ["PORT", "Link", "check", "open_session"]
