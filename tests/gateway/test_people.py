"""Pages are told who else is at the gateway, and nothing that is not theirs to know."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import aiohttp
import gateways
import pytest
from joined import Gateway
from native import Native
from pageclient import Client, connected, endpoint, run
from waiting import until

from sitegen.gateway.keys import make_secret
from sitegen.gateway.people import PAUSE


@pytest.fixture(scope="module")
def native() -> Native:
    return Native()


@pytest.fixture
def gateway(native: Native, tmp_path: Path) -> Iterator[Gateway]:
    gateway = Gateway(native, tmp_path / "log")
    yield gateway
    gateway.stop()


def last(client: Client) -> dict[str, Any]:
    """What the client was told last of who is there."""
    return [said for said in client.said if said["op"] == "people"][-1]


async def show(client: Client, expected: Sequence[tuple[object, ...]]) -> None:
    """Wait until the client is told of these pages."""
    await client.until(lambda: shown(client) == list(expected))


async def named(client: Client, *names: str) -> None:
    await client.until(lambda: len(client.there()) == len(names))
    assert [shown["name"] for shown in client.there()] == [*names]


async def clock(client: Client) -> float:
    """Return the time of the gateway (ms)."""
    await client.say(op="ping", id=1, sent=0)
    count = len(client.said)
    await client.until(lambda: any(said["op"] == "pong" for said in client.said[count:]))
    return float(client.said[-1]["time"])


def nodes(*names: str) -> list[dict[str, object]]:
    return [endpoint(id + 1, "node", name, "") for id, name in enumerate(names)]


def shown(client: Client) -> list[tuple[object, ...]]:
    return [(each["id"], each["namespace"], each["nodes"]) for each in client.there()]


def test_pages_see_who_joins_what_they_bring_and_who_leaves(gateway: Gateway) -> None:
    gateway.start()

    async def work() -> None:
        async with connected(gateway) as first:
            assert first.said[1]["you"] == 1
            await first.until(lambda: shown(first) == [(1, "", 0)])
            async with connected(gateway) as second, connected(gateway) as third:
                assert [each.said[1]["you"] for each in (second, third)] == [2, 3]
                come = nodes("/student2/talker", "/student2/arm/driver", "/_hidden")
                await second.say(op="graph", come=come, gone=[])
                await third.say(op="graph", come=nodes("/a/one", "/b/two"), gone=[])
                expected = [(1, "", 0), (2, "/student2", 2), (3, "/", 2)]
                for each in (first, second, third):
                    await show(each, expected)
                await second.say(op="graph", come=[], gone=[1])
                await first.until(lambda: (2, "/student2/arm", 1) in shown(first))
                await second.socket.close()
                await first.until(lambda: [one[0] for one in shown(first)] == [1, 3])
                # Whoever reloads the page is the same visitor again.
                async with connected(gateway) as again:
                    assert again.said[1]["you"] == 2
            await first.until(lambda: shown(first) == [(1, "", 0)])

    run(work)
    # The operator finds a visitor by the session.
    assert any("is visitor 2" in line for line in gateway.log)


def test_a_page_that_was_lost_is_the_same_visitor_since_it_came(gateway: Gateway) -> None:
    gateway.start()

    async def work() -> None:
        async with (
            connected(gateway) as first,
            connected(gateway) as second,
            connected(gateway, page="lost") as lost,
        ):
            await second.socket.close()
            await first.until(lambda: [one[0] for one in shown(first)] == [1, 3])
            before = first.there()
            async with connected(gateway, page="lost") as again:
                assert again.said[1]["you"] == lost.said[1]["you"] == 3
                # It is told, though nothing has changed for the first one.
                await again.until(again.there)
                assert again.there() == before

    run(work)


def test_other_clients_are_counted_and_nothing_private_is_told(gateway: Gateway) -> None:
    gateway.start()

    async def work() -> None:
        async with connected(gateway) as page:
            address = f"ws://127.0.0.1:{gateway.port}"
            async with (
                aiohttp.ClientSession() as session,
                session.ws_connect(address),
                session.ws_connect(f"{address}/rowe"),
            ):
                await page.until(lambda: page.there() and last(page)["others"] == 2)
                text = json.dumps(last(page))
                assert "127.0.0.1" not in text
                assert page.said[1]["session"] not in text
                [shown] = page.there()
                assert set(shown) == {"id", "name", "namespace", "nodes", "since"}
            await page.until(lambda: last(page)["others"] == 0)

    run(work)


def test_names_are_those_of_keys_without_the_address_of_mail(
    gateway: Gateway, tmp_path: Path
) -> None:
    make_secret(tmp_path / "gateway.secret")
    config = tmp_path / "gateway.yaml"
    config.write_text("keys: {secret: gateway.secret}\n")
    gateway.start(config=config)
    ada, bob = (gateways.key(tmp_path, name) for name in ("Ada Lovelace", "bob@example.org"))

    async def work() -> None:
        async with connected(gateway, key=ada) as one, connected(gateway, key=bob) as two:
            for each in (one, two):
                await named(each, "Ada Lovelace", "bob")
                assert not any(key in json.dumps(each.said) for key in (ada, bob))

    run(work)


def test_an_operator_can_tell_nobody(gateway: Gateway, tmp_path: Path) -> None:
    config = tmp_path / "gateway.yaml"
    config.write_text("people: false\n")
    gateway.start(config=config)

    async def work() -> None:
        async with connected(gateway) as first:
            async with connected(gateway) as second:
                assert first.said[1]["you"] is second.said[1]["you"] is None
            # News of people would have come by now, on the clock of the gateway.
            while await clock(first) < first.said[1]["time"] + 2000 * PAUSE:
                pass
            assert not any(said["op"] == "people" for said in first.said)

    run(work)
    until(lambda: any("left" in line for line in gateway.log))
    assert not any("visitor" in line for line in gateway.log)
