"""What rmw_zenoh sends beside each message: who sent it, when, and which of the sender's it is."""

from __future__ import annotations

import struct
from dataclasses import dataclass

# The length of a gid comes before it.
_HEAD = struct.Struct("<qqB")
_GID = 16


@dataclass(frozen=True)
class Attachment:
    """The number of a message or request, when it was sent (ns since 1970), and who sent it."""

    sequence: int
    time: int
    gid: bytes

    def packed(self) -> bytes:
        """Return its bytes."""
        return _HEAD.pack(self.sequence, self.time, len(self.gid)) + self.gid


def unpack(data: bytes) -> Attachment | None:
    """Return what bytes say, None if they are no attachment of rmw_zenoh."""
    if len(data) != _HEAD.size + _GID:
        return None
    sequence, time, length = _HEAD.unpack_from(data)
    return Attachment(sequence, time, data[_HEAD.size :]) if length == _GID else None
