"""What a page has none of, other programs and sockets: who asks for some is told so at once.

Left alone, connections would seem to be there, and never carry anything.
"""

from __future__ import annotations

import errno
import socket
import subprocess
from collections.abc import Callable
from typing import Any, Never

NO_PROGRAMS = "a page cannot start other programs"
NO_SOCKETS = "a page has no sockets; its nodes have topics, services and actions"


def install() -> None:
    """Refuse these."""
    subprocess.Popen.__init__ = _start  # type: ignore[assignment]
    for name in ("connect", "connect_ex", "bind", "listen", "sendto", "sendmsg"):
        setattr(socket.socket, name, _refusing(OSError, errno.ENETUNREACH))
    for name in ("getaddrinfo", "gethostbyname", "gethostbyname_ex", "gethostbyaddr"):
        setattr(socket, name, _refusing(socket.gaierror, socket.EAI_FAIL))


def _start(process: object, args: Any, *_: object, **__: object) -> Never:
    program = args if isinstance(args, (str, bytes)) else next(iter(args), "")
    raise OSError(errno.ENOSYS, NO_PROGRAMS, program)


def _refusing(kind: type[OSError], number: int) -> Callable[..., Never]:
    def refuse(*_: object, **__: object) -> Never:
        raise kind(number, NO_SOCKETS)

    return refuse
