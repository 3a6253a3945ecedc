"""The names and addresses of this computer."""

from __future__ import annotations

import socket

# Addresses that only this computer reaches, and those that stand for all of its addresses.
HERE = ("127.0.0.1", "localhost", "::1")
EVERYWHERE = ("0.0.0.0", "::")


def own_names(bind: str) -> list[str]:
    """Return names of a gateway that listens at `bind`; the last one is best for others."""
    host = socket.gethostname()
    names = ["localhost", "127.0.0.1", host, f"{host.partition('.')[0]}.local"]
    if bind in EVERYWHERE:
        try:
            with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
                # Sends nothing: it only asks which address would be used.
                probe.connect(("192.0.2.1", 9))
                names.append(probe.getsockname()[0])
        except OSError:
            pass
    else:
        names.append(bind)
    return list(dict.fromkeys(names))
