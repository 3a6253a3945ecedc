"""Programs without ROS at a gateway, with a native robot behind it."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import gateways
import pytest
from browser import Serve
from gateways import Gateway
from playwright.sync_api import Page
from websockets.sync.client import ClientConnection, connect

from sitegen.gateway.keys import make_secret
from sitegen.rowe import Endpoint

YAML = """\
allow:
  subscribe: ["/**"]
  publish: [/tell, /cmd_vel]
  call_services: [/set, /call_back]
  advertise_services: [/of_client]
rowe:
  topics:
    words: {topic: /tell}
    echo: {topic: /heard}
    drive: {topic: /cmd_vel, type: geometry_msgs/msg/Twist}
    other: {topic: /other, type: std_msgs/msg/String}
  services:
    switch: {service: /set}
    pressed: {service: /of_client, type: std_srvs/srv/Trigger}
"""


@pytest.fixture(scope="module")
def named(robot: gateways.Process, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Gateway]:
    """A gateway whose topics and services have names for programs without ROS."""
    folder = tmp_path_factory.mktemp("rowe")
    (folder / "gateway.yaml").write_text(YAML)
    with gateways.gateway(folder=folder) as running:
        yield running


def url(running: Gateway) -> str:
    return f"ws://127.0.0.1:{running.port}/rowe"


def ask(socket: ClientConnection, **body: Any) -> Any:
    socket.send(json.dumps(body))
    return json.loads(socket.recv(10))


def test_a_plain_socket_calls_a_service(named: Gateway) -> None:
    with connect(url(named)) as socket:
        answer = ask(socket, message_id="1", service="switch", data=True)
        assert answer == {
            "in_reply_to": "1",
            "service": "switch",
            "success": True,
            "message": answer["message"],
        }
        assert ask(socket, message_id="2", service="/set", data=True)["in_reply_to"] == "2"


def test_topics_go_both_ways(named: Gateway) -> None:
    with Endpoint() as program:
        program.connect(url(named))
        program.send({"subscribe": "echo"})
        # The subscription is known when the robot's answer to a call is there.
        program.invoke({"service": "switch", "data": True})
        for _ in range(50):
            program.send({"topic": "words", "data": "from a program without ROS"})
            message = program.receive(0.2)
            if message:
                break
        assert message is not None
        assert message.body == {"topic": "echo", "data": "from a program without ROS"}
        program.send({"unsubscribe": "echo"})
        assert program.send({"topic": "drive", "linear": {"x": 0.25}}, ttl=1)


def test_a_program_offers_a_service(named: Gateway) -> None:
    with Endpoint() as program:
        program.connect(url(named))
        program.send({"serve": "pressed"})
        program.async_send({"service": "/call_back"})
        request = program.receive(10)
        assert request is not None
        assert request.body == {"service": "pressed"}
        assert program.reply(request, {"success": True, "message": "pressed it"})


@pytest.mark.parametrize(
    ("body", "error"),
    [
        ({"message_id": "7", "service": "door"}, "unknown service 'door'; gateway.yaml names"),
        ({"topic": "/protected_door", "data": "x"}, "/protected_door is protected"),
        ({"topic": "other", "data": "x"}, "publishing /other is not allowed"),
        ({"topic": 7}, "topic: must be text"),
        ({"speed": 7}, "say what it is: key, subscribe, unsubscribe, serve, topic or service"),
        ({"service": "switch", "message_id": "8", "data": "yes"}, "data"),
    ],
)
def test_what_is_wrong_is_told(named: Gateway, body: dict[str, Any], error: str) -> None:
    with connect(url(named)) as socket:
        answer = ask(socket, **body)
        assert error in answer["error"], answer
        # The connection goes on.
        answer = ask(socket, message_id="9", service="switch", data=True)
        while "error" in answer:
            answer = json.loads(socket.recv(10))
        assert answer["in_reply_to"] == "9"


def test_a_page_imports_the_module_from_the_gateway(
    named: Gateway, tab: Page, serve: Serve, tmp_path: Path
) -> None:
    (tmp_path / "index.html").write_text("<!DOCTYPE html><link rel=icon href=data:,>")
    tab.goto(serve(tmp_path))
    found = tab.evaluate(
        """async (gateway) => {
          const { Endpoint } = await import(`${gateway}rowe/rowe.js`);
          const endpoint = new Endpoint();
          endpoint.connect(`${gateway.replace("http", "ws")}rowe`);
          const { body } = await endpoint.invoke({ service: "switch", data: true });
          endpoint.close();
          return body.success;
        }""",
        f"http://127.0.0.1:{named.port}/",
    )
    assert found is True


def test_a_key_comes_first(robot: gateways.Process, tmp_path: Path) -> None:
    make_secret(tmp_path / "gateway.secret")
    (tmp_path / "gateway.yaml").write_text("keys: {secret: gateway.secret}\n")
    with gateways.gateway(folder=tmp_path) as running:
        key = gateways.key(tmp_path)
        with connect(url(running)) as socket:
            assert "needs a key" in json.loads(socket.recv(10))["status"]
            for name in ("/set", "door"):
                answer = ask(socket, service=name, data=True, message_id="1")
                assert answer["error"] == "a key comes first"
            assert "entered" in ask(socket, key=key)["status"]
            assert ask(socket, service="/set", data=True, message_id="2")["success"] is True
