"""Programs without ROS whose messages have their own fields, and a robot behind a gateway."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from pathlib import Path

import gateways
import pytest
from gateways import Gateway
from roweprograms import compiled

from sitegen.rowe import Endpoint

YAML = """\
rowe:
  kind: command
  topics:
    say: {topic: /tell, type: std_msgs/msg/String, fields: {text: data}, defaults: {data: nothing}}
    heard: {topic: /heard, fields: {text: data}}
  services:
    switch: {service: /set, fields: {"on": data}, reply: {fields: {done: success}}}
"""


@pytest.fixture(scope="module")
def mapped(robot: gateways.Process, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Gateway]:
    """A gateway that knows the fields of a program."""
    folder = tmp_path_factory.mktemp("rowe")
    (folder / "gateway.yaml").write_text(YAML)
    with gateways.gateway(folder=folder) as running:
        yield running


def test_a_program_has_its_own_fields(mapped: Gateway) -> None:
    with Endpoint() as program:
        program.connect(f"ws://127.0.0.1:{mapped.port}/rowe")
        answer = program.invoke({"command": "switch", "on": True}, 20).body
        assert (answer["command"], answer["done"]) == ("switch", True)
        program.send({"subscribe": "heard"})
        for given, expected in (({"text": "hello"}, "hello"), ({}, "nothing")):
            message = None
            while message is None or message.body.get("text") != expected:
                program.send({"command": "say", **given})
                message = program.receive(0.2)
            assert message.body == {"command": "heard", "text": expected}


def test_a_program_in_c_calls_a_service(mapped: Gateway, tmp_path: Path) -> None:
    program = compiled(tmp_path, "ask")
    url = f"ws://127.0.0.1:{mapped.port}/rowe"
    request = '{"command": "switch", "on": true}'
    found = subprocess.run(
        [program, url, request], stdout=subprocess.PIPE, text=True, timeout=60, check=True
    )
    assert '"done":true' in found.stdout


@pytest.mark.parametrize(
    ("body", "error"),
    [
        ({"command": "fly"}, "unknown command 'fly'; gateway.yaml names say, heard, switch"),
        ({"speed": 7}, "say what it is: command, key, subscribe, unsubscribe, serve, topic or"),
    ],
)
def test_what_is_wrong_is_told(mapped: Gateway, body: dict[str, object], error: str) -> None:
    with Endpoint() as program:
        program.connect(f"ws://127.0.0.1:{mapped.port}/rowe")
        program.send(body)
        message = program.receive(20)
        assert message is not None
        assert message.body["error"].startswith(error)
