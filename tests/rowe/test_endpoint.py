"""Endpoints of rowe: with each other, and with plain WebSockets."""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Iterator
from itertools import pairwise

import pytest
from websockets.exceptions import ConnectionClosedError
from websockets.sync.client import connect
from websockets.sync.server import serve

from sitegen.rowe import (
    Endpoint,
    InvalidMessage,
    Message,
    QueueFull,
    open_local_endpoint,
    open_remote_endpoint,
)


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
        (json.loads('{"a": ' + "[" * 200 + "]" * 200 + "}"), "nested more than 100 levels deep"),
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


def test_the_words_of_the_report() -> None:
    local = open_local_endpoint(0)
    remote = open_remote_endpoint("127.0.0.1", local.port)
    with local, remote:
        assert remote.send({"speed": 1}, 5)
        message = local.receive(5)
        assert message is not None
        assert message.body == {"speed": 1}
        with pytest.raises(OSError, match="address already in use"):
            open_local_endpoint(local.port)


def test_a_broadcast_reaches_all_peers(server: tuple[Endpoint, str]) -> None:
    lab, url = server
    with Endpoint() as one, Endpoint() as other:
        for name, robot in (("one", one), ("other", other)):
            robot.connect(f"{url}?name={name}")
            robot.send({})
            lab.receive(5)
        assert sorted(lab.broadcast({"stop": True}, 5)) == ["one", "other"]
        for robot in (one, other):
            message = robot.receive(5)
            assert message is not None
            assert message.body == {"stop": True}


def test_a_message_is_sent_as_it_was_when_it_was_queued() -> None:
    with Endpoint() as robot, Endpoint() as lab:
        body = {"speed": 1}
        robot.async_send(body)
        body["speed"] = 2
        robot.connect(f"ws://127.0.0.1:{lab.listen()}/")
        message = lab.receive(5)
        assert message is not None
        assert message.body == {"speed": 1}


def test_a_peer_that_vanishes_ends_the_call_to_it(server: tuple[Endpoint, str]) -> None:
    lab, url = server
    with connect(f"{url}?name=arm") as socket:
        socket.send('{"message_id": "1"}')
        request = lab.receive(5)
        assert request is not None

        def leave() -> None:
            socket.recv(5)
            socket.close()

        thread = threading.Thread(target=leave)
        thread.start()
        with pytest.raises(ConnectionError, match="'arm' left before it replied"):
            lab.invoke({"number": 1}, 20, to="arm")
        thread.join()
    while lab.peers():
        time.sleep(0.01)
    # Its program could not know this, and goes on.
    assert lab.reply(request, {"answer": 1}) is False
    lab.async_reply(request, {"answer": 1})


def test_close_ends_calls_in_other_threads() -> None:
    lab = open_local_endpoint()
    results: list[object] = []

    def invoke() -> None:
        try:
            lab.invoke({}, 60)
        except ConnectionError as error:
            results.append(str(error))

    threads = [
        threading.Thread(target=invoke),
        threading.Thread(target=lambda: results.append(lab.receive())),
        threading.Thread(target=lambda: results.append(lab.send({}))),
    ]
    for thread in threads:
        thread.start()
    while len(lab._endpoint._unaddressed) < 2:
        time.sleep(0.01)
    lab.close()
    for thread in threads:
        thread.join(5)
    assert sorted(map(str, results)) == ["False", "None", "the endpoint was closed"]
    with pytest.raises(RuntimeError, match="the endpoint is closed"):
        lab.send({})


def test_close_ends_a_connection_that_nobody_reads(server: tuple[Endpoint, str]) -> None:
    lab, url = server
    with Endpoint() as robot:
        robot.connect(url)
        assert robot.send({})
        begun = time.monotonic()
        lab.close()
        assert time.monotonic() - begun < 5


@pytest.mark.parametrize("url", ["http://robot/", "robot:9090", "ws://", "ws://[::1"])
def test_an_address_that_is_none_is_told_at_once(url: str) -> None:
    with Endpoint() as robot, pytest.raises(ValueError, match="is not the URL of a WebSocket"):
        robot.connect(url)


def test_a_queue_is_bounded_in_bytes() -> None:
    with Endpoint() as robot:
        with pytest.raises(QueueFull, match="the queue is full: 67 messages are waiting"):
            for _ in range(70):
                robot.async_send({"data": "x" * 1_000_000})
        # A time to live makes room again.
        assert robot.send({}, 0) is False


def test_a_server_that_hangs_up_is_asked_less_and_less_often() -> None:
    times: list[float] = []
    server = serve(lambda socket: times.append(time.monotonic()), "127.0.0.1", 0)
    port = server.socket.getsockname()[1]
    threading.Thread(target=server.serve_forever).start()
    with server, Endpoint() as robot:
        robot.connect(f"ws://127.0.0.1:{port}/")
        while len(times) < 5:
            time.sleep(0.01)
    pauses = [later - earlier for earlier, later in pairwise(times)]
    assert pauses[3] > 2 * pauses[1] > 2 * pauses[0] * 0.75


def test_what_is_wrong_is_logged_once_for_each_connection(
    server: tuple[Endpoint, str], caplog: pytest.LogCaptureFixture
) -> None:
    lab, url = server
    with connect(f"{url}?name=odd") as socket:
        for _ in range(3):
            socket.send('{"in_reply_to": "nobody"}')
        socket.send("{}")
        assert lab.receive(5)
        socket.send('{"a": "' + "x" * 1_100_000 + '"}')
        with pytest.raises(ConnectionClosedError):
            socket.recv(5)
    while lab.peers():
        time.sleep(0.01)
    assert [record.message for record in caplog.records] == [
        "odd: sent a reply that nobody waits for, or that came too late",
        "odd: a message is larger than 1048576 bytes, so the connection ends",
    ]


def test_many_threads_share_an_endpoint(server: tuple[Endpoint, str]) -> None:
    """Requests, messages and a program that replies, all at once, while peers come and go."""
    lab, url = server
    answers: list[int] = []
    got: list[Message] = []

    def reply() -> None:
        while (message := lab.receive()) is not None:
            if message.message_id:
                lab.async_reply(message, message.body)
            else:
                got.append(message)

    replying = [threading.Thread(target=reply) for _ in range(2)]
    with Endpoint() as robot:
        robot.connect(url)

        def ask(first: int) -> None:
            for number in range(first, first + 50):
                robot.async_send({"number": number})
                answers.append(robot.invoke({"number": number}, 20).body["number"])

        def come_and_go() -> None:
            for _ in range(20):
                with connect(url) as socket:
                    socket.send("{")

        asking = [threading.Thread(target=ask, args=(1000 * each,)) for each in range(4)]
        asking.append(threading.Thread(target=come_and_go))
        for thread in (*replying, *asking):
            thread.start()
        for thread in asking:
            thread.join(60)
    lab.close()
    for thread in replying:
        thread.join(5)
    expected = sorted(1000 * each + number for each in range(4) for number in range(50))
    assert sorted(answers) == expected
    assert sorted(message.body["number"] for message in got) == expected
