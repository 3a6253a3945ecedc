"""The site that a gateway serves, and encryption."""

from __future__ import annotations

import os
import pty
import re
import signal
import subprocess
from pathlib import Path

import aiohttp
import gateways
import pytest
from gateways import Gateway, client, run
from native import Native
from yarl import URL

from sitegen.commands.gateway import qr_code


def test_a_page_of_the_site_and_nothing_else(robot: gateways.Process, tmp_path: Path) -> None:
    site = tmp_path / "dist"
    (site / "docs").mkdir(parents=True)
    (site / "index.html").write_text("<p>home")
    (site / "docs" / "index.html").write_text("<p>docs")
    (site / "a.js").write_text("export {}")
    (site / ".hidden").write_text("secret")
    (tmp_path / "secret.txt").write_text("secret")
    (site / "link").symlink_to(tmp_path / "secret.txt")

    async def work(running: Gateway) -> None:
        base = running.url.replace("ws:", "http:")
        async with aiohttp.ClientSession() as session:

            async def get(path: str) -> tuple[int, str, str]:
                address = URL(f"{base}{path}", encoded=True)
                async with session.get(address, allow_redirects=False) as answer:
                    kind = answer.headers.get("Content-Type", "")
                    return answer.status, kind, await answer.text()

            assert await get("") == (200, "text/html; charset=utf-8", "<p>home")
            assert (await get("docs/"))[2] == "<p>docs"
            assert (await get("docs"))[0] == 302
            assert (await get("a.js"))[1] == "text/javascript; charset=utf-8"
            for path in (
                ".hidden",
                "../secret.txt",
                "..%2fsecret.txt",
                "%2e%2e/secret.txt",
                "link",
                "none",
                "a.js%00",
                "//etc/passwd",
            ):
                status, _, text = await get(path)
                assert status in (400, 404) and "secret" not in text, path

    with gateways.gateway("--site", site, folder=tmp_path) as running:
        run(work(running))


def test_the_address_of_the_site_is_told_and_drawn_in_a_terminal(tmp_path: Path) -> None:
    site = tmp_path / "dist"
    site.mkdir()
    (site / "index.html").write_text("<p>home")
    native = Native()
    command: list[str | Path] = [native.python, "-m", "sitegen", "gateway", "--port", "0"]
    command += ["--bind", "0.0.0.0", "--site", site]
    ours, theirs = pty.openpty()
    with subprocess.Popen(
        command, env=gateways.environment(native), cwd=tmp_path, stdout=theirs, stderr=theirs
    ) as process:
        os.close(theirs)
        try:
            said = ""
            while "everyone on the network" not in said:
                said += os.read(ours, 4096).decode()
        finally:
            process.send_signal(signal.SIGINT)
    os.close(ours)
    lines = said.splitlines()
    found = re.fullmatch(r"the site: http://localhost:(\d+)/, for others (http://.+:\1/)", lines[1])
    assert found, said
    drawn = qr_code(found[2]).splitlines()
    assert len(drawn) > 10
    assert [line.rstrip() for line in lines[2 : 2 + len(drawn)]] == drawn


def test_an_encrypted_gateway(
    robot: gateways.Process, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))

    async def work(running: Gateway) -> None:
        async with client(running, ssl=False) as page:
            assert (await page.call("/set", {"data": True}))["result"]

    with gateways.gateway("--tls", "self-signed", folder=tmp_path) as running:
        assert running.url.startswith("wss:")
        running.expect("in each browser, once: open https://")
        run(work(running))
    assert (tmp_path / "sitegen/gateway/key.pem").stat().st_mode & 0o077 == 0


@pytest.mark.parametrize(
    ("rules", "options", "told"),
    [
        (
            "keys: {secret: none.secret}",
            [],
            "none.secret: no such file; make it and a first key with: sitegen gateway keys NAME",
        ),
        ("", ["--site", "none"], "none: no index.html here; build the site first: sitegen build"),
        (
            "",
            ["--bind", "192.0.2.99"],
            "cannot listen on 192.0.2.99 port 0: Cannot assign requested address; "
            "choose others with --bind and --port",
        ),
    ],
)
def test_what_keeps_a_gateway_from_starting(
    tmp_path: Path, rules: str, options: list[str], told: str
) -> None:
    if rules:
        (tmp_path / "gateway.yaml").write_text(rules)
    native = Native()
    command: list[str | Path] = [native.python, "-m", "sitegen", "gateway"]
    command += ["--port", "0", *options]
    started = gateways.Process(*command, env=gateways.environment(native), cwd=tmp_path)
    started.expect("1 problem")
    assert started.process.wait(20) == 1
    assert told in [line.removeprefix(f"{tmp_path}/") for line in started.lines]
    started.stop()
