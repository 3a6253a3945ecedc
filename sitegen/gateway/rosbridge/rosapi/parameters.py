"""What rosapi tells of parameters, and how it sets them; they are named "/node:parameter"."""

from __future__ import annotations

import asyncio
import json
from typing import TYPE_CHECKING, Any

from sitegen.gateway.names import refusal
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
        node, name = _split(args["name"])
        session.allow("get_parameters", f"{node}:{name}")
        value = await _value(session, node, name)
    except (InvalidOperationError, NativeError) as error:
        return {"value": default or "null", "successful": False, "reason": str(error)}
    if value is None:
        reason = f"{node} has no parameter '{name}'"
        return {"value": default or "null", "successful": False, "reason": reason}
    return {"value": json.dumps(value), "successful": True, "reason": ""}


async def _set(session: Session, args: Any) -> Response:
    try:
        node, name = _split(args["name"])
        session.allow("set_parameters", f"{node}:{name}")
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
        node, name = _split(args["name"])
        session.allow("get_parameters", f"{node}:{name}")
        return {"exists": await _value(session, node, name) is not None}
    except (InvalidOperationError, NativeError):
        return {"exists": False}


async def _delete(session: Session, args: Any) -> Response:
    try:
        given = args["name"]
        node, name = _split(f"{args['node_name']}:{given}" if "node_name" in args else given)
        session.allow("set_parameters", f"{node}:{name}")
        return await _change(session, node, name, {"type": NOT_SET})
    except (InvalidOperationError, NativeError) as error:
        return {"successful": False, "reason": str(error)}


async def _names(session: Session, _: Any) -> Response:
    await session.native.refresh()
    nodes = sorted(
        endpoint.node
        for endpoint in session.native.endpoints
        if endpoint.kind == "service"
        and endpoint.type == "rcl_interfaces/srv/ListParameters"
        and endpoint.name == f"{endpoint.node}/list_parameters"
    )
    listed = await asyncio.gather(*(_list(session, node) for node in nodes))
    allow = session.access.rules.allow
    allowed = None if allow is None else allow.get("get_parameters", ())
    names = [name for each in listed for name in each]
    return {"names": [name for name in names if not refusal("get_parameters", name, allowed)]}


async def _list(session: Session, node: str) -> list[str]:
    try:
        response = await _call(session, node, "ListParameters", {"depth": 0})
    except (NativeError, InvalidOperationError):
        return []
    return [f"{node}:{name}" for name in response["result"]["names"]]


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


def _split(name: object) -> tuple[str, str]:
    node, colon, parameter = str(name).partition(":")
    if not colon or not parameter or not node.strip("/"):
        raise InvalidOperationError(f"'{str(name)[:80]}' must be like '/node:parameter'")
    return node if node.startswith("/") else f"/{node}", parameter


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
