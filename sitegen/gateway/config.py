"""Read gateway.yaml."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any, get_args
from urllib.parse import urlsplit

import yaml

from sitegen.config.document import Value, parse, read, shortened
from sitegen.config.schema import Key
from sitegen.config.section import Section, check
from sitegen.errors import Location, Problems, SiteError
from sitegen.gateway.addresses import HERE
from sitegen.gateway.fieldmap import UNITS, FieldMap
from sitegen.gateway.names import PROTECTED, Use
from sitegen.gateway.rules import KeyRules, Limits, Named, Recording, Reservations, Rules
from sitegen.gateway.schema import (
    ALLOW,
    FILE,
    KEYS,
    LIMITS,
    RECORD,
    RESERVATIONS,
    ROWE,
    ROWE_REPLY,
    ROWE_SERVICE,
    ROWE_TOPIC,
)

DEFAULT = "gateway.yaml"
PATTERN = re.compile(r"[/*][\w/*?~]*(:[\w./@*?-]*)?", re.ASCII)
PLACE = re.compile(r"[A-Za-z]\w*(\.[A-Za-z]\w*)*", re.ASCII)
TOPIC = re.compile(r"(/[A-Za-z_]\w*)+", re.ASCII)


def load(file: Path | None) -> Rules:
    """Return the rules of `file`; without one, those of gateway.yaml here, if there is one.

    Raises: SiteError with everything that is wrong in it.
    """
    if file is None and not Path(DEFAULT).is_file():
        return Rules()
    file = (file or Path(DEFAULT)).resolve()
    if not file.is_file():
        raise SiteError([f"{file}: no such file"])
    problems = Problems(file.parent)
    text = read(file, problems)
    top = None
    if text is not None:
        empty = "the file is empty; start with 'allow: {subscribe: [/odom]}'"
        top = parse(text, Location(file, 1), problems, empty=empty)
    rules = _rules(check(top, FILE, problems), file.parent, problems) if top else Rules()
    problems.raise_if_any()
    return rules


def _rules(file: Section, root: Path, problems: Problems) -> Rules:
    allow = _section(file, "allow", ALLOW, problems)
    limits = _section(file, "limits", LIMITS, problems)
    keys = _section(file, "keys", KEYS, problems)
    turns = _section(file, "reservations", RESERVATIONS, problems)
    record = _section(file, "record", RECORD, problems)
    rowe = _section(file, "rowe", ROWE, problems)
    if turns and not keys and not file.value.has("keys"):
        message = "appointments belong to keys; add 'keys: {secret: gateway.secret}'"
        problems.add(turns.value.location, turns.value.key, message)
    return Rules(
        allow=_allow(allow, problems) if allow else None,
        limits=_limits(limits) if limits else Limits(),
        origins=_origins(file, problems),
        keys=_keys(keys, root, problems) if keys else None,
        reservations=_reservations(turns, root, problems) if turns else None,
        stop=_stop(file, problems),
        people=bool(file.option("people")),
        recording=_recording(record, root) if record else None,
        rowe_topics=_named(rowe, "topics", ROWE_TOPIC, problems) if rowe else {},
        rowe_services=_named(rowe, "services", ROWE_SERVICE, problems) if rowe else {},
        rowe_kind=rowe.text("kind") if rowe else "",
    )


def _section(file: Section, name: str, keys: tuple[Key, ...], problems: Problems) -> Section | None:
    given = file.get(name)
    return check(given, keys, problems) if given else None


def _items(section: Section, name: str) -> list[Value]:
    given = section.get(name)
    return given.items() if given else []


def _allow(section: Section, problems: Problems) -> dict[Use, tuple[str, ...]]:
    found: dict[Use, tuple[str, ...]] = {}
    for use in get_args(Use):
        items = _items(section, use)
        for item in items:
            if not PATTERN.fullmatch(item.text):
                message = f"'{item.text}' is not a pattern of names; write it like '/camera/**'"
                problems.add(item.location, item.key, message)
            elif PROTECTED.search(item.text):
                message = f"'{item.text}' is protected and never reachable; remove it"
                problems.add(item.location, item.key, message)
            elif use.endswith("parameters") and ":" not in item.text and "**" not in item.text:
                message = f"'{item.text}' names no parameter; write it like '{item.text}:speed'"
                problems.add(item.location, item.key, message)
        found[use] = tuple(item.text for item in items)
    return found


def _limits(section: Section) -> Limits:
    return Limits(**{key.name: int(str(section.option(key.name))) for key in LIMITS})


def _origins(file: Section, problems: Problems) -> tuple[str, ...]:
    for item in _items(file, "origins"):
        plain = re.fullmatch(r"https?://[^/\s]+", item.text) or item.text in ("*", "null")
        if not plain:
            message = f"'{item.text}' is not an origin; write it like 'https://me.github.io'"
            problems.add(item.location, item.key, message)
    return tuple(item.text for item in _items(file, "origins"))


def _stop(file: Section, problems: Problems) -> tuple[str, ...]:
    for item in _items(file, "stop"):
        if not TOPIC.fullmatch(item.text):
            message = f"'{item.text}' is not the name of a topic; write it like '/cmd_vel'"
            problems.add(item.location, item.key, message)
    return tuple(item.text for item in _items(file, "stop"))


def _keys(section: Section, root: Path, problems: Problems) -> KeyRules:
    service, secret = section.text("service"), section.text("secret")
    if service and not _secure(service.replace("{key}", "key")):
        message = f"'{service}' is not an https address; write it like 'https://lab.example.org/…'"
        problems.add(section.location("service"), section.label("service"), message)
    elif service and service.count("{key}") != 1:
        message = "write {key} once, where the key belongs: 'https://lab.example.org/?key={key}'"
        problems.add(section.location("service"), section.label("service"), message)
    if not section.value.has("service", "secret"):
        message = "say where keys come from: 'secret: gateway.secret', or 'service: https://…'"
        problems.add(section.value.location, section.value.key, message)
    path = root / secret if secret else None
    return KeyRules(path, service, int(str(section.option("tries"))))


def _reservations(section: Section, root: Path, problems: Problems) -> Reservations:
    calendar = section.text("calendar")
    if "://" in calendar:
        if not _secure(calendar):
            message = f"'{calendar}' is not an https address"
            problems.add(section.location("calendar"), section.label("calendar"), message)
    elif calendar:
        if not (root / calendar).is_file():
            message = f"'{calendar}' does not exist; give an iCalendar file or an https address"
            problems.add(section.location("calendar"), section.label("calendar"), message)
        calendar = str(root / calendar)
    refresh = int(str(section.option("refresh")))
    return Reservations(calendar, refresh, bool(section.option("watch")))


def _recording(section: Section, root: Path) -> Recording:
    repository = section.text("repository")
    return Recording(
        root / (section.text("folder") or "sessions"),
        int(str(section.option("size"))),
        root / repository if repository else None,
        bool(section.option("commit")),
    )


def _named(rowe: Section, kind: str, keys: tuple[Key, ...], problems: Problems) -> dict[str, Named]:
    given = rowe.get(kind)
    found = {}
    for own, value in given.entries(problems).items() if given else ():
        section = check(value, keys, problems)
        name = section.text(keys[0].name)
        if name and not TOPIC.fullmatch(name):
            message = f"'{name}' is not a name in ROS; write it like '/add_two_ints'"
            problems.add(section.location(keys[0].name), section.label(keys[0].name), message)
        reply = _section(section, "reply", ROWE_REPLY, problems)
        map_of_reply = _fields(reply, problems) if reply else FieldMap()
        fields = _fields(section, problems)
        found[own] = Named(name, section.text("type"), fields, map_of_reply)
    return found


def _fields(section: Section, problems: Problems) -> FieldMap:
    def entries(name: str) -> dict[str, Value]:
        given = section.get(name)
        return given.entries(problems) if given else {}

    fields = {name: value.text for name, value in entries("fields").items()}
    for value in entries("fields").values():
        if not PLACE.fullmatch(value.text):
            message = f"'{value.text}' is not the place of a field; write it like 'linear.x'"
            problems.add(value.location, value.key, message)
    if len(set(fields.values())) < len(fields):
        given = section.location("fields"), section.label("fields")
        problems.add(*given, "two fields have the same place; remove one")
    units = {}
    for name, value in entries("units").items():
        if value.text not in UNITS:
            message = f"unknown unit '{value.text}'; the units are {', '.join(UNITS)}"
            problems.add(value.location, value.key, message)
        else:
            units[name] = UNITS[value.text]
    return FieldMap(fields, _defaults(entries("defaults"), problems), units)


def _defaults(given: dict[str, Value], problems: Problems) -> dict[str, Any]:
    found = {}
    for place, value in given.items():
        try:
            found[place] = yaml.SafeLoader("").construct_document(value.node)
            json.dumps(found[place], allow_nan=False)
        except (TypeError, ValueError, yaml.YAMLError):
            message = f"'{shortened(value.text)}' is not a value of JSON; put it in quotes"
            problems.add(value.location, value.key, message)
    return found


def _secure(address: str) -> bool:
    """Return whether an address is https, or one of this computer."""
    try:
        parts = urlsplit(address)
        name = parts.hostname
    except ValueError:
        return False
    return bool(name) and (parts.scheme == "https" or (parts.scheme == "http" and name in HERE))
