"""The key expressions of rmw_zenoh, which say what is in the graph and where its messages go.

An endpoint has a liveliness token, "@ros2_lv/<domain>/<session>/<node id>/<id>/MP/…". Its messages
have the key "<domain>/<topic>/<type>/<hash>". Source: docs/design.md of ros2/rmw_zenoh.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from functools import cached_property

import xxhash

from sitegen.gateway.names import LONGEST
from sitegen.gateway.native import Kind, Qos

_SPACE = "@ros2_lv"
_KINDS: dict[str, Kind] = {
    "NN": "node",
    "MP": "publisher",
    "MS": "subscription",
    "SS": "service",
    "SC": "client",
}
_CODES = {kind: code for code, kind in _KINDS.items()}
_NAME = re.compile(r"(/[A-Za-z_]\w*)+", re.ASCII)
_TYPE = re.compile(r"([a-z]\w*)::(msg|srv|action)::dds_::(\w+)_", re.ASCII)
_HASH = re.compile(r"[\w-]{1,100}", re.ASCII)
_ID = re.compile(r"[0-9a-f]{1,32}")
_NUMBER = re.compile(r"\d{1,9}", re.ASCII)
# The values of rmw's policies.
_RELIABLE, _BEST_EFFORT = "1", "2"
_TRANSIENT_LOCAL, _VOLATILE = "1", "2"
_KEEP_LAST, _KEEP_ALL = "1", "2"
_AUTOMATIC, _MANUAL_BY_TOPIC = "1", "3"
# What is meant where a token leaves the depth out.
_DEPTH = 42
# ROS 2 Humble has no hashes.
_NO_HASH = "TypeHashNotSupported"


def data_key(domain: int, name: str, type_name: str, hash: str) -> str:
    """Return the key of the messages of a topic, or of the requests to a service."""
    package, kind, short = type_name.split("/")
    return f"{domain}/{name.strip('/')}/{package}::{kind}::dds_::{short}_/{hash or _NO_HASH}"


def tokens_of(domain: int) -> str:
    """Return the key expression of all liveliness tokens of a domain."""
    return f"{_SPACE}/{domain}/**"


@dataclass(frozen=True)
class Token:
    """A node or an endpoint, as its liveliness token tells of it.

    `node` has its namespace: "/robot/talker". `name` is that of the topic or service; nodes have
    none, no type and no hash.
    """

    domain: int
    session: str
    node_id: int
    id: int
    kind: Kind
    node: str
    name: str = ""
    type: str = ""
    hash: str = ""
    qos: Qos = field(default_factory=Qos)

    @cached_property
    def key(self) -> str:
        """The key expression of the token."""
        namespace, _, short = self.node.rpartition("/")
        parts = [_SPACE, str(self.domain), self.session, str(self.node_id), str(self.id)]
        parts += [_CODES[self.kind], "%", _mangled(namespace or "/"), short]
        if self.kind != "node":
            type_part, hash_part = self.data_key.split("/")[-2:]
            parts += [_mangled(self.name), type_part, hash_part, _written(self.qos)]
        return "/".join(parts)

    @cached_property
    def gid(self) -> bytes:
        """The gid of the endpoint, which is a hash of its token."""
        return gid_of(self.key)

    @cached_property
    def data_key(self) -> str:
        """The key of its messages or requests."""
        return data_key(self.domain, self.name, self.type, self.hash)


def gid_of(token: str) -> bytes:
    """Return the gid (16 bytes) of the endpoint that has this token."""
    return xxhash.xxh3_128_intdigest(token.encode()).to_bytes(16, "little")


def parse(key: str) -> Token | None:
    """Return what the key expression of a token says, None if it is not valid."""
    parts = key.split("/")
    if len(parts) not in (9, 13) or parts[0] != _SPACE:
        return None
    domain, session, node_id, id, code, _, namespace, short = parts[1:9]
    kind = _KINDS.get(code)
    node = f"{_plain(namespace).rstrip('/')}/{short}"
    numbers = all(map(_NUMBER.fullmatch, (domain, node_id, id)))
    if not (kind and numbers and _ID.fullmatch(session) and _is_name(node)):
        return None
    same = int(domain), session, int(node_id), int(id), kind, node
    if len(parts) == 9:
        return Token(*same) if kind == "node" else None
    name, type_part, hash = _plain(parts[9]), _TYPE.fullmatch(parts[10]), parts[11]
    qos = _read(parts[12])
    if kind == "node" or not (_is_name(name) and type_part and _HASH.fullmatch(hash) and qos):
        return None
    return Token(*same, name, "/".join(type_part.groups()), "" if hash == _NO_HASH else hash, qos)


def _is_name(text: str) -> bool:
    return len(text) <= LONGEST and bool(_NAME.fullmatch(text))


def _mangled(name: str) -> str:
    return name.replace("/", "%")


def _plain(mangled: str) -> str:
    return mangled.replace("%", "/")


def _written(qos: Qos) -> str:
    """Return a quality of service as tokens have it; without a number, there is no limit."""
    history = f"{_KEEP_ALL if qos.keep_all else _KEEP_LAST},{qos.depth}"
    liveliness = _MANUAL_BY_TOPIC if qos.manual else _AUTOMATIC
    return ":".join(
        [
            _RELIABLE if qos.reliable else _BEST_EFFORT,
            _TRANSIENT_LOCAL if qos.transient_local else _VOLATILE,
            history,
            _seconds(qos.deadline),
            _seconds(qos.lifespan),
            f"{liveliness},{_seconds(qos.lease)}",
        ]
    )


def _read(text: str) -> Qos | None:
    parts = [part.split(",") for part in text.split(":")]
    if [len(part) for part in parts] != [1, 1, 2, 2, 2, 3]:
        return None
    if not all(re.fullmatch(r"\d{0,19}", number, re.ASCII) for part in parts for number in part):
        return None
    [reliability], [durability], (history, depth), deadline, lifespan, (liveliness, *lease) = parts
    return Qos(
        depth=min(int(depth or _DEPTH), 2**31 - 1) or _DEPTH,
        reliable=reliability != _BEST_EFFORT,
        transient_local=durability == _TRANSIENT_LOCAL,
        keep_all=history == _KEEP_ALL,
        deadline=_milliseconds(*deadline),
        lifespan=_milliseconds(*lifespan),
        manual=liveliness == _MANUAL_BY_TOPIC,
        lease=_milliseconds(*lease),
    )


def _seconds(milliseconds: float) -> str:
    if math.isinf(milliseconds):
        return ","
    return "{},{}".format(*divmod(int(milliseconds * 1e6), 10**9))


def _milliseconds(seconds: str, nanoseconds: str) -> float:
    total = int(seconds or 0) * 10**9 + int(nanoseconds or 0)
    # Zero is how profiles spell "the default", which is none.
    return math.inf if total == 0 or total >= 10**18 else total / 1e6
