"""Endpoints of rowe: with each other, and with plain WebSockets."""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Iterator

import pytest
from websockets.sync.client import connect
from websockets.sync.server import serve

from sitegen.rowe import Endpoint, InvalidMessage


@pytest.fixture
def server() -> Iterator[tuple[Endpoint, str]]:
    with Endpoint() as endpoint:
        yield endpoint, f"ws://127.0.0.1:{endpoint.listen()}/"


def test_messages_go_both_ways(server: tuple[Endpoint, str]) -> None:
    lab, url = server
    with Endpoint() as robot:
        assert robot.connect(url, "lab") == "lab"
        assert robot.send({"battery": 0.7})
        message = lab.receive(5)
        assert message is not None
        assert message.body == {"battery": 0.7}
        assert lab.send({"speed": 1}, to=message.peer, ttl=2)
        back = robot.receive(5)
        assert back is not None
        assert (back.body, back.peer) == ({"speed": 1}, "lab")
        assert 0 < back.time_to_live <= 2
        assert robot.receive(0.05) is None


def test_the_example_of_the_report_from_a_plain_socket(server: tuple[Endpoint, str]) -> None:
    lab, url = server

    def add() -> None:
        request = lab.receive(5)
        assert request is not None
        lab.reply(request, {"sum": request.body["a"] + request.body["b"]})

    thread = threading.Thread(target=add)
    thread.start()
    with connect(url) as socket:
        request = {"message_id": "1", "service": "add-two-numbers", "a": 38, "b": 4}
        socket.send(json.dumps(request))
        assert json.loads(socket.recv(5)) == {"in_reply_to": "1", "sum": 42}
    thread.join()


def test_invoke_returns_its_own_reply(server: tuple[Endpoint, str]) -> None:
    lab, url = server

    def answer() -> None:
        first, second = lab.receive(5), lab.receive(5)
        assert first is not None
        assert second is not None
        lab.async_reply(second, {"answer": second.body["number"]})
        lab.async_reply(first, {"answer": first.body["number"]})

    with Endpoint() as robot:
        robot.connect(url)
        answers: dict[int, object] = {}

        def ask(number: int) -> None:
            answers[number] = robot.invoke({"number": number}).body["answer"]

        threads = [
            threading.Thread(target=task) for task in (answer, lambda: ask(1), lambda: ask(2))
        ]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    assert answers == {1: 1, 2: 2}


def test_invoke_without_a_reply_times_out_and_a_late_reply_is_dropped(
    server: tuple[Endpoint, str],
) -> None:
    lab, url = server
    with Endpoint() as robot:
        robot.connect(url)
        with pytest.raises(TimeoutError, match=r"no reply within 0\.2 s"):
            robot.invoke({"number": 1}, 0.2)
        lab.send({"next": True})
        following = robot.receive(5)
        assert following is not None
        assert following.body == {"next": True}


def test_a_message_expires_at_the_sender() -> None:
    with Endpoint() as robot:
        robot.connect("ws://127.0.0.1:9/")
        begin = time.monotonic()
        assert not robot.send({"speed": 1}, ttl=0.2)
        assert 0.15 < time.monotonic() - begin < 5


def test_a_message_expires_that_has_waited_for_a_first_peer() -> None:
    with Endpoint() as robot:
        results: list[bool] = []
        thread = threading.Thread(target=lambda: results.append(robot.send({}, ttl=0.4)))
        thread.start()
        time.sleep(0.1)
        robot.connect("ws://127.0.0.1:9/")
        thread.join(5)
        assert results == [False]


def test_a_message_that_is_being_sent_fails_with_its_connection() -> None:
    """The other side does not read what fills its buffers, and leaves."""
    server = serve(lambda _: time.sleep(1), "127.0.0.1", 0, max_queue=1, close_timeout=0.1)
    port = server.socket.getsockname()[1]
    threading.Thread(target=server.serve_forever).start()
    with server, Endpoint() as robot:
        robot.connect(f"ws://127.0.0.1:{port}/")
        results: list[bool] = []

        def send() -> None:
            while all(results):
                results.append(robot.send({"data": "x" * 1_000_000}, ttl=0.5))

        thread = threading.Thread(target=send, daemon=True)
        thread.start()
        thread.join(20)
        assert results[-1] is False


def test_a_message_expires_at_the_receiver(server: tuple[Endpoint, str]) -> None:
    lab, url = server
    with Endpoint() as robot:
        robot.connect(url)
        assert robot.send({"speed": 1}, ttl=0.3)
        assert robot.send({"speed": 2})
        time.sleep(0.5)
        message = lab.receive(5)
        assert message is not None
        assert message.body == {"speed": 2}


def test_messages_wait_for_a_server_that_starts_later() -> None:
    with Endpoint() as lab:
        port = lab.listen()
    with Endpoint() as robot:
        robot.connect(f"ws://127.0.0.1:{port}/")
        for number in range(100):
            robot.async_send({"number": number})
        with Endpoint() as lab:
            lab.listen(port)
            found = [lab.receive(10) for _ in range(100)]
        assert [message and message.body["number"] for message in found] == list(range(100))


def test_one_program_with_several_peers(server: tuple[Endpoint, str]) -> None:
    lab, url = server
    with Endpoint() as other, Endpoint() as robot:
        other_url = f"ws://127.0.0.1:{other.listen()}/?name=robot"
        robot.connect(f"{url}?name=robot", "lab")
        robot.connect(other_url, "other")
        with pytest.raises(ValueError, match="name the peer: one of lab, other"):
            robot.send({})
        with pytest.raises(ValueError, match="there is no peer named 'x'"):
            robot.send({}, to="x")
        robot.send({"to": "lab"}, to="lab")
        robot.send({"to": "other"}, to="other")
        for endpoint, name in ((lab, "lab"), (other, "other")):
            message = endpoint.receive(5)
            assert message is not None
            assert (message.body, message.peer) == ({"to": name}, "robot")
            assert endpoint.peers() == ["robot"]
        assert sorted(robot.peers()) == ["lab", "other"]


def test_what_waits_for_a_peer_that_left_is_discarded(server: tuple[Endpoint, str]) -> None:
    lab, url = server
    with connect(f"{url}?name=arm") as socket:
        socket.send("{}")
        assert lab.receive(5)
    while lab.peers():
        time.sleep(0.01)
    with pytest.raises(ValueError, match="there is no peer named 'arm'"):
        lab.send({}, to="arm")


@pytest.mark.parametrize(
    ("body", "reason"),
    [
        ([], "a message is a JSON object, not list"),
        ({"a": float("nan")}, "not valid JSON"),
        ({"a": {1}}, "not valid JSON"),
        ({"message_id": 1}, "'message_id' is a field of rowe; use another name"),
        ({"a": "x" * (1 << 20)}, "the message has 1048584 bytes; the limit is 1048576"),
    ],
)
def test_invalid_messages_are_not_sent(body: object, reason: str) -> None:
    with Endpoint() as robot, pytest.raises(InvalidMessage, match=reason):
        robot.async_send(body)  # type: ignore[arg-type]


def test_invalid_messages_that_arrive_are_dropped(
    server: tuple[Endpoint, str], caplog: pytest.LogCaptureFixture
) -> None:
    lab, url = server
    with connect(f"{url}?name=odd") as socket:
        for text in (
            "x",
            "[]",
            '{"message_id": 1}',
            '{"time_to_live": -1}',
            '{"time_to_live": NaN}',
            '{"time_to_live": true}',
            "[" * 100_000,
            b"{}",
            '{"right": 1}',
        ):
            socket.send(text)
        message = lab.receive(5)
        assert message is not None
        assert message.body == {"right": 1}
    assert [record.message for record in caplog.records] == [
        "odd: sent an invalid message: not valid JSON: Expecting value: line 1 column 1 (char 0)"
    ]
