"""What rosapi tells of parameters, and how it sets them.

They are named "/node:parameter". A name alone means the node that has such a parameter.
"""

from __future__ import annotations

import asyncio
import json
from collections.abc import Awaitable, Callable, Iterable
from typing import TYPE_CHECKING, Any

from sitegen.gateway.asking import NoAnswerError
from sitegen.gateway.names import Use, refusal
from sitegen.gateway.native import NativeError, from_cdr, load_type, to_cdr
from sitegen.gateway.rosbridge.decode import from_json
from sitegen.gateway.rosbridge.encode import to_json
from sitegen.gateway.rosbridge.operation import InvalidOperationError

if TYPE_CHECKING:
    from sitegen.gateway.rosbridge.session import Session

Response = dict[str, Any]
# How long a node may take (s).
TIMEOUT = 5.0
NOT_SET = 0
# By the number of its type: the field of a value.
FIELDS = {
    1: "bool_value",
    2: "integer_value",
    3: "double_value",
    4: "string_value",
    5: "byte_array_value",
    6: "bool_array_value",
    7: "integer_array_value",
    8: "double_array_value",
    9: "string_array_value",
}


async def _get(session: Session, args: Any) -> Response:
    default = args.get("default_value", args.get("default", ""))
    if not isinstance(default, str):
        raise InvalidOperationError("'default_value' must be JSON in text")
    try:
        node, name = await _find(session, "get_parameters", args["name"])
        value = await _value(session, node, name)
    except (InvalidOperationError, NativeError) as error:
        return {"value": default or "null", "successful": False, "reason": str(error)}
    if value is None:
        reason = f"{node} has no parameter '{name}'"
        return {"value": default or "null", "successful": False, "reason": reason}
    return {"value": json.dumps(value), "successful": True, "reason": ""}


async def _set(session: Session, args: Any) -> Response:
    try:
        node, name = await _find(session, "set_parameters", args["name"])
        try:
            value = json.loads(args["value"]) if isinstance(args["value"], str) else args["value"]
        except ValueError:
            raise InvalidOperationError("'value' must be JSON") from None
        # A whole number may be meant for a parameter that is none.
        present = await _value(session, node, name)
        if isinstance(present, float) and isinstance(value, int) and not isinstance(value, bool):
            value = float(value)
        result = await _change(session, node, name, _typed(value))
    except (InvalidOperationError, NativeError) as error:
        return {"successful": False, "reason": str(error)}
    return result


async def _has(session: Session, args: Any) -> Response:
    try:
        node, name = await _find(session, "get_parameters", args["name"])
        return {"exists": await _value(session, node, name) is not None}
    except (InvalidOperationError, NativeError):
        return {"exists": False}


async def _delete(session: Session, args: Any) -> Response:
    try:
        given = args["name"]
        name = f"{args['node_name']}:{given}" if args.get("node_name") else given
        node, name = await _find(session, "set_parameters", name)
        return await _change(session, node, name, {"type": NOT_SET})
    except (InvalidOperationError, NativeError) as error:
        return {"successful": False, "reason": str(error)}


async def _names(session: Session, _: Any) -> Response:
    async def ask(node: str) -> list[str]:
        response = await _call(session, node, "ListParameters", {"depth": 0})
        return [f"{node}:{name}" for name in response["result"]["names"]]

    listed = await _asked(session, await _nodes(session), ask)
    names = [name for each in listed.values() for name in each]
    allowed = _allowed(session, "get_parameters")
    return {"names": [name for name in names if not refusal("get_parameters", name, allowed)]}


async def _nodes(session: Session) -> list[str]:
    """Return the nodes that have parameters."""
    await session.native.refresh()
    return sorted(
        endpoint.node
        for endpoint in session.native.endpoints
        if endpoint.kind == "service"
        and endpoint.type == "rcl_interfaces/srv/ListParameters"
        and endpoint.name == f"{endpoint.node}/list_parameters"
    )


def _allowed(session: Session, use: Use) -> Iterable[str] | None:
    allow = session.access.rules.allow
    return None if allow is None else allow.get(use, ())


async def _find(session: Session, use: Use, given: object) -> tuple[str, str]:
    """Return the node and the parameter that a name means, if the client may use it so."""
    name = str(given)
    if node := node_of(name):
        own = name.partition(":")[2]
        if not own:
            raise InvalidOperationError(f"'{name[:80]}' must be like '/node:parameter'")
        session.allow(use, f"{node}:{own}")
        return node, own
    own = name.strip("/")
    if not own or refusal(use, f"/node:{own}", None):
        raise InvalidOperationError(f"'{name[:80]}' must be like '/node:parameter'")
    allowed = _allowed(session, use)
    nodes = [one for one in await _nodes(session) if not refusal(use, f"{one}:{own}", allowed)]
    values = await _asked(session, nodes, lambda one: _value(session, one, own))
    found = [one for one, value in values.items() if value is not None]
    if not found:
        raise InvalidOperationError(f"no node has a parameter '{own}'")
    if len(found) > 1:
        several = ", ".join(found)
        raise InvalidOperationError(f"{several} have a parameter '{own}'; write '{found[0]}:{own}'")
    session.allow(use, f"{found[0]}:{own}")
    return found[0], own


async def _asked(
    session: Session, nodes: Iterable[str], ask: Callable[[str], Awaitable[Any]]
) -> dict[str, Any]:
    """Return the answers of the nodes that give one soon."""

    async def one(node: str) -> Any:
        try:
            return await ask(node)
        except (InvalidOperationError, NativeError) as error:
            raise NoAnswerError from error

    return await session.asking.all(nodes, one, session.start)


async def _value(session: Session, node: str, name: str) -> Any:
    response = await _call(session, node, "GetParameters", {"names": [name]})
    # A node that does not know the name answers with no values.
    value = response["values"][0] if response["values"] else {"type": NOT_SET}
    field = FIELDS.get(value["type"])
    return value[field] if field else None


async def _change(session: Session, node: str, name: str, value: dict[str, Any]) -> Response:
    request = {"parameters": [{"name": name, "value": value}]}
    response = await _call(session, node, "SetParameters", request)
    result = response["results"][0]
    return {"successful": result["successful"], "reason": result["reason"]}


async def _call(session: Session, node: str, verb: str, values: dict[str, Any]) -> Any:
    kind = load_type(f"rcl_interfaces/srv/{verb}")
    snake = {"GetParameters": "get_parameters", "SetParameters": "set_parameters"}
    service = f"{node}/{snake.get(verb, 'list_parameters')}"
    if not await session.type_of("service", service):
        raise InvalidOperationError(f"node {node} does not exist, or has no parameters")
    client = await session.party.client(service, f"rcl_interfaces/srv/{verb}")
    try:
        async with asyncio.timeout(TIMEOUT):
            while not await client.is_ready():
                await asyncio.sleep(0.01)
            data = await client.call(to_cdr(from_json(values, kind.Request)))
    except TimeoutError:
        raise InvalidOperationError(f"node {node} does not answer") from None
    finally:
        await client.close()
    return to_json(from_cdr(data, kind.Response))


def node_of(name: str) -> str:
    """Return the node in "/node:parameter", "" in the name of a parameter alone."""
    node, colon, _ = name.partition(":")
    return f"/{node.strip('/')}" if colon and node.strip("/") else ""


def _typed(value: Any) -> dict[str, Any]:
    """Return a parameter's value with its type."""
    one = {bool: 1, int: 2, float: 3, str: 4}
    many = {bool: 6, int: 7, float: 8, str: 9}
    number = one.get(type(value))
    if isinstance(value, list) and value:
        kinds = {type(item) for item in value}
        if kinds == {int, float}:
            value, kinds = [float(item) for item in value], {float}
        number = many.get(kinds.pop()) if len(kinds) == 1 else None
    elif value == []:
        number = 9
    if number is None:
        raise InvalidOperationError("a parameter is a truth value, a number, text, or a list")
    return {"type": number, FIELDS[number]: value}


ANSWERS = {
    "get_param": _get,
    "set_param": _set,
    "has_param": _has,
    "delete_param": _delete,
    "get_param_names": _names,
}
