"""The panel of the connection shows who else has joined the gateway."""

from __future__ import annotations

import json
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from browser import Built, serving
from classroom import classroom
from joined import Gateway
from playwright.sync_api import Browser, Locator, Page, expect
from websockets.exceptions import ConnectionClosed
from websockets.sync.server import ServerConnection, serve

# Of a page without nodes.
NONE = "\u2013"
NODE = """async (name) => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  window.node = ros.node(name);
}"""


def people(tab: Page) -> Locator:
    return tab.locator(".ros-connect-people")


def rows(tab: Page) -> list[list[str]]:
    """The visitors that the panel lists, without their times."""
    found = people(tab).locator("tbody tr").all()
    return [row.locator("th, td").all_inner_texts()[:-1] for row in found]


def test_pages_see_each_other_come_and_go(
    browser: Browser, gateway: Gateway, built: Built, tmp_path: Path
) -> None:
    sites = []
    for number, language in ((1, "en"), (2, "de")):
        address = f"ws://127.0.0.1:{gateway.port}"
        folder = tmp_path / str(number)
        sites.append(built(classroom(folder, address, f"/student{number}", language)))
    with serving(sites[0]) as first, serving(sites[1]) as second:
        tab = browser.new_context().new_page()
        tab.goto(first)
        expect(people(tab).locator("summary")).to_have_text("Here now: 1 page")
        people(tab).locator("summary").click()
        assert rows(tab) == [["visitor 1 (you)", NONE, "0"]]
        other = browser.new_context().new_page()
        other.goto(second)
        expect(people(tab).locator("summary")).to_have_text("Here now: 2 pages")
        expect(people(other).locator("summary")).to_have_text("Gerade hier: 2 Seiten")
        tab.evaluate(NODE, "/talker")
        for each in (tab, other):
            expect(people(each).locator("tbody")).to_contain_text("/student1")
        people(other).locator("summary").click()
        assert rows(tab) == [["visitor 1 (you)", "/student1", "1"], ["visitor 2", NONE, "0"]]
        assert rows(other) == [["Gast 2 (Sie)", NONE, "0"], ["Gast 1", "/student1", "1"]]
        # The time is that of the page, whatever the clock of the gateway says.
        for time in people(tab).locator("time").all():
            sent = f"Date.now() - new Date('{time.get_attribute('datetime')}')"
            assert 0 <= tab.evaluate(sent) < 60_000
        other.context.close()
        expect(people(tab).locator("summary")).to_have_text("Here now: 1 page")
        # What is open stays open.
        assert rows(tab) == [["visitor 1 (you)", "/student1", "1"]]
        tab.get_by_role("button", name="Disconnect").click()
        expect(people(tab)).to_be_hidden()


@contextmanager
def pretending(*messages: dict[str, Any]) -> Iterator[str]:
    """Run a server that says welcome to pages, and then what a gateway would not say."""

    def handle(socket: ServerConnection) -> None:
        welcome = {"op": "welcome", "time": 0, "rmw": "r", "domain": 0, "you": 1}
        try:
            socket.send(json.dumps({"op": "challenge", "keys": False}))
            socket.recv()
            for message in (welcome, *messages):
                socket.send(json.dumps(message))
            for _ in socket:
                pass
        except ConnectionClosed:
            pass

    protocols: Any = ["sitegen.1"]
    with serve(handle, "127.0.0.1", 0, subprotocols=protocols) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        yield f"ws://127.0.0.1:{server.socket.getsockname()[1]}"
        server.shutdown()
        thread.join()


def visitor(id: int, **more: object) -> dict[str, object]:
    return {"id": id, "name": "", "namespace": "/a", "nodes": 1, "since": 0, **more}


def test_what_a_hostile_gateway_says_is_text_and_bounded(
    tab: Page, built: Built, tmp_path: Path
) -> None:
    """Errors of the page fail the test."""
    wrong: list[object] = [
        None,
        5,
        "text",
        [],
        {},
        visitor(0),
        visitor(3, name=["a"]),
        visitor(4, name="x" * 300),
        visitor(5, namespace=None),
        visitor(6, nodes=-1),
        visitor(7, nodes="many"),
        visitor(8, since="now"),
        visitor(9, since=1e300),
        visitor(10, since=None),
    ]
    many = [visitor(id) for id in range(20, 320)]
    messages: list[dict[str, Any]] = [
        {"op": "people"},
        {"op": "people", "pages": 5, "more": -3, "others": "many"},
        {"op": "people", "pages": {"length": 3}, "more": [], "others": 0.5},
        {"op": "nobody knows this"},
        {"op": "people", "pages": [*wrong, visitor(1, name="<b>Ada</b>"), *many], "others": 1},
    ]
    with (
        pretending(*messages) as address,
        serving(built(classroom(tmp_path, address, "/student1"))) as site,
    ):
        tab.goto(site)
        # 200 of the 315 entries are looked at, and 14 of these are wrong.
        summary = "Here now: 301 pages and 1 other client"
        expect(people(tab).locator("summary")).to_have_text(summary)
        people(tab).locator("summary").click()
        found = rows(tab)
        assert len(found) == 200 - len(wrong)
        assert found[0] == ["<b>Ada</b> (you)", "/a", "1"]
        expect(people(tab)).to_contain_text("… and 115 more")
        assert tab.locator(".ros-connect b").count() == 0
        expect(tab.locator(".ros-connect-state")).to_contain_text("Connected to")


def test_a_gateway_that_does_not_tell_who_is_there_is_no_empty_list(
    tab: Page, built: Built, tmp_path: Path
) -> None:
    """An older one, or one with `people: false`."""
    with (
        pretending() as address,
        serving(built(classroom(tmp_path, address, "/student1"))) as site,
    ):
        tab.goto(site)
        expect(tab.locator(".ros-connect-state")).to_contain_text("Connected to")
        expect(people(tab)).to_be_hidden()
