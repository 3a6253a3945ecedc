"""Write a launch file as page.json has it (Launch in protocol.js)."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import asdict, fields

from sitegen.model import Argument, Effect, Handler, Launch


def launch_entry(launch: Launch, pressed: Collection[str]) -> dict[str, object]:
    """Return a launch file; those of its nodes in `pressed` start when a visitor presses Start."""
    own = [name for name in launch.nodes if name in pressed]
    return {
        "package": launch.package,
        "file": launch.file,
        "nodes": list(launch.nodes),
        **({"first": [*launch.first]} if launch.later else {}),
        **({"handlers": [_handler(each) for each in launch.handlers]} if launch.handlers else {}),
        **({"asked": own} if own else {}),
        **({"arguments": [*map(_argument, launch.arguments)]} if launch.arguments else {}),
    }


def _argument(argument: Argument) -> dict[str, object]:
    given = asdict(argument)
    return {name: value for name, value in given.items() if value is not None and value != ()}


def _handler(handler: Handler) -> dict[str, object]:
    """Return what a launch file does at an event, without what is left open."""
    on = {name: value for name, value in asdict(handler.on).items() if value}
    return {"on": on, "effects": [*map(_effect, handler.effects)], "most": handler.most}


def _effect(effect: Effect) -> dict[str, object]:
    plain = {field.name: getattr(effect, field.name) for field in fields(effect)}
    inside = {"handler": _handler(effect.handler)} if effect.handler else {}
    return {name: value for name, value in plain.items() if value} | inside
