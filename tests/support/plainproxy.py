"""A way to a gateway on which the subprotocol of pages is lost, so that it speaks rosbridge."""

from __future__ import annotations

import re
import socket
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass

HEADER = re.compile(rb"Sec-WebSocket-Protocol:[^\r]*\r\n", re.IGNORECASE)


@dataclass
class PlainProxy:
    """Listens at `http`; `cut` ends all connections."""

    target: int
    listener: socket.socket
    connections: list[socket.socket]

    @property
    def http(self) -> str:
        """Where the site of the gateway is, too."""
        return f"http://127.0.0.1:{self.listener.getsockname()[1]}/"

    def cut(self) -> None:
        """End what is open, on both sides."""
        while self.connections:
            with suppress(OSError):
                self.connections.pop().shutdown(socket.SHUT_RDWR)

    def serve(self) -> None:
        """Pass connections on until the listener is closed."""
        with suppress(OSError):
            while True:
                client, _ = self.listener.accept()
                threading.Thread(target=self._pass, args=(client,), daemon=True).start()

    def _pass(self, client: socket.socket) -> None:
        with client, socket.create_connection(("127.0.0.1", self.target)) as server:
            self.connections += [client, server]
            back = threading.Thread(target=_copy, args=(server, client, False), daemon=True)
            back.start()
            _copy(client, server, True)
            back.join()


def _copy(source: socket.socket, target: socket.socket, first: bool) -> None:
    with suppress(OSError):
        head = b""
        # A request may come in parts.
        while first and b"\r\n\r\n" not in head and (part := source.recv(65536)):
            head += part
        target.sendall(HEADER.sub(b"", head))
        while part := source.recv(65536):
            target.sendall(part)
    with suppress(OSError):
        target.shutdown(socket.SHUT_WR)


@contextmanager
def plain_proxy(port: int) -> Iterator[PlainProxy]:
    """Listen on a free port, for a gateway on `port`."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        proxy = PlainProxy(port, listener, [])
        threading.Thread(target=proxy.serve, daemon=True).start()
        yield proxy
        listener.shutdown(socket.SHUT_RDWR)
        proxy.cut()
