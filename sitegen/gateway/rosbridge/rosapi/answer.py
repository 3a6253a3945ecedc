"""Find what answers a service of rosapi."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import TYPE_CHECKING, Any

from sitegen.gateway.rosbridge.operation import InvalidOperationError
from sitegen.gateway.rosbridge.rosapi import graph, parameters, turns, types

if TYPE_CHECKING:
    from sitegen.gateway.rosbridge.session import Session

PREFIX = ("/rosapi/", "/gateway/")
Answer = Callable[["Session", dict[str, Any]], Awaitable[dict[str, Any]]]
ANSWERS: dict[str, Answer] = {**graph.ANSWERS, **types.ANSWERS, **parameters.ANSWERS}
OWN: dict[str, Answer] = {"turn": turns.turn}


async def answer(session: Session, service: str, args: Any) -> dict[str, Any]:
    """Return the response of a service of rosapi, or of the gateway itself.

    Raises: InvalidOperationError if there is no such service, or an argument is missing.
    """
    _, place, verb = service.split("/", 2)
    found = (OWN if place == "gateway" else ANSWERS).get(verb)
    if found is None:
        raise InvalidOperationError(f"service {service} does not exist")
    if isinstance(args, list):
        args = dict(enumerate(args))
    return await found(session, Arguments(service, args if isinstance(args, dict) else {}))


def node_asked(args: Any) -> str:
    """Return the node that a request about parameters names, "" if it is about all nodes."""
    if not isinstance(args, dict):
        return ""
    given = str(args.get("name", ""))
    return parameters.node_of(f"{args['node_name']}:" if args.get("node_name") else given)


class Arguments(dict[Any, Any]):
    """The arguments of a call, by name; a list has them in their order."""

    def __init__(self, service: str, args: dict[Any, Any]) -> None:
        super().__init__(args)
        self._service = service

    def __missing__(self, name: str) -> Any:
        raise InvalidOperationError(f"{self._service} needs '{name}'")
