"""Keys, and the command that makes them, without a gateway."""

from __future__ import annotations

from pathlib import Path

import pytest
from gateways import run

from sitegen.__main__ import main
from sitegen.errors import SiteError
from sitegen.gateway.keys import (
    Grant,
    Keys,
    RefusedError,
    answered,
    make_secret,
    read_secret,
    signed,
    verified,
)
from sitegen.gateway.rules import KeyRules

SECRET = b"s" * 64


def test_signed_keys() -> None:
    key = signed("Ada Lovelace", 60, SECRET)
    grant = verified(key, SECRET)
    assert grant and grant.person == "Ada Lovelace" and 58 < grant.seconds <= 60.1
    assert verified(key, b"t" * 64) is None
    body, _, signature = key.partition(".")
    for forged in (body, f"{body}.", f"{body}x.{signature}", f".{signature}", "", ".", "é.é"):
        assert verified(forged, SECRET) is None
    expired = verified(signed("Ada", -5, SECRET), SECRET)
    assert expired and expired.seconds < 0


@pytest.mark.parametrize(
    ("text", "grant"),
    [
        ("60", Grant("key id", 60, "id")),
        ('{"seconds": 5.5, "name": "Ada"}', Grant("Ada", 5.5, "id")),
        ('cb({"seconds": 5});', Grant("key id", 5, "id")),
        (" a.b ( 7 ) \n", Grant("key id", 7, "id")),
        ('{"seconds": 5, "name": "a\\nb"}', Grant("key id", 5, "id")),
        ('{"seconds": "5"}', None),
        ("true", None),
        ("NaN", None),
        ("[" * 100_000, None),
        ("", None),
    ],
)
def test_answers_of_a_service(text: str, grant: Grant | None) -> None:
    assert answered(text, "id") == grant


def test_wrong_keys_are_counted_by_network() -> None:
    async def work() -> list[str]:
        checks = Keys(KeyRules(tries=2))
        said = []
        for address in ("2001:db8::1", "2001:db8::2", "2001:db8::3", "2001:db8:0:1::1"):
            with pytest.raises(RefusedError) as error:
                await checks.check("wrong", address)
            said.append(str(error.value))
        return said

    wrong, many = "the key is not valid", "too many wrong keys; try again in a minute"
    assert run(work()) == [wrong, wrong, many, wrong]


def test_secrets_are_secret(tmp_path: Path) -> None:
    file = tmp_path / "gateway.secret"
    with pytest.raises(SiteError, match="no such file; make it and a first key with"):
        read_secret(file)
    assert make_secret(file) == read_secret(file)
    file.chmod(0o644)
    with pytest.raises(SiteError, match="others can read it; run: chmod 600"):
        read_secret(file)
    file.write_text("short")
    with pytest.raises(SiteError, match="shorter than 32 characters"):
        read_secret(file)


def test_the_command_makes_keys(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "gateway.yaml").write_text("keys: {secret: my.secret}")
    assert main(["gateway", "keys", "Ada", "--for", "20m"]) == 0
    said = capsys.readouterr()
    assert "made" in said.err and "my.secret" in said.err
    secret = read_secret(tmp_path / "my.secret")
    grant = verified(said.out.strip(), secret)
    assert grant and grant.person == "Ada" and 1190 < grant.seconds <= 1200.1
    assert main(["gateway", "keys", "Ada", "--for", "soon"]) == 1
    assert "'soon' is not a time; write it like 90s, 20m, 2h or 7d" in capsys.readouterr().err
    assert main(["gateway", "keys", "a/b"]) == 1
    assert "'a/b' is not a valid name" in capsys.readouterr().err


def test_a_service_that_does_not_answer() -> None:
    async def work() -> str:
        try:
            await Keys(KeyRules(service="http://127.0.0.1:9/?key={key}")).check("key", "::1")
        except RefusedError as error:
            return str(error)
        return ""

    assert run(work()) == "the service that knows the keys does not answer"
