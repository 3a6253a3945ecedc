"""Recordings and certificates, without a gateway."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest
from mcap.reader import make_reader

from sitegen.errors import SiteError
from sitegen.gateway import tls
from sitegen.gateway.recorder import Recorder
from sitegen.gateway.rules import Recording


def test_recordings_are_committed_with_the_code(tmp_path: Path) -> None:
    def git(*words: str) -> str:
        command = ["git", "-C", str(tmp_path), *words]
        return subprocess.run(command, text=True, capture_output=True, check=True).stdout

    git("init", "--quiet")
    git("config", "user.name", "Lab")
    git("config", "user.email", "lab@example.org")
    (tmp_path / "code.py").write_text("x = 1\n")
    git("add", "code.py")
    git("commit", "--quiet", "-m", "Add code")
    code = git("rev-parse", "HEAD").strip()
    said: list[str] = []
    who = {"session": "1a2b", "person": "Ada / ../x", "address": "::1", "key": "abc"}
    rules = Recording(tmp_path / "sessions", repository=tmp_path, commit=True)
    recorder = Recorder(rules, who, lambda name: "string data", said.append)
    recorder.add("from client", "/a", "std_msgs/msg/String", b"\0\1\0\0\1\0\0\0\0", 5)
    recorder.close("left")
    recorder.add("from client", "/a", "std_msgs/msg/String", b"", 5)
    assert said == []
    assert recorder.file.parent == tmp_path / "sessions"
    assert "Add the session of Ada" in git("log", "-1", "--format=%s")
    assert git("status", "--porcelain") == ""
    with recorder.file.open("rb") as file:
        [about] = [each.metadata for each in make_reader(file).iter_metadata()]
    assert (about["code"], about["person"], about["why"]) == (code, "Ada / ../x", "left")


def test_recordings_are_bounded(tmp_path: Path) -> None:
    said: list[str] = []
    who = {"session": "1", "person": "", "address": "::1", "key": ""}
    recorder = Recorder(Recording(tmp_path, size=1000), who, lambda name: "", said.append)
    for _ in range(3):
        recorder.add("to client", "/a", "std_msgs/msg/String", bytes(400), 5)
    assert said == [f"the recording {recorder.file.name} is full"]
    with recorder.file.open("rb") as file:
        assert len(list(make_reader(file).iter_messages())) == 2


def test_a_folder_that_cannot_be_written(tmp_path: Path) -> None:
    said: list[str] = []
    who = {"session": "1", "person": "", "address": "::1", "key": ""}
    (tmp_path / "file").touch()
    recorder = Recorder(Recording(tmp_path / "file"), who, lambda name: "", said.append)
    recorder.add("to client", "/a", "std_msgs/msg/String", b"", 5)
    recorder.close("left")
    [line] = said
    assert line.startswith("the session cannot be recorded: ")


def test_certificates(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    made = tls.context(["self-signed"], "0.0.0.0")
    assert "open https://" in made.advice[1]
    folder = tmp_path / "sitegen" / "gateway"
    pair = [str(folder / "certificate.pem"), str(folder / "key.pem")]
    before = (folder / "certificate.pem").read_bytes()
    assert tls.context(["self-signed"], "0.0.0.0").advice == made.advice
    assert (folder / "certificate.pem").read_bytes() == before
    # Another address needs another certificate.
    tls.context(["self-signed"], "192.0.2.7")
    assert (folder / "certificate.pem").read_bytes() != before
    assert tls.context(pair, "127.0.0.1").advice == ()
    for given, told in (
        (["none.pem", "none.pem"], "none.pem: no such file; --tls needs a certificate and its key"),
        (["cert.pem"], "--tls: give a certificate and its key, or: --tls self-signed"),
        ([pair[0], pair[0]], "not a PEM certificate and its key without a password"),
    ):
        with pytest.raises(SiteError, match=re.escape(told)):
            tls.context(given, "127.0.0.1")
