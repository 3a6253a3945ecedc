"""An editor that opens a file with the YAML language server, as VS Code and Neovim do."""

from __future__ import annotations

import json
import subprocess
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from paths import ROOT

SERVER = ROOT / "node_modules" / "yaml-language-server" / "bin" / "yaml-language-server"
# Nothing is fetched from elsewhere: what is found is what lies beside the file.
SETTINGS = {"yaml": {"validate": True, "completion": True, "schemaStore": {"enable": False}}}
# Seconds.
PATIENCE = 120


class Editor:
    """One file in an editor, and what the server says of it."""

    def __init__(self, process: subprocess.Popen[bytes], file: Path) -> None:
        self._process = process
        self._uri = file.resolve().as_uri()
        self._asked = 0
        self._ask("initialize", processId=None, rootUri=file.parent.as_uri(), capabilities={})
        self._tell("initialized")
        self._tell("workspace/didChangeConfiguration", settings=SETTINGS)
        document = {"uri": self._uri, "languageId": "yaml", "version": 1}
        text = file.read_text(encoding="utf-8")
        self._tell("textDocument/didOpen", textDocument={**document, "text": text})

    def diagnostics(self) -> list[tuple[int, str]]:
        """Return the line, counted from 0, and the message of each problem."""
        while True:
            message = self._read()
            if message.get("method") == "textDocument/publishDiagnostics":
                found = message["params"]["diagnostics"]
                return [(each["range"]["start"]["line"], each["message"]) for each in found]

    def completions(self, line: int, column: int) -> dict[str, str]:
        """Return what can be written at a place, each with its description."""
        where = {"line": line, "character": column}
        found = self._ask(
            "textDocument/completion", textDocument={"uri": self._uri}, position=where
        )
        return {each["label"]: str(each.get("documentation", "")) for each in found["items"]}

    def _ask(self, method: str, **parameters: object) -> Any:
        self._asked += 1
        self._write({"id": self._asked, "method": method, "params": parameters})
        while True:
            message = self._read()
            if message.get("id") == self._asked and "method" not in message:
                return message["result"]

    def _tell(self, method: str, **parameters: object) -> None:
        self._write({"method": method, "params": parameters})

    def _write(self, message: dict[str, object]) -> None:
        assert self._process.stdin
        data = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self._process.stdin.write(b"Content-Length: %d\r\n\r\n%b" % (len(data), data))
        self._process.stdin.flush()

    def _read(self) -> dict[str, Any]:
        assert self._process.stdout
        length = 0
        while line := self._process.stdout.readline().strip():
            name, _, value = line.partition(b":")
            length = int(value) if name.lower() == b"content-length" else length
        assert length, "the language server has ended"
        message: dict[str, Any] = json.loads(self._process.stdout.read(length))
        if "method" in message and "id" in message:
            self._write({"id": message["id"], "result": None})
        return message


@contextmanager
def editing(file: Path) -> Iterator[Editor]:
    """Open `file` in an editor."""
    command = ["node", str(SERVER), "--stdio"]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        # A server that says nothing would be waited for in vain.
        limit = threading.Timer(PATIENCE, process.kill)
        limit.start()
        try:
            yield Editor(process, file)
        finally:
            limit.cancel()
            process.kill()
