"""Keys, allow-lists, limits, stops and recordings, with a native robot behind the gateway."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit

import aiohttp
import gateways
import pytest
from gateways import Client, Gateway, client, enter, key, run
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory

from sitegen.gateway.keys import make_secret

RULES = """
origins: [https://lab.example.org]
allow:
  subscribe: [/heard, /flood, /image]
  publish: [/cmd_vel, /tell]
  call_services: ["/*"]
  send_goals: [/fibonacci]
  get_parameters: ["/robot:*"]
  set_parameters: ["/robot:speed"]
limits: {subscriptions: 2, connections_per_address: 12, message_size: 20000, handshake: 3}
keys: {secret: gateway.secret, service: "http://127.0.0.1:PORT/key?key={key}", tries: 5}
stop: [/cmd_vel]
record: {folder: sessions}
"""
# What the operator's service answers, by key.
ANSWERS = {
    "json": '{"seconds": 60, "name": "Grace"}',
    "jsonp": 'callback({"seconds": 60, "name": "Grace"});',
    "number": "60",
    "over": '{"seconds": 0}',
    "rubbish": "<html>",
    "infinite": '{"seconds": 1e999}',
}


class Service(BaseHTTPRequestHandler):
    """The operator's service."""

    def do_GET(self) -> None:
        key = parse_qs(urlsplit(self.path).query)["key"][0]
        answer = ANSWERS.get(key, "").encode()
        self.send_response(200 if answer else 404)
        self.send_header("Content-Length", str(len(answer)))
        self.end_headers()
        self.wfile.write(answer)

    def log_message(self, format: str, *args: object) -> None:
        pass


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A folder with gateway.yaml, and the service that it names."""
    folder = tmp_path_factory.mktemp("protected")
    with ThreadingHTTPServer(("127.0.0.1", 0), Service) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        text = RULES.replace("PORT", str(server.server_port))
        (folder / "gateway.yaml").write_text(text)
        make_secret(folder / "gateway.secret")
        yield folder
        server.shutdown()


@pytest.fixture(scope="module")
def protected(robot: gateways.Process, folder: Path) -> Iterator[Gateway]:
    """A gateway with keys."""
    with gateways.gateway(folder=folder) as running:
        yield running


def test_nothing_comes_before_the_key(protected: Gateway, folder: Path) -> None:
    async def work() -> None:
        async with client(protected) as page:
            assert "needs a key" in (await page.next())["msg"]
            for op in ("subscribe", "publish", "advertise", "call_service"):
                await page.send(op=op, topic="/heard", service="/rosapi/topics", id=op)
                assert (await page.next())["msg"] == "a key comes first"
            answer = await enter(page, key(folder))
            assert answer["msg"] == "entered; the key is good for 60 s"
            assert (await page.call("/rosapi/topics"))["result"]

    run(work())
    protected.expect("granted for 60 s with the key")


def test_little_may_come_before_the_key(protected: Gateway) -> None:
    async def work(*messages: str) -> None:
        async with client(protected) as page:
            for message in messages:
                await page.socket.send_str(message)
            while (last := await page.next())["op"] != "closed":
                pass
            assert last["reason"] == "a key comes first"

    run(work("x" * 10_001))
    run(work(*["{}"] * 21))


@pytest.mark.parametrize("name", ["json", "jsonp", "number"])
def test_keys_of_a_service(protected: Gateway, name: str) -> None:
    async def work() -> None:
        async with client(protected) as page:
            assert "good for 60 s" in (await enter(page, name))["msg"]

    run(work())


def test_wrong_keys_are_refused_and_limited_in_rate(protected: Gateway, folder: Path) -> None:
    good = key(folder)
    body, _, signature = good.partition(".")
    other = key(folder, "Eve").partition(".")[0]
    wrong = {
        key(folder, seconds=-1): "the key has expired",
        f"{other}.{signature}": "the key is not valid",
        "over": "the key has expired",
        "rubbish": "the key is not valid",
        f"{body}.": "the key is not valid",
    }

    async def work() -> None:
        # An address of its own, so that other tests are not limited.
        connector = aiohttp.TCPConnector(local_addr=("127.0.0.2", 0))
        address = protected.url.replace("localhost", "127.0.0.1")
        async with (
            aiohttp.ClientSession(connector=connector) as session,
            session.ws_connect(address) as socket,
        ):
            page = Client(socket)
            for given, told in wrong.items():
                assert (await enter(page, given))["msg"] == told
            told = "too many wrong keys; try again in a minute"
            assert (await enter(page, good))["msg"] == told

    run(work())
    assert not any(good in line or signature in line for line in protected.lines)


def test_who_gives_no_key_is_let_go(protected: Gateway) -> None:
    async def work() -> None:
        async with client(protected) as page:
            while (message := await page.next())["op"] != "closed":
                pass
            assert (message["code"], message["reason"]) == (1000, "no key came in time")

    run(work())


def test_the_end_of_a_key(protected: Gateway, folder: Path) -> None:
    async def work() -> None:
        async with client(protected) as watcher, client(protected) as page:
            await enter(watcher, key(folder))
            await watcher.settle()
            await enter(page, key(folder, "Bob", 3))
            await page.send(op="subscribe", topic="/flood")
            await page.send(op="advertise", topic="/cmd_vel", type="geometry_msgs/Twist")
            twist = {"linear": {"x": 0.5}}
            while not any("drive 0.5 0" in str(one) for one in watcher.passed):
                await page.send(op="publish", topic="/cmd_vel", msg=twist)
                watcher.passed.append(await watcher.next())
            while (message := await page.next())["op"] != "closed":
                if message["op"] == "status":
                    page.passed.append(message)
            assert message["reason"] == "the key has ended"
            assert page.passed[-1]["msg"] == "the key has ended"
            stopped = {"data": "drive 0 0"}
            assert (await watcher.until("publish", msg=stopped))["msg"] == stopped

    run(work())
    protected.expect("Bob: stopped /cmd_vel")


@pytest.mark.parametrize(
    ("operation", "told"),
    [
        (
            {"op": "subscribe", "topic": "/scan"},
            "subscribing to /scan is not allowed",
        ),
        (
            {"op": "advertise", "topic": "/scan", "type": "std_msgs/String"},
            "publishing /scan is not allowed",
        ),
        (
            {"op": "subscribe", "topic": "/protected_door", "type": "std_msgs/String"},
            "/protected_door is protected",
        ),
        (
            {"op": "advertise_service", "service": "/x", "type": "std_srvs/Trigger"},
            "offering /x is not allowed",
        ),
        (
            {"op": "subscribe", "topic": "/rosout", "type": "rcl_interfaces/Log"},
            "subscribing to /rosout is not allowed",
        ),
    ],
)
def test_only_allowed_names_are_reachable(
    protected: Gateway, folder: Path, operation: dict[str, Any], told: str
) -> None:
    async def work() -> None:
        async with client(protected) as page:
            await enter(page, key(folder))
            await page.send(**operation)
            assert (await page.until("status"))["msg"] == told

    run(work())
    protected.expect(f"refused: {told}")


def test_parameters_are_reachable_as_parameters_only(protected: Gateway, folder: Path) -> None:
    async def work() -> None:
        async with client(protected) as page:
            await enter(page, key(folder))

            async def ask(verb: str, /, **args: Any) -> Any:
                return (await page.call(f"/rosapi/{verb}", args))["values"]

            assert (await ask("set_param", name="/robot:speed", value="1.5"))["successful"]
            refused = await ask("set_param", name="/robot:names", value='["c"]')
            assert refused["reason"] == "setting /robot:names is not allowed"
            # All parameters at once are more than the one that may be set.
            answer = await page.call("/robot/set_parameters", {"parameters": []})
            assert answer["values"] == "setting /robot:* is not allowed"
            assert (await page.call("/protected/set"))["values"] == "/protected/set is protected"
            nested = await page.call("/ns/deep", {}, timeout=1)
            assert nested["values"] == "calling /ns/deep is not allowed"

    run(work())


def test_limits(protected: Gateway, folder: Path) -> None:
    async def work() -> None:
        async with client(protected) as page:
            await enter(page, key(folder))
            for topic in ("/heard", "/flood", "/image"):
                await page.send(op="subscribe", topic=topic, throttle_rate=100)
            status = await page.until("status", level="error")
            assert status["msg"] == "subscribe: 2 topics are the limit"
            await page.send(op="publish", topic="/tell", msg={"data": "x" * 30_000})
            while (message := await page.next())["op"] != "closed":
                pass
            assert message["code"] == 1009

    run(work())


@pytest.mark.parametrize(
    ("origin", "code"),
    [
        ("https://lab.example.org", None),
        ("http://localhost:8000", None),
        ("https://evil.example.org", 1008),
        ("null", 1008),
    ],
)
def test_origins(protected: Gateway, origin: str, code: int | None) -> None:
    async def work() -> None:
        async with client(protected, headers={"Origin": origin}) as page:
            message = await page.next()
            if code is None:
                assert message["op"] == "status"
            else:
                assert message["code"] == code
                assert (
                    message["reason"] == f"pages of {origin} are not in 'origins' of gateway.yaml"
                )

    run(work())


def test_sessions_are_recorded(protected: Gateway, folder: Path) -> None:
    given = key(folder, "Carl")

    async def work() -> None:
        async with client(protected) as page:
            await enter(page, given)
            await page.settle()

    run(work())
    protected.expect("Carl: left")
    end = time.monotonic() + 10
    while not (files := list((folder / "sessions").glob("*_Carl_*.mcap"))) or not _ended(files[0]):
        assert time.monotonic() < end
        time.sleep(0.1)
    assert given.encode() not in files[0].read_bytes()
    with files[0].open("rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        [about] = [each.metadata for each in reader.iter_metadata()]
        assert (about["person"], about["why"]) == ("Carl", "left")
        found = {
            (channel.topic, channel.metadata["direction"], message.data)
            for _, channel, _, message in reader.iter_decoded_messages()
        }
    heard = [data for topic, direction, data in found if direction == "to client"]
    assert heard and {"/tell", "/heard"} == {topic for topic, _, _ in found}


def _ended(file: Path) -> bool:
    return file.read_bytes().endswith(b"\x89MCAP0\r\n")


def test_clients_cannot_forge_lines_of_the_log(protected: Gateway) -> None:
    async def work() -> None:
        async with client(protected) as page:
            await page.send(op="auth", key="\x1b[31m\n[fake] 127.0.0.1: granted")
            await page.until("status", level="error")

    run(work())
    assert not any(line.startswith("[fake]") or "\x1b" in line for line in protected.lines)
