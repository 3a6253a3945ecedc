"""Make processes and sockets, which are not available in the browser, raise an error at once.

Otherwise, connections would appear to succeed and never carry data.
"""

from __future__ import annotations

import errno
import socket
import subprocess
from collections.abc import Callable
from typing import Any, Never

NO_PROGRAMS = "other programs are not available in the browser"
NO_SOCKETS = "sockets are not available in the browser; use topics, services or actions"


def install() -> None:
    """Replace the functions that need a process or a socket."""
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
