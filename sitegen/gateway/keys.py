"""Keys with a time limit: signed ones, and those that a service of the operator knows."""

from __future__ import annotations

import base64
import hashlib
import hmac
import ipaddress
import json
import math
import os
import re
import secrets
import time
from collections import deque
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import quote

import aiohttp

from sitegen.errors import SiteError
from sitegen.gateway.rules import KeyRules

LONGEST = 2000
# A name may be that of a person or an address of mail.
NAME = re.compile(r"[\w.@+' -]{1,100}")
# How long the operator's service may take (s), and the bytes of its answer.
PATIENCE, ANSWER = 5, 64_000
# Addresses whose wrong keys are remembered.
MOST_ADDRESSES = 10_000
JSONP = re.compile(r"\s*[\w$.]+\s*\((.*)\)\s*;?\s*", re.DOTALL)
SHORTEST_SECRET = 32


class RefusedError(Exception):
    """The gateway refuses something; the text says why, to the client and in the log."""


@dataclass(frozen=True)
class Grant:
    """What a key is good for: whose it is, and for how long (s)."""

    person: str
    seconds: float
    # Names the key in the log, but does not tell it.
    key_id: str


class Keys:
    """Says what keys are good for."""

    def __init__(self, rules: KeyRules) -> None:
        self._rules = rules
        self._secret = read_secret(rules.secret) if rules.secret else b""
        self._wrong: dict[str, deque[float]] = {}

    async def check(self, key: object, address: str) -> Grant:
        """Return what `key` is good for. Raises: RefusedError if it is good for nothing."""
        tries = self._tries(address)
        if len(tries) >= self._rules.tries:
            raise RefusedError("too many wrong keys; try again in a minute")
        # Counted beforehand, so that many at once do not help.
        tries.append(time.monotonic())
        if not isinstance(key, str) or not 0 < len(key) <= LONGEST:
            raise RefusedError("no key")
        grant = await self._grant(key)
        if grant is None:
            raise RefusedError("the key is not valid")
        if grant.seconds <= 0:
            raise RefusedError("the key has expired")
        tries.pop()
        return grant

    def _tries(self, address: str) -> deque[float]:
        """Return when wrong keys have come from an address within a minute."""
        limit = time.monotonic() - 60
        if len(self._wrong) > MOST_ADDRESSES:
            self._wrong = {k: v for k, v in self._wrong.items() if v and v[-1] > limit}
        tries = self._wrong.setdefault(_network(address), deque())
        while tries and tries[0] < limit:
            tries.popleft()
        return tries

    async def _grant(self, key: str) -> Grant | None:
        if self._secret and (found := verified(key, self._secret)):
            return found
        return await self._ask(key) if self._rules.service else None

    async def _ask(self, key: str) -> Grant | None:
        address = self._rules.service.replace("{key}", quote(key, safe=""))
        timeout = aiohttp.ClientTimeout(total=PATIENCE)
        try:
            async with (
                aiohttp.ClientSession(timeout=timeout) as session,
                session.get(address, allow_redirects=False) as answer,
            ):
                if answer.status != 200:
                    return None
                text = (await answer.content.read(ANSWER)).decode("utf-8", "replace")
        except (TimeoutError, aiohttp.ClientError, OSError):
            raise RefusedError("the service that knows the keys does not answer") from None
        return answered(text, key_id(key))


def answered(text: str, key_id: str) -> Grant | None:
    """Return what a service says: seconds, alone or with a name, in JSON or in JSONP."""
    match = JSONP.fullmatch(text)
    try:
        found = json.loads(match[1] if match else text)
    except (ValueError, RecursionError):
        return None
    name = ""
    if isinstance(found, dict):
        name = str(found.get("name") or "")
        found = found.get("seconds")
    if not isinstance(found, int | float) or isinstance(found, bool) or not math.isfinite(found):
        return None
    return Grant(name if NAME.fullmatch(name) else f"key {key_id}", min(found, 1e8), key_id)


def signed(name: str, seconds: float, secret: bytes) -> str:
    """Return a key of `name` that is good for `seconds` from now on."""
    said = {"name": name, "until": round(time.time() + seconds, 1), "id": secrets.token_hex(4)}
    body = _text(json.dumps(said, separators=(",", ":")).encode())
    return f"{body}.{_signature(body, secret)}"


def verified(key: str, secret: bytes) -> Grant | None:
    """Return what a signed key is good for, None if it is none."""
    body, dot, signature = key.partition(".")
    try:
        given = signature.encode("ascii")
    except UnicodeEncodeError:
        return None
    if not dot or not hmac.compare_digest(given, _signature(body, secret).encode()):
        return None
    said = json.loads(_bytes(body))
    return Grant(said["name"], said["until"] - time.time(), said["id"])


def _network(address: str) -> str:
    """Return what one customer of a provider has: an IPv4 address, or 64 bits of IPv6."""
    try:
        found = ipaddress.ip_address(address.partition("%")[0])
    except ValueError:
        return address
    if isinstance(found, ipaddress.IPv6Address) and found.ipv4_mapped is None:
        return str(ipaddress.ip_network((found, 64), strict=False))
    return str(getattr(found, "ipv4_mapped", None) or found)


def key_id(key: str) -> str:
    """Return what names a key in the log."""
    return hashlib.sha256(key.encode("utf-8", "surrogatepass")).hexdigest()[:8]


def read_secret(file: Path) -> bytes:
    """Return the secret of a file. Raises: SiteError if there is none, or if others can read it."""
    try:
        secret = file.read_text("ascii").strip().encode()
        others = os.name == "posix" and file.stat().st_mode & 0o077
    except FileNotFoundError:
        how = "make it and a first key with: sitegen gateway keys NAME"
        raise SiteError([f"{file}: no such file; {how}"]) from None
    except (OSError, ValueError):
        raise SiteError([f"{file}: cannot be read as a secret"]) from None
    if len(secret) < SHORTEST_SECRET:
        raise SiteError([f"{file}: shorter than {SHORTEST_SECRET} characters; make a new one"])
    if others:
        raise SiteError([f"{file}: others can read it; run: chmod 600 {file}"])
    return secret


def make_secret(file: Path) -> bytes:
    """Write a new secret, which only its owner can read, and return it."""
    secret = secrets.token_hex(32)
    with os.fdopen(os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w") as out:
        out.write(secret + "\n")
    return secret.encode()


def _signature(body: str, secret: bytes) -> str:
    return _text(hmac.new(secret, body.encode("utf-8", "surrogatepass"), hashlib.sha256).digest())


def _text(data: bytes) -> str:
    return base64.urlsafe_b64encode(data).decode().rstrip("=")


def _bytes(text: str) -> bytes:
    return base64.urlsafe_b64decode(text + "=" * (-len(text) % 4))
