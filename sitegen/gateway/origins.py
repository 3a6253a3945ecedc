"""Decide which web pages may connect."""

from __future__ import annotations

import ipaddress
import socket
from collections.abc import Iterable
from fnmatch import fnmatchcase
from urllib.parse import urlsplit

from sitegen.gateway.addresses import HERE


def allows(origin: str | None, host: str, listed: Iterable[str]) -> bool:
    """Return whether a page of `origin` may connect; programs other than browsers send none.

    Pages of this computer may, those that the gateway serves itself, and those of a listed origin,
    in which `*` stands for anything. `host` is the address by which the client reached the gateway.
    """
    if origin is None or any(fnmatchcase(origin.lower(), each.lower()) for each in listed):
        return True
    name = _host(origin)
    if name in HERE:
        return True
    # Another site could let its own name lead to this computer; an address cannot be borrowed.
    same = bool(name) and urlsplit(origin).netloc == host
    return same and (_is_address(name) or name in _own_names())


def _host(origin: str) -> str:
    try:
        return urlsplit(origin).hostname or ""
    except ValueError:
        return ""


def _is_address(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True


def _own_names() -> set[str]:
    own = socket.gethostname().lower()
    return {own, f"{own.partition('.')[0]}.local"}
