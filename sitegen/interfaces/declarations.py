"""Declare the API of an author's panel, and the messages of its page, for editors."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from sitegen.interfaces.messages import MessageType
from sitegen.interfaces.values import EXACT_AS_TEXT
from sitegen.shipped import VENDOR

# The API itself, the same for all sites: of panels, and of the modules that they can import.
API = Path(__file__).with_name("ros.d.ts")
CLIENT = Path(__file__).with_name("sitegen.d.ts")
# roslib's own declarations, far longer than the others: only for sites that use it.
ROSLIB = VENDOR / "roslib.d.ts"
FIELD = re.compile(r"([^[<]+)(?:<=\d+)?(\[(?:<=)?\d*\])?")
TEXTS = {"bool": "boolean", "string": "string", "wstring": "string"}
TYPED = {
    **{"int8": "Int8", "int16": "Int16", "int32": "Int32"},
    **{"uint8": "Uint8", "uint16": "Uint16", "uint32": "Uint32"},
    **{"float32": "Float32", "float64": "Float64", "int64": "BigInt64", "uint64": "BigUint64"},
}


def client_declarations(*, roslib: bool) -> str:
    """Return the text of `sitegen.d.ts`; with `roslib`, it also declares "sitegen/roslib"."""
    files = [CLIENT, ROSLIB] if roslib else [CLIENT]
    return "\n".join(file.read_text(encoding="utf-8") for file in files)


def declarations(types: Mapping[str, MessageType]) -> str:
    """Return the text of `ros.d.ts` for a page whose nodes use `types`."""
    known = sorted(types)
    services = [name.removesuffix("_Request") for name in known if _is_service(name, types)]
    goals = (name.removesuffix("_Goal") for name in known if name.endswith("_Goal"))
    actions = [one for one in goals if f"{one}_Feedback" in types and f"{one}_Result" in types]
    lines = [
        API.read_text(encoding="utf-8").rstrip(),
        "",
        "/** The messages that nodes of the page use, by name. */",
        "export interface Messages {",
        *(line for name in known for line in _message(name, types[name])),
        "}",
        "",
        "/** The services that nodes of the page use, by name. */",
        "export interface Services {",
        *(
            f'  "{name}": {{ request: Messages["{name}_Request"], '
            f'response: Messages["{name}_Response"] }};'
            for name in services
        ),
        "}",
        "",
        "/** The actions that nodes of the page use, by name. */",
        "export interface Actions {",
        *(
            f'  "{name}": {{ goal: Messages["{name}_Goal"], feedback: Messages["{name}_Feedback"], '
            f'result: Messages["{name}_Result"] }};'
            for name in actions
        ),
        "}",
    ]
    return "\n".join(lines) + "\n"


def _is_service(name: str, types: Mapping[str, MessageType]) -> bool:
    bare = name.removesuffix("_Request")
    return bare != name and "/srv/" in name and f"{bare}_Response" in types


def _message(name: str, definition: MessageType) -> Iterator[str]:
    constants = [f"{one['name']} = {_literal(one)}" for one in definition["constants"]]
    if constants:
        yield f"  /** Constants: {', '.join(constants).replace('*/', '* /')} */"
    fields = (f"{field['name']}: {_type(field['type'])}" for field in definition["fields"])
    yield f'  "{name}": {{ {", ".join(fields)} }};'


def _literal(constant: Mapping[str, Any]) -> str:
    """Return the value of a constant in JavaScript."""
    big = constant["type"] in EXACT_AS_TEXT
    return f"{constant['value']}n" if big else json.dumps(constant["value"])


def _type(written: str) -> str:
    """Return the type of a field in JavaScript."""
    match = FIELD.fullmatch(written)
    assert match
    base, array = match[1], match[2]
    if "/" in base:
        plain = f'Messages["{base}"]'
    elif base in TEXTS:
        plain = TEXTS[base]
    elif base in TYPED:
        if array:
            return f"{TYPED[base]}Array"
        plain = "bigint" if base.endswith("int64") else "number"
    else:
        plain = "unknown"
    return f"{plain}[]" if array else plain
