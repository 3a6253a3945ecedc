"""What rosapi tells of the graph: topics, services, actions and nodes that the client may use."""

from __future__ import annotations

import re
import time
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from sitegen.gateway.names import PROTECTED, Use, refusal, subject
from sitegen.gateway.native import Endpoint
from sitegen.gateway.rosbridge.typenames import full

if TYPE_CHECKING:
    from sitegen.gateway.rosbridge.session import Session

Response = dict[str, Any]
# Names with a token that begins with "_" are those of ROS itself.
HIDDEN = re.compile(r"/_")
SEND = "/_action/send_goal"


async def _topics(session: Session, _: Any) -> Response:
    found = await _named(session, ("publisher", "subscription"))
    return {"topics": list(found), "types": list(found.values())}


async def _topics_for_type(session: Session, args: Any) -> Response:
    wanted = full(args["type"], "msg")
    found = await _named(session, ("publisher", "subscription"))
    return {"topics": [name for name, kind in found.items() if kind == wanted]}


async def _services(session: Session, _: Any) -> Response:
    return {"services": list(await _named(session, ("service",)))}


async def _services_for_type(session: Session, args: Any) -> Response:
    wanted = full(args["type"], "srv")
    found = await _named(session, ("service",))
    return {"services": [name for name, kind in found.items() if kind == wanted]}


async def _action_servers(session: Session, _: Any) -> Response:
    return {"action_servers": list(await _actions(session))}


async def _action_type(session: Session, args: Any) -> Response:
    return {"type": (await _actions(session)).get(_absolute(args["action"]), "")}


async def _nodes(session: Session, _: Any) -> Response:
    found = await _endpoints(session)
    return {"nodes": sorted({one.node for one in found if not HIDDEN.search(one.node)})}


async def _node_details(session: Session, args: Any) -> Response:
    found = await _endpoints(session)
    node = _absolute(args["node"])

    def names(kind: str) -> list[str]:
        return sorted({one.name for one in found if one.node == node and one.kind == kind})

    return {
        "subscribing": names("subscription"),
        "publishing": names("publisher"),
        "services": names("service"),
    }


async def _topic_type(session: Session, args: Any) -> Response:
    found = await _named(session, ("publisher", "subscription"), hidden=True)
    return {"type": found.get(_absolute(args["topic"]), "")}


async def _service_type(session: Session, args: Any) -> Response:
    found = await _named(session, ("service",), hidden=True)
    return {"type": found.get(_absolute(args["service"]), "")}


async def _publishers(session: Session, args: Any) -> Response:
    return {"publishers": await _of(session, "publisher", args["topic"])}


async def _subscribers(session: Session, args: Any) -> Response:
    return {"subscribers": await _of(session, "subscription", args["topic"])}


async def _service_node(session: Session, args: Any) -> Response:
    return {"node": next(iter(await _of(session, "service", args["service"])), "")}


async def _service_providers(session: Session, args: Any) -> Response:
    wanted = full(args["service"], "srv")
    found = await _endpoints(session)
    nodes = {one.node for one in found if one.kind == "service" and one.type == wanted}
    return {"providers": sorted(nodes)}


async def _time(session: Session, _: Any) -> Response:
    seconds, nanoseconds = divmod(time.time_ns(), 10**9)
    return {"time": {"sec": seconds, "nanosec": nanoseconds}}


async def _version(session: Session, _: Any) -> Response:
    return {"version": 2, "distro": session.native.distribution}


async def _endpoints(session: Session) -> list[Endpoint]:
    """Return the endpoints of the graph as it is now that the client may know of."""
    await session.native.refresh()
    return [
        one
        for one in session.native.endpoints
        if not PROTECTED.search(one.node) and (one.kind == "node" or _known(session, one))
    ]


def _known(session: Session, endpoint: Endpoint) -> bool:
    """Return whether the client may use it in some way; nothing is logged."""
    uses: dict[str, tuple[Use, ...]] = {
        "service": ("call_services",),
        "client": ("advertise_services",),
    }
    allow = session.access.rules.allow
    for use in uses.get(endpoint.kind, ("subscribe", "publish")):
        meant, name = subject(use, endpoint.name)
        if not refusal(meant, name, None if allow is None else allow.get(meant, ())):
            return True
    return endpoint.owner == session.party.owner


async def _named(session: Session, kinds: Iterable[str], *, hidden: bool = False) -> dict[str, str]:
    found = await _endpoints(session)
    return {
        one.name: one.type
        for one in sorted(found, key=lambda one: one.name)
        if one.kind in kinds and (hidden or not HIDDEN.search(one.name))
    }


async def _actions(session: Session) -> dict[str, str]:
    found = await _named(session, ("service",), hidden=True)
    return {
        name.removesuffix(SEND): kind.removesuffix("_SendGoal")
        for name, kind in found.items()
        if name.endswith(SEND)
    }


async def _of(session: Session, kind: str, name: str) -> list[str]:
    found = await _endpoints(session)
    wanted = _absolute(name)
    return sorted({one.node for one in found if one.kind == kind and one.name == wanted})


def _absolute(name: object) -> str:
    return str(name) if str(name).startswith("/") else f"/{name}"


ANSWERS = {
    "topics": _topics,
    "topics_for_type": _topics_for_type,
    "services": _services,
    "services_for_type": _services_for_type,
    "action_servers": _action_servers,
    "action_type": _action_type,
    "nodes": _nodes,
    "node_details": _node_details,
    "topic_type": _topic_type,
    "service_type": _service_type,
    "publishers": _publishers,
    "subscribers": _subscribers,
    "service_node": _service_node,
    "service_providers": _service_providers,
    "get_time": _time,
    "get_ros_version": _version,
}
