"""gateway.yaml, names and origins, without a gateway."""

from __future__ import annotations

import re
from dataclasses import fields
from pathlib import Path

import pytest
from paths import ROOT

from sitegen.__main__ import main
from sitegen.errors import SiteError
from sitegen.gateway import origins
from sitegen.gateway.config import load
from sitegen.gateway.log import Log
from sitegen.gateway.names import Use, refusal, subject
from sitegen.gateway.rules import Limits, Rules
from sitegen.gateway.schema import LIMITS


def rules(folder: Path, text: str) -> Rules:
    """Return the rules of a gateway.yaml."""
    file = folder / "gateway.yaml"
    file.write_text(text)
    return load(file)


def test_without_a_file_everything_is_allowed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert load(None) == Rules()
    (tmp_path / "gateway.yaml").write_text("allow: {subscribe: [/odom]}")
    found = load(None)
    assert found.allow and found.allow["subscribe"] == ("/odom",)
    assert found.allow["publish"] == ()


def test_defaults_are_those_of_the_data(tmp_path: Path) -> None:
    assert rules(tmp_path, "limits: {calls: 7}").limits == Limits(calls=7)
    assert [key.name for key in LIMITS] == [field.name for field in fields(Limits)]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("alow: {}", "gateway.yaml:1: alow: unknown key; did you mean 'allow'?"),
        ("", "gateway.yaml:1: yaml: the file is empty; start with 'allow: {subscribe: [/odom]}'"),
        (
            "allow:\n  subscribe: [odom]",
            "gateway.yaml:2: allow.subscribe[0]: 'odom' is not a pattern of names; "
            "write it like '/camera/**'",
        ),
        (
            "allow:\n  publish: [/protected/x]",
            "gateway.yaml:2: allow.publish[0]: '/protected/x' is protected and never reachable; "
            "remove it",
        ),
        (
            "allow:\n  set_parameters: [/robot]",
            "gateway.yaml:2: allow.set_parameters[0]: '/robot' names no parameter; "
            "write it like '/robot:speed'",
        ),
        (
            "limits: {calls: many}",
            "gateway.yaml:1: limits.calls: expected a whole number above 0, found the text "
            "'many'; write it like 'calls: 10'",
        ),
        (
            "keys:\n  service: http://lab.example.org/{key}",
            "gateway.yaml:2: keys.service: 'http://lab.example.org/{key}' is not an https address; "
            "write it like 'https://lab.example.org/…'",
        ),
        (
            "keys:\n  service: https://lab.example.org/",
            "gateway.yaml:2: keys.service: write {key} once, where the key belongs: "
            "'https://lab.example.org/?key={key}'",
        ),
        (
            "keys: {tries: 3}",
            "gateway.yaml:1: keys: say where keys come from: 'secret: gateway.secret', or "
            "'service: https://…'",
        ),
        (
            "reservations: {calendar: https://x.org/a.ics}",
            "gateway.yaml:1: reservations: appointments belong to keys; "
            "add 'keys: {secret: gateway.secret}'",
        ),
        (
            "keys: {secret: s}\nreservations: {calendar: none.ics}",
            "gateway.yaml:2: reservations.calendar: 'none.ics' does not exist; give an iCalendar "
            "file or an https address",
        ),
        (
            "origins: [lab.example.org]",
            "gateway.yaml:1: origins[0]: 'lab.example.org' is not an origin; "
            "write it like 'https://me.github.io'",
        ),
        (
            "stop: [cmd_vel]",
            "gateway.yaml:1: stop[0]: 'cmd_vel' is not the name of a topic; "
            "write it like '/cmd_vel'",
        ),
        ("record: {}", "gateway.yaml:1: record.folder: missing; write it like 'folder: sessions'"),
    ],
)
def test_mistakes_have_their_line(tmp_path: Path, text: str, message: str) -> None:
    with pytest.raises(SiteError) as error:
        rules(tmp_path, text)
    assert error.value.lines == [message]


@pytest.mark.parametrize(
    ("pattern", "name", "allowed"),
    [
        ("/odom", "/odom", True),
        ("/odom", "/odometry", False),
        ("/*", "/odom", True),
        ("/*", "/a/b", False),
        ("/a/**", "/a/b/c", True),
        ("/**", "/a/b/c", True),
        ("/a?", "/ab", True),
        ("/a.c", "/abc", False),
        ("/**", "/protected", False),
        ("/**", "/protectedDoor", False),
        ("/**", "/robot/protected_arm/state", False),
        ("/**", "/unprotected", True),
        ("/**", "/a b", False),
        ("/**", "a", False),
        ("/**", "/a\n", False),
        ("/**", "/" + "a" * 300, False),
    ],
)
def test_patterns_of_names(pattern: str, name: str, allowed: bool) -> None:
    assert (refusal("subscribe", name, [pattern]) == "") is allowed


@pytest.mark.parametrize(
    ("use", "name", "meant"),
    [
        ("call_services", "/a/_action/send_goal", ("send_goals", "/a")),
        ("subscribe", "/a/_action/feedback", ("send_goals", "/a")),
        ("publish", "/a/_action/status", ("advertise_actions", "/a")),
        ("advertise_services", "/a/_action/send_goal", ("advertise_actions", "/a")),
        ("call_services", "/n/set_parameters", ("set_parameters", "/n:*")),
        ("call_services", "/n/get_parameters", ("get_parameters", "/n:*")),
        ("subscribe", "/odom", ("subscribe", "/odom")),
    ],
)
def test_what_names_stand_for(use: Use, name: str, meant: tuple[Use, str]) -> None:
    assert subject(use, name) == meant


def test_one_parameter_does_not_allow_all() -> None:
    assert refusal("set_parameters", "/n:*", ["/n:speed"])
    assert refusal("set_parameters", "/n:*", ["/n:a*"])
    assert not refusal("set_parameters", "/n:*", ["/n:*"])
    assert not refusal("set_parameters", "/n:speed", ["/n:s*"])
    assert refusal("set_parameters", "/n:protected_speed", ["/**"])


@pytest.mark.parametrize(
    ("origin", "host", "allowed"),
    [
        (None, "robot:9090", True),
        ("http://localhost:8000", "robot:9090", True),
        ("http://192.168.1.5:9090", "192.168.1.5:9090", True),
        ("https://a.example.org", "robot:9090", True),
        ("https://b.example.com", "robot:9090", False),
        # A name that leads here does not make a page ours.
        ("http://evil.example.com:9090", "evil.example.com:9090", False),
        ("http://192.168.1.6", "192.168.1.5:9090", False),
        ("null", "robot:9090", False),
        ("http://[", "robot:9090", False),
    ],
)
def test_origins(origin: str | None, host: str, allowed: bool) -> None:
    assert origins.allows(origin, host, ["https://*.example.org"]) is allowed


def test_what_is_missing_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["gateway"]) == 1
    said = capsys.readouterr().err
    assert "the gateway needs ROS 2 beside it: source its setup.bash in this shell, or: " in said
    monkeypatch.setitem(__import__("sys").modules, "aiohttp", None)
    assert main(["gateway"]) == 1
    said = capsys.readouterr().err
    assert "the gateway needs aiohttp, which is not installed: pip install " in said


@pytest.mark.parametrize("page", ["operating.md", "gateway-yaml.md"])
def test_the_examples_of_the_documentation_are_right(page: str, tmp_path: Path) -> None:
    (tmp_path / "lab.ics").touch()
    text = (ROOT / "docs" / page).read_text("utf-8")
    examples = re.findall(r"^```yaml\n(.*?)^```$", text, flags=re.MULTILINE | re.DOTALL)
    assert examples
    for example in examples:
        rules(tmp_path, example)


def test_a_flood_of_lines_is_cut_short(monkeypatch: pytest.MonkeyPatch) -> None:
    said: list[str] = []
    log = Log(said.append)
    monkeypatch.setattr("sitegen.gateway.log.time.monotonic", lambda: 5.0)
    for number in range(1000):
        log.write(f"line {number}")
    assert len(said) == 100
    monkeypatch.setattr("sitegen.gateway.log.time.monotonic", lambda: 6.0)
    log.write("next")
    assert [line[9:] for line in said[100:]] == ["900 more lines were left out", "next"]
