"""A class on one graph: twenty pages on one gateway, each with its node in its own namespace."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from pathlib import Path

from browser import Built, serving
from classroom import classroom
from joined import Gateway
from pageclient import Client, connected, endpoint, record, text
from playwright.sync_api import Browser, Page, expect
from waiting import until

# Two are tabs of a browser; the others speak the protocol only.
CLASS, TABS = 20, 2
# Each page says its number again and again, and notes whom it hears on which topic.
TALK = """async ([number, others]) => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  const node = ros.node("/talker");
  const publisher = node.advertise("/chatter", "std_msgs/msg/String");
  setInterval(() => publisher.publish({ data: `from ${number}` }), 100);
  window.heard = {};
  for (const other of others) {
    const hear = ({ data }) => (window.heard[other] ??= new Set()).add(data);
    node.subscribe(`/student${other}/chatter`, "std_msgs/msg/String", hear);
  }
}"""
HEARD = "Object.entries(window.heard).map(([other, texts]) => [Number(other), [...texts]])"


def others(number: int) -> list[int]:
    return [each for each in range(CLASS) if each != number]


class Students:
    """The pages without a browser."""

    def __init__(self, gateway: Gateway) -> None:
        self._gateway = gateway
        self._ended = threading.Event()
        # By student: the topics that it hears, and what it has heard there.
        self.heard: dict[int, dict[int, set[str]]] = {n: {} for n in range(TABS, CLASS)}

    def end(self) -> None:
        self._ended.set()

    def run(self) -> None:
        """Take part until all of this ends."""
        asyncio.run(self._all())

    async def _all(self) -> None:
        await asyncio.gather(*(self._one(number) for number in self.heard))
        # aiohttp closes its sockets in later turns of the loop.
        await asyncio.sleep(0.1)

    async def _one(self, number: int) -> None:
        node, topic = f"/student{number}/talker", f"/student{number}/chatter"
        async with connected(self._gateway) as client:
            come = [
                endpoint(1, "node", node, "", node=node),
                endpoint(2, "publisher", topic, node=node),
            ]
            await client.say(op="graph", come=come, gone=[])
            hearing = asyncio.create_task(self._hear(client, number))
            while not self._ended.is_set():
                await client.socket.send_bytes(record(2, text(f"from {number}")))
                await asyncio.sleep(0.1)
            hearing.cancel()

    async def _hear(self, client: Client, number: int) -> None:
        opened: dict[int, int] = {}
        while await client.hear():
            for other in others(number):
                id = client.remote.get(f"publisher /student{other}/talker /student{other}/chatter")
                if id and other not in opened:
                    opened[other] = id
                    await client.say(op="open", id=id)
            self.heard[number] = {
                other: set(client.texts[id]) for other, id in opened.items() if id in client.texts
            }


@contextmanager
def students(gateway: Gateway) -> Iterator[Students]:
    found = Students(gateway)
    with ThreadPoolExecutor(1) as pool:
        work = pool.submit(found.run)
        try:
            yield found
        finally:
            found.end()
        work.result()


def test_twenty_pages_with_namespaces_of_their_own_hear_each_other(
    browser: Browser, gateway: Gateway, built: Built, tmp_path: Path
) -> None:
    tabs: list[Page] = []
    with ExitStack() as stack:
        sites = []
        for number in range(TABS):
            address = f"ws://127.0.0.1:{gateway.port}"
            site = classroom(tmp_path / str(number), address, f"/student{number}")
            sites.append(stack.enter_context(serving(built(site))))
        found = stack.enter_context(students(gateway))
        for number, address in enumerate(sites):
            tab = browser.new_context().new_page()
            stack.callback(tab.context.close)
            tab.goto(address)
            expect(tab.locator(".ros-connect-state")).to_contain_text("Connected to")
            tab.evaluate(TALK, [number, others(number)])
            tabs.append(tab)

        def heard() -> dict[int, dict[int, set[str]]]:
            of_tabs = {
                number: {other: set(texts) for other, texts in tab.evaluate(HEARD)}
                for number, tab in enumerate(tabs)
            }
            return of_tabs | found.heard

        # Each hears all others, and on each topic only the one whose it is.
        expected = {n: {other: {f"from {other}"} for other in others(n)} for n in range(CLASS)}
        until(lambda: heard() == expected, told=lambda: str(heard()))
        for number, tab in enumerate(tabs):
            people = tab.locator(".ros-connect-people")
            expect(people.locator("summary")).to_have_text("Here now: 20 pages")
            people.locator("summary").click()
            expect(people.locator("tbody tr")).to_have_count(CLASS)
            mine = people.locator("tbody tr", has_text="(you)")
            expect(mine).to_contain_text(f"/student{number}")
            for other in others(number):
                expect(people.get_by_text(f"/student{other}", exact=True)).to_have_count(1)
