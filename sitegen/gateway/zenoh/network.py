"""Open a session of Zenoh."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from pathlib import Path

import zenoh

from sitegen.errors import SiteError

PORT = 7447
# "robot", "robot:7447", "[::1]:7447", "tcp/robot:7447"
_ADDRESS = re.compile(
    r"(?:(?P<protocol>tcp|tls|quic|ws|wss|udp)/)?(?P<host>\[[0-9a-f:.]+\]|[\w.-]+)(?::(?P<port>\d+))?",
    re.ASCII | re.IGNORECASE,
)
# A connection that is silent for so long is lost (ms): as with pages, a cut of 10 s heals.
_LEASE = 15_000


def open_session(
    connect: Sequence[str], bind: str, port: int, config: Path | None
) -> zenoh.Session:
    """Connect to the addresses `connect`, and listen at `port` of `bind`, or not at all with 0.

    With `config`, Zenoh's own configuration file, that file says where to listen, and how.

    Raises:
        SiteError: an address or the file is not valid, or the port cannot be used
    """
    if not 0 <= port < 2**16:
        raise SiteError([f"--zenoh-port: {port} is not a port"])
    try:
        settings = zenoh.Config.from_file(config) if config else zenoh.Config()
    except zenoh.ZError as error:
        raise SiteError([f"--zenoh-config: {config}: {_plain(error)}"]) from None
    if config is None:
        # As rmw_zenoh, it looks for nobody by multicast.
        _set(settings, "scouting/multicast/enabled", value=False)
        _set(settings, "transport/link/tx/lease", value=_LEASE)
        host = f"[{bind}]" if ":" in bind else bind
        _set(settings, "listen/endpoints", value=[f"tcp/{host}:{port}"] if port else [])
    # Routers pass on what is for others, in whatever way they are connected.
    _set(settings, "mode", value="router")
    # Without timestamps, publishers keep nothing for late subscriptions.
    _set(settings, "timestamping/enabled", value=True)
    if connect:
        _set(settings, "connect/endpoints", value=[_endpoint(one) for one in connect])
    # Those that are not there yet are tried again and again.
    _set(settings, "connect/timeout_ms", value=0)
    _set(settings, "connect/exit_on_failure", value=False)
    try:
        return zenoh.open(settings)
    except zenoh.ZError as error:
        if "in use" in str(error) and not config:
            why = f"port {port} is in use, perhaps by a router of Zenoh"
            how = "to join that one: --zenoh localhost --zenoh-port 0"
            raise SiteError([f"--zenoh: {why}; {how}"]) from None
        where = f"cannot listen on {bind} port {port}" if port and not config else "cannot start"
        raise SiteError([f"--zenoh: {where}: {_plain(error)}"]) from None


def _endpoint(address: str) -> str:
    """Return an address that a user has written as Zenoh writes it. Raises: SiteError."""
    match = _ADDRESS.fullmatch(address)
    if not match or not 0 < int(match["port"] or PORT) < 2**16:
        message = f"--zenoh: '{address}' is not an address; write it like robot:7447"
        raise SiteError([message])
    return f"{(match['protocol'] or 'tcp').lower()}/{match['host']}:{match['port'] or PORT}"


def _set(settings: zenoh.Config, key: str, *, value: object) -> None:
    settings.insert_json5(key, json.dumps(value))


def _plain(error: zenoh.ZError) -> str:
    """Return what an error of Zenoh says to its users, without the layers of its own source."""
    text = str(error).splitlines()[0]
    if described := re.search(r'msg: "((?:[^"\\]|\\.)*)"', text):
        return described[1].partition(", expected")[0]
    innermost = re.split(r"\[|: (?=[A-Z])", re.sub(r" at /\S+", "", text))[-1]
    return re.sub(r" \(os error \d+\)", "", innermost).strip("]. ")
