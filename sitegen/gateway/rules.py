"""What gateway.yaml says, as data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from sitegen.gateway.fieldmap import FieldMap
from sitegen.gateway.names import Use, refusal, subject


@dataclass(frozen=True)
class Limits:
    """What one client, and all of them together, may take; sizes in bytes, times in seconds."""

    connections: int = 200
    connections_per_address: int = 50
    message_size: int = 16_000_000
    messages_per_second: int = 2_000
    bytes_per_second: int = 50_000_000
    subscriptions: int = 200
    publishers: int = 200
    services: int = 100
    calls: int = 100
    # What waits for a client that reads slowly.
    queue_size: int = 32_000_000
    # Until a client has given its key.
    handshake: int = 10
    # A client whose connection takes nothing for so long is let go.
    stall: int = 30


@dataclass(frozen=True)
class KeyRules:
    """Where keys come from: a secret that signs them, an address that knows them, or both."""

    secret: Path | None = None
    service: str = ""
    # Wrong keys in a minute from one address.
    tries: int = 10


@dataclass(frozen=True)
class Reservations:
    """The calendar with the appointments of persons: a file, or an https address."""

    calendar: str
    # How often it is read again (s).
    refresh: int = 60
    # Whether those with a key may watch outside of their appointments.
    watch: bool = False


@dataclass(frozen=True)
class Recording:
    """Where sessions are recorded."""

    folder: Path
    # The largest recording (bytes).
    size: int = 1_000_000_000
    # The Git repository with the code used.
    repository: Path | None = None
    commit: bool = False


@dataclass(frozen=True)
class Named:
    """A topic or service that programs without ROS know by another name."""

    name: str
    # "" for that of the graph.
    type: str = ""
    # The fields of a message, or of a request.
    fields: FieldMap = field(default_factory=FieldMap)
    # Those of the reply of a service.
    reply: FieldMap = field(default_factory=FieldMap)


@dataclass(frozen=True)
class Rules:
    """What clients may do."""

    # By use: the patterns of names; None allows all.
    allow: Mapping[Use, tuple[str, ...]] | None = None
    limits: Limits = field(default_factory=Limits)
    # Besides those of this gateway itself and of this computer.
    origins: tuple[str, ...] = ()
    keys: KeyRules | None = None
    reservations: Reservations | None = None
    # Topics that get a last zero Twist when a client that published on them leaves.
    stop: tuple[str, ...] = ()
    recording: Recording | None = None
    # Whether pages see who else is there.
    people: bool = True
    # By the names that programs of rowe use.
    rowe_topics: Mapping[str, Named] = field(default_factory=dict)
    rowe_services: Mapping[str, Named] = field(default_factory=dict)
    # The field that says what a message of rowe is, besides `topic` and `service`.
    rowe_kind: str = ""

    def refusal(self, use: Use, name: str) -> str:
        """Return why clients may never use `name`, "" if they may."""
        use, name = subject(use, name)
        return refusal(use, name, None if self.allow is None else self.allow.get(use, ()))
