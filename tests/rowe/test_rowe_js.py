"""The JavaScript module of rowe: in a browser with a Python endpoint, and in Node as a server."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import opened, serving
from paths import ROOT
from playwright.sync_api import Browser, Page
from websockets.sync.client import connect

from sitegen.rowe import Endpoint

MODULES = ROOT / "sitegen" / "clients" / "rowe"


@pytest.fixture(scope="module")
def page(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    folder = tmp_path_factory.mktemp("rowe")
    for module in MODULES.glob("*.js"):
        (folder / module.name).write_text(module.read_text())
    html = "<!DOCTYPE html><link rel=icon href=data:,>"
    script = 'import { Endpoint } from "./rowe.js"; window.Endpoint = Endpoint;'
    (folder / "index.html").write_text(f"{html}<script type=module>{script}</script>")
    with serving(folder) as url, opened(browser) as tab:
        tab.goto(url)
        tab.wait_for_function("() => window.Endpoint")
        yield tab


@pytest.fixture
def lab(page: Page) -> Iterator[Endpoint]:
    with Endpoint() as endpoint:
        page.evaluate(
            "url => { window.robot = new Endpoint(); robot.connect(url, 'lab'); }", url(endpoint)
        )
        yield endpoint
        page.evaluate("() => robot.close()")


def url(endpoint: Endpoint) -> str:
    return f"ws://127.0.0.1:{endpoint.listen()}/?name=page"


def test_messages_and_calls_go_both_ways(page: Page, lab: Endpoint) -> None:
    assert page.evaluate("() => robot.send({ battery: 0.7 }, 5)") is True
    message = lab.receive(5)
    assert message is not None
    assert (message.body, message.peer) == ({"battery": 0.7}, "page")
    assert 4 < message.time_to_live <= 5
    page.evaluate(
        """() => (async () => {
          for await (const request of robot) {
            const { a, b } = request.body;
            await robot.reply(request, { sum: a + b });
          }
        })() && undefined"""
    )
    assert lab.invoke({"service": "add-two-numbers", "a": 38, "b": 4}).body == {"sum": 42}


def test_a_page_invokes(page: Page, lab: Endpoint) -> None:
    page.evaluate("() => { window.reply = robot.invoke({ number: 20 }); }")
    request = lab.receive(5)
    assert request is not None
    lab.reply(request, {"answer": request.body["number"] + 1})
    assert page.evaluate("async () => (await reply).body") == {"answer": 21}
    late = "robot.invoke({ number: 1 }, 0.1).catch((error) => error.message)"
    assert page.evaluate(f"() => {late}") == "no reply within 0.1 s"


def test_messages_expire_on_both_sides(page: Page, lab: Endpoint) -> None:
    alone = "const alone = new Endpoint(); const sent = alone.send({}, 0.1);"
    assert page.evaluate(f"async () => {{ {alone} return sent; }}") is False
    lab.send({"speed": 1}, ttl=0.2)
    lab.send({"speed": 2})
    page.wait_for_function("() => robot.peers().length === 1")
    page.wait_for_timeout(400)
    assert page.evaluate("async () => (await robot.receive(5)).body") == {"speed": 2}
    assert page.evaluate("() => robot.receive(0.05)") is None


def test_messages_wait_for_a_server(page: Page) -> None:
    with Endpoint() as endpoint:
        port = endpoint.listen()
    page.evaluate(
        """url => {
          window.robot = new Endpoint();
          for (let number = 0; number < 50; number += 1) robot.asyncSend({ number });
          robot.asyncSend({ number: -1 }, 0);
        }"""
    )
    with Endpoint() as endpoint:
        endpoint.listen(port)
        page.evaluate("url => { robot.connect(url); }", f"ws://127.0.0.1:{port}/")
        found = [endpoint.receive(10) for _ in range(50)]
        assert [message and message.body["number"] for message in found] == list(range(50))
        assert endpoint.receive(0.05) is None
        page.evaluate("() => robot.close()")


@pytest.mark.parametrize(
    ("expression", "reason"),
    [
        ("robot.asyncSend([])", "a message is a JSON object"),
        ("robot.asyncSend({ message_id: 1 })", "'message_id' is a field of rowe; use another name"),
        ("robot.asyncSend({}, 1, { to: 'x' })", "there is no peer named 'x'"),
        (
            "robot.asyncSend({}, -1)",
            "ttl: must be a number of seconds, 0 or more",
        ),
        (
            "robot.connect('http://robot/')",
            "'http://robot/' is not the URL of a WebSocket; write it",
        ),
        ("robot.connect('ws://127.0.0.1:9/', 'lab')", "there is a peer named 'lab' already"),
    ],
)
def test_errors_say_what_is_wrong(page: Page, lab: Endpoint, expression: str, reason: str) -> None:
    caught = f"() => {{ try {{ {expression}; }} catch (error) {{ return error.message; }} }}"
    assert page.evaluate(caught).startswith(reason)


def test_queues_agree_with_lists_in_any_order_of_operations(page: Page) -> None:
    assert (
        page.evaluate(
            """async () => {
          const { ExpiringQueue } = await import("./expiringQueue.js");
          const queue = new ExpiringQueue();
          const expected = [];
          let seed = 7;
          const chance = (n) => (seed = (seed * 48271) % 2147483647) % n;
          for (let number = 0; number < 20_000; number += 1) {
            if (chance(2)) {
              const ticket = queue.put(number, chance(2) ? 60 : undefined);
              expected.push({ ticket, number });
            } else if (chance(2)) {
              const taken = queue.take();
              if (taken?.item !== expected.shift()?.number) return `took ${taken?.item}`;
            } else if (expected.length) {
              const [{ ticket }] = expected.splice(chance(expected.length), 1);
              if (!queue.discard(ticket) || queue.discard(ticket)) return `discarded ${ticket}`;
            }
            if (queue.length !== expected.length) return `${queue.length}, not ${expected.length}`;
          }
          return "";
        }"""
        )
        == ""
    )


NODE = """
import { WebSocketServer } from "ws";
import { Endpoint } from "./sitegen/clients/rowe/rowe.js";
const server = new WebSocketServer({ port: 0, host: "127.0.0.1" });
const endpoint = new Endpoint({});
server.on("connection", (socket) => endpoint.accept(socket, "arm"));
server.on("listening", () => console.log(server.address().port));
for await (const request of endpoint) {
  if (request.body.end) break;
  endpoint.asyncReply(request, { sum: request.body.a + request.body.b });
}
endpoint.close();
server.close();
"""


def test_node_serves(tmp_path: Path) -> None:
    program = ["node", "--input-type=module", "--eval", NODE]
    with subprocess.Popen(program, cwd=ROOT, stdout=subprocess.PIPE, text=True) as node:
        assert node.stdout
        with connect(f"ws://127.0.0.1:{int(node.stdout.readline())}/") as socket:
            socket.send(json.dumps({"message_id": "1", "a": 38, "b": 4}))
            assert json.loads(socket.recv(5)) == {"in_reply_to": "1", "sum": 42}
            socket.send("nonsense")
            socket.send('{"end": true}')
        assert node.wait(10) == 0
