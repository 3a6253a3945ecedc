"""Record a session to an MCAP file: who did what, and when."""

from __future__ import annotations

import datetime
import re
import subprocess
import time
from collections.abc import Callable
from typing import Any

from mcap.writer import CompressionType, Writer

from sitegen import __version__
from sitegen.gateway.rules import Recording

# What a recording is split into, so that it can be read as long as it was written (bytes).
CHUNK = 256_000


class Recorder:
    """One recording. A fault, such as a full disk, ends it with a line in the log."""

    def __init__(
        self,
        rules: Recording,
        who: dict[str, str],
        definition: Callable[[str], str],
        write: Callable[[str], None],
    ) -> None:
        self._rules = rules
        self._who = who
        self._definition = definition
        self._write = write
        self._channels: dict[tuple[str, str, str], int] = {}
        self._schemas: dict[str, int] = {}
        self._sequence = 0
        self._size = 0
        now = datetime.datetime.now().astimezone()
        self._began = now.isoformat(timespec="seconds")
        name = re.sub(r"[^\w.@-]+", "_", who["person"] or "anyone")[:60]
        stamp = now.strftime("%Y-%m-%dT%H-%M-%S")
        self.file = rules.folder / f"{stamp}_{name}_{who['session']}.mcap"
        self._writer: Writer | None = None
        try:
            rules.folder.mkdir(parents=True, exist_ok=True)
            self._out = self.file.open("xb")
            self._writer = Writer(self._out, CHUNK, CompressionType.LZ4)
            self._writer.start("ros2", f"sitegen {__version__}")
        except OSError as error:
            self._fail(error)

    def add(self, direction: str, topic: str, type_name: str, data: bytes, sent: int) -> None:
        """Record a message in CDR; `direction` is "from client" or "to client"."""
        if self._writer is None:
            return
        self._size += len(data)
        if self._size > self._rules.size:
            self.close("the recording is full")
            self._write(f"the recording {self.file.name} is full")
            return
        try:
            channel = self._channel(direction, topic, type_name)
            self._sequence += 1
            self._writer.add_message(channel, time.time_ns(), data, sent, self._sequence)
        except OSError as error:
            self._fail(error)

    def close(self, why: str) -> None:
        """End the recording."""
        writer, self._writer = self._writer, None
        if writer is None:
            return
        end = datetime.datetime.now().astimezone().isoformat(timespec="seconds")
        about = {**self._who, "began": self._began, "ended": end, "why": why, "code": self._code()}
        try:
            writer.add_metadata("session", about)
            writer.finish()  # type: ignore[no-untyped-call]
            self._out.close()
            self._commit()
        except OSError as error:
            self._fail(error)

    def _channel(self, direction: str, topic: str, type_name: str) -> int:
        writer: Any = self._writer
        key = (direction, topic, type_name)
        if key not in self._channels:
            if type_name not in self._schemas:
                text = self._definition(type_name).encode()
                self._schemas[type_name] = writer.register_schema(type_name, "ros2msg", text)
            about = {"direction": direction}
            schema = self._schemas[type_name]
            self._channels[key] = writer.register_channel(topic, "cdr", schema, about)
        return self._channels[key]

    def _code(self) -> str:
        """Return the state of the code used, as Git names it."""
        if self._rules.repository is None:
            return ""
        return self._git("describe", "--always", "--dirty", "--abbrev=40").strip()

    def _commit(self) -> None:
        if self._rules.repository and self._rules.commit:
            self._git("add", "--force", str(self.file.resolve()))
            who = self._who["person"] or "anyone"
            self._git(
                "commit", "--quiet", "-m", f"Add the session of {who}", str(self.file.resolve())
            )

    def _git(self, *words: str) -> str:
        command = ["git", "-C", str(self._rules.repository), *words]
        done = subprocess.run(command, text=True, capture_output=True, timeout=30)
        if done.returncode:
            self._write(f"git {words[0]}: {(done.stderr.splitlines() or ['failed'])[0]}")
            return ""
        return done.stdout

    def _fail(self, error: OSError) -> None:
        self._writer = None
        self._write(f"the session cannot be recorded: {error.strerror or error}: {self.file}")
