"""A program with rowe in Python: `serve PORT`, or `play PORT`, which prints what it found."""

from __future__ import annotations

import contextlib
import json
import sys
import threading
import time
from typing import Any

from sitegen.rowe import Endpoint, QueueFull, open_local_endpoint, open_remote_endpoint


def show(name: str, value: object) -> None:
    print(json.dumps([name, value]), flush=True)


def serve(port: int) -> None:
    endpoint = open_local_endpoint(port)
    print(endpoint.port, flush=True)
    while (message := endpoint.receive()) is not None:
        body: dict[str, Any] = message.body
        match body.get("do"):
            case "add":
                endpoint.reply(message, {"sum": body["a"] + body["b"]})
            case "count":
                for number in range(body["count"]):
                    endpoint.async_send({"number": number}, to=message.peer)
                endpoint.async_reply(message, {"done": True})
            case "ask":
                try:
                    answer = endpoint.invoke({"number": 20}, 5, to=message.peer)
                except ConnectionError:
                    print("gone", flush=True)
                else:
                    endpoint.send({"got": answer.body["number"]}, to=message.peer)
            case "rest":
                time.sleep(body["seconds"])
            case "broadcast":
                endpoint.reply(message, {"peers": len(endpoint.broadcast({"news": 1}))})
            case "ignore":
                pass
            case _:
                # A peer that does not read loses its echoes.
                with contextlib.suppress(QueueFull):
                    endpoint.async_send(body, to=message.peer)


def play(port: int) -> None:
    endpoint = open_remote_endpoint("127.0.0.1", port)
    show("sum", endpoint.invoke({"do": "add", "a": 38, "b": 4}).body["sum"])

    endpoint.invoke({"do": "count", "count": 100})
    numbers = [taken(endpoint)["number"] for _ in range(100)]
    show("order", numbers == list(range(100)))

    try:
        endpoint.invoke({"do": "ignore"}, 0.2)
    except TimeoutError:
        show("silence", "timeout")

    endpoint.send({"do": "ask"})
    request = endpoint.receive(5)
    assert request
    endpoint.reply(request, {"number": request.body["number"] + 1})
    show("asked", taken(endpoint)["got"])

    endpoint.send({"do": "rest", "seconds": 0.5})
    endpoint.send({"echo": 1}, 0.2)
    endpoint.send({"echo": 2})
    show("expired", taken(endpoint)["echo"])

    text = {"text": "ü€😀\n", "deep": [[{"a": None}]], "number": -0.5, "flag": True}
    endpoint.send(text, 5)
    show("echo", taken(endpoint))

    peers = endpoint.invoke({"do": "broadcast"}).body["peers"]
    show("broadcast", [peers, taken(endpoint)["news"]])

    found: list[bool] = []

    def ask(first: int) -> None:
        for b in range(25):
            answer = endpoint.invoke({"do": "add", "a": first, "b": b})
            found.append(answer.body["sum"] == first + b)

    threads = [threading.Thread(target=ask, args=(100 * first,)) for first in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    show("threads", found.count(True))

    with Endpoint() as alone:
        show("discarded", alone.send({}, 0.2))

    print("leave", flush=True)
    sys.stdin.readline()
    try:
        endpoint.invoke({"do": "ignore"}, 0.5)
    except TimeoutError:
        show("vanished", "timeout")
    endpoint.async_send({"echo": 3})
    print("return", flush=True)
    show("returned", taken(endpoint)["echo"])
    endpoint.close()


def taken(endpoint: Endpoint) -> dict[str, Any]:
    message = endpoint.receive(20)
    assert message
    return message.body


if __name__ == "__main__":
    {"serve": serve, "play": play}[sys.argv[1]](int(sys.argv[2]))
