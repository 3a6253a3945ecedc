"""The JSON Schema of site.yaml, with which editors complete and check it."""

from __future__ import annotations

from collections.abc import Iterable

from sitegen.config.layout import CONSOLES
from sitegen.config.nodekeys import COMPILED, NODE, ROS2WASM
from sitegen.config.page import LAYOUTS
from sitegen.config.schema import (
    BUILD,
    CONNECT,
    DEPLOY,
    FILE,
    FORMS,
    NAMES,
    PAGE,
    PYODIDE,
    SITE,
    Key,
)
from sitegen.config.widgetkeys import (
    CHOICES,
    COLUMN,
    MARKDOWN,
    ROBOTS,
    ROW,
    SHORT,
    STAGE,
    THRESHOLD,
    WIDGETS,
)

Json = dict[str, object]

TEXT: Json = {"type": "string", "minLength": 1}
# The types of the schema in JSON.
TYPES: dict[str, Json] = {
    "text": TEXT,
    "path": TEXT,
    "url": {"type": "string", "pattern": "^https?://"},
    "flag": {"type": "boolean"},
    "number": {"type": "integer", "minimum": 1},
    "list of text": {"type": "array", "items": TEXT},
    "mapping of texts": {"type": "object", "additionalProperties": TEXT},
    "site": {"$ref": "#/$defs/site"},
    "nodes": {"type": "object", "additionalProperties": {"$ref": "#/$defs/node"}},
    "pages": {"type": "array", "minItems": 1, "items": {"$ref": "#/$defs/page"}},
    "content": {"type": "array", "items": {"$ref": "#/$defs/item"}},
    "items": {
        "anyOf": [{"type": "array", "items": {"$ref": "#/$defs/item"}}, {"$ref": "#/$defs/item"}]
    },
    "displays": {
        "type": "array",
        "items": {"anyOf": [TEXT, {"type": "object", "minProperties": 1, "maxProperties": 1}]},
    },
    "nav": {"type": "array", "items": {"$ref": "#/$defs/nav"}},
    "deploy": {"$ref": "#/$defs/deploy"},
    "pyodide": {"$ref": "#/$defs/pyodide"},
    "connect": {"$ref": "#/$defs/connect"},
    "names": {"$ref": "#/$defs/names"},
    "builds": {"type": "object", "additionalProperties": {"$ref": "#/$defs/build"}},
    "mapping of decimals": {"type": "object", "additionalProperties": {"type": "number"}},
}
TYPES |= {name: {"type": "string", "pattern": f"^{form.pattern}$"} for name, form in FORMS.items()}
TYPES |= {
    "list of patterns": {"type": "array", "items": TYPES["pattern"]},
    "list of names": {"type": "array", "items": TYPES["name"]},
    "mapping of names": {"type": "object", "additionalProperties": TYPES["name"]},
    "parameters": {"type": ["object", "array"]},
    "data": {"type": "object"},
    "decimal": {"type": "number"},
    "message paths": {
        "anyOf": [TYPES["message path"], {"type": "array", "items": TYPES["message path"]}]
    },
    "thresholds": {"type": "array", "minItems": 1, "items": {"$ref": "#/$defs/threshold"}},
    "mapping of interfaces": {"type": "object", "additionalProperties": TYPES["interface"]},
}
NAV: Json = {
    "anyOf": [
        TEXT,
        {
            "type": "object",
            "minProperties": 1,
            "maxProperties": 1,
            "additionalProperties": {"anyOf": [TEXT, TYPES["nav"]]},
        },
    ]
}


def json_schema() -> Json:
    """Return the JSON Schema of site.yaml."""
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "site.yaml of sitegen",
        **_mapping(FILE),
        "$defs": {
            "site": _mapping(SITE),
            "node": {"anyOf": [_mapping(NODE), _mapping(COMPILED), _mapping(ROS2WASM)]},
            "page": _mapping(PAGE),
            "nav": NAV,
            "connect": _mapping(CONNECT),
            "names": _mapping(NAMES),
            "build": _mapping(BUILD),
            "deploy": _mapping(DEPLOY),
            "pyodide": _mapping(PYODIDE),
            "threshold": _mapping(THRESHOLD),
            "item": _item(),
        },
    }


def _mapping(keys: Iterable[Key]) -> Json:
    keys = tuple(keys)
    schema: Json = {
        "type": "object",
        "additionalProperties": False,
        "properties": {key.name: _key(key) for key in keys},
    }
    required = [key.name for key in keys if key.required]
    return schema | ({"required": required} if required else {})


def _key(key: Key) -> Json:
    schema = {**TYPES[key.type], "description": key.help}
    if key in WIDGETS["robot"] and key.name == "kind":
        schema["enum"] = sorted(ROBOTS)
    if key in PAGE and key.name == "layout":
        schema["enum"] = list(LAYOUTS)
    choices = next((words for keys, words in CHOICES.items() if key in keys), None)
    if key.name in (choices or ()):
        schema["enum"] = list((choices or {})[key.name])
    return schema if key.default is None else schema | {"default": key.default}


def _item() -> Json:
    """Return the schema of an item of `content`: a mapping with one key, its kind."""
    kinds: Json = {MARKDOWN.name: _key(MARKDOWN)}
    kinds |= {
        "columns": {"type": "array", "items": {"anyOf": [TYPES["items"], _mapping(COLUMN)]}},
        "rows": {"type": "array", "items": {"anyOf": [TYPES["items"], _mapping(ROW)]}},
        "grid": TYPES["content"],
        "tabs": {"type": "object", "additionalProperties": TYPES["items"]},
        "stage": _stage(),
    }
    for kind, keys in WIDGETS.items():
        kinds[kind] = _widget(kind, keys)
    return {
        "type": "object",
        "additionalProperties": False,
        "minProperties": 1,
        "maxProperties": 1,
        "properties": kinds,
    }


def _stage() -> Json:
    stage = _mapping(STAGE)
    properties = stage["properties"]
    assert isinstance(properties, dict)
    properties["consoles"] |= {"enum": list(CONSOLES)}
    return stage


def _widget(kind: str, keys: tuple[Key, ...]) -> Json:
    """Return the schema of a widget: its target, its options, or nothing if neither is required."""
    options = _mapping(keys)
    forms: list[Json] = [options]
    if any(key.name == "node" for key in keys):
        forms.append(TEXT)
    if not any(key.required for key in keys):
        forms.append({"type": "null"})
    if kind in SHORT:
        forms.append(next(TYPES[key.type] for key in keys if key.name == SHORT[kind]))
    return {"anyOf": forms}
