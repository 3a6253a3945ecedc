"""Read `connect` of site.yaml and of pages: the gateways that a page can join."""

from __future__ import annotations

import re
from collections.abc import Mapping
from urllib.parse import urlsplit

from sitegen.config.document import Value
from sitegen.config.schema import CONNECT, FORMS, NAMES
from sitegen.config.section import Section, check
from sitegen.errors import Problems
from sitegen.model import Connect

# The widget that shows it.
KIND = "connect"
# The server that the page came from.
SELF = "self"


def connect(given: Value | None, problems: Problems) -> Connect | None:
    """Return what a page can join, None without `connect`; report addresses that are not valid."""
    if given is None:
        return None
    section = check(given, CONNECT, problems)
    addresses = section.get("addresses")
    items = addresses.items() if addresses else []
    if addresses and not items:
        message = "names no address; write it like 'addresses: [ws://localhost:9090]'"
        problems.add(addresses.location, addresses.label, message)
    for item in items:
        if item.text != SELF and not _is_address(item.text):
            message = (
                f"'{item.text}' is not the address of a gateway; "
                "write it like 'ws://robot.local:9090', or 'self' for the server of the page"
            )
            problems.add(item.location, item.key, message)
    rates = section.get("rates")
    return Connect(
        addresses=tuple(dict.fromkeys(item.text for item in items)),
        autoconnect=bool(section.option("autoconnect")),
        namespace=section.text("namespace"),
        send=_names("send", section, problems),
        receive=_names("receive", section, problems),
        rates=_rates(rates, problems) if rates else {},
    )


def _is_address(text: str) -> bool:
    # It becomes part of the page's policy, where spaces, quotes, ";" and "," have a meaning.
    if not re.fullmatch(r"wss?://[A-Za-z0-9.:\[\]_-]+(/[A-Za-z0-9._~/-]*)?", text):
        return False
    try:
        parts = urlsplit(text)
        return bool(parts.hostname) and parts.port != 0
    except ValueError:
        return False


def _names(name: str, section: Section, problems: Problems) -> Mapping[str, tuple[str, ...]] | None:
    given = section.get(name)
    if given is None:
        return None
    lists = check(given, NAMES, problems)
    return {
        kind: tuple(item.text for item in found.items()) for kind, found in lists.entries.items()
    }


def _rates(given: Value, problems: Problems) -> dict[str, float]:
    rates = {}
    for name, value in given.entries(problems).items():
        if not FORMS["pattern"].fullmatch(name):
            message = f"'{name}' is not a name of the graph; write it like '/camera/*: 5'"
            problems.add(value.location, value.key, message)
        elif not FORMS["decimal"].fullmatch(value.text) or not 0.01 <= float(value.text) <= 1000:
            message = f"expected messages per second from 0.01 to 1000, found {value.found}"
            problems.add(value.location, value.key, message)
        else:
            rates[name] = float(value.text)
    return rates
