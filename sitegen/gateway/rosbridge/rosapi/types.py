"""What rosapi tells of types: their fields, constants and definitions."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from sitegen.gateway.definitions import full_text
from sitegen.gateway.fieldtypes import parse
from sitegen.gateway.native import installed, load_type
from sitegen.gateway.rosbridge.rosapi import graph
from sitegen.gateway.rosbridge.typenames import full

if TYPE_CHECKING:
    from sitegen.gateway.rosbridge.session import Session

Response = dict[str, Any]


def _details(kind: str, part: str = "") -> Callable[[Session, Any], Any]:
    async def answer(_: Session, args: Any) -> Response:
        found = load_type(full(args["type"], kind))
        return {"typedefs": _typedefs(getattr(found, part) if part else found)}

    return answer


def _typedefs(kind: Any) -> list[dict[str, Any]]:
    """Return the definition of a class, and those of the messages in it, each once."""
    found: dict[Any, dict[str, Any]] = {}

    def add(each: Any) -> None:
        if each in found:
            return
        fields = {name: parse(text) for name, text in each.get_fields_and_field_types().items()}
        default = each()
        found[each] = {
            "type": _short(each),
            "fieldnames": list(fields),
            "fieldtypes": [field.name for field in fields.values()],
            # -1 for a single value, 0 for any number of values.
            "fieldarraylen": [(field.size or 0) if field.many else -1 for field in fields.values()],
            "examples": [
                "[]" if field.many else "{}" if field.message else str(getattr(default, name))
                for name, field in fields.items()
            ],
            **_constants(each),
        }
        for field in fields.values():
            if field.message:
                add(load_type(field.message))

    add(kind)
    return list(found.values())


def _short(kind: Any) -> str:
    return f"{kind.__module__.partition('.')[0]}/{kind.__name__}"


def _constants(kind: Any) -> dict[str, list[str]]:
    names = [name for name in dir(type(kind)) if name.isupper() and not name.startswith("_")]
    values = [str(getattr(kind, name)) for name in names]
    return {"constnames": names, "constvalues": values}


async def _raw_types(session: Session, _: Any) -> Response:
    found = await graph.ANSWERS["topics"](session, {})
    texts = [full_text(name) for name in found["types"]]
    return {**found, "typedefs_full_text": texts}


async def _interfaces(_: Session, __: Any) -> Response:
    return {"interfaces": installed()}


ANSWERS = {
    "message_details": _details("msg"),
    "service_request_details": _details("srv", "Request"),
    "service_response_details": _details("srv", "Response"),
    "action_goal_details": _details("action", "Goal"),
    "action_result_details": _details("action", "Result"),
    "action_feedback_details": _details("action", "Feedback"),
    "topics_and_raw_types": _raw_types,
    "interfaces": _interfaces,
}
