"""A panel in a graph that does what the test says."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

from paths import ROOT
from playwright.sync_api import Locator
from playwright.sync_api import Page as Tab

# By how many pixels a page is wider than the screen.
WIDER = "document.documentElement.scrollWidth - document.documentElement.clientWidth"


def set_up(folder: Path) -> None:
    """Put into an empty folder what a server needs for such a page, which a test may change."""
    shutil.copytree(ROOT / "tests/support/panels", folder, dirs_exist_ok=True)
    shutil.copytree(ROOT / "themes/default", folder / "theme")
    own = sorted((folder / "theme/widgets").glob("*.css"))
    (folder / "theme/own.css").write_text("".join(sheet.read_text() for sheet in own))
    # Large, and nobody's to change.
    (folder / "runtime").symlink_to(ROOT / "sitegen/runtime")


def show(page: Tab, kind: str, options: dict[str, Any] | None = None) -> Locator:
    page.evaluate(
        "async ([kind, options]) => { await show(kind, options); await frames(); }",
        [kind, options or {}],
    )
    return page.locator("#panel")


def add(page: Tab, kind: str, node: str, name: str, type: str, **qos: Any) -> None:
    page.evaluate("(endpoint) => ros.graph.add(...endpoint)", [kind, node, name, type, qos])


def chatter(page: Tab) -> None:
    add(page, "publisher", "/talker", "/chatter", "std_msgs/msg/String", program="talker")
    add(page, "subscription", "/listener", "/chatter", "std_msgs/msg/String", program="listener")


def serve_sums(page: Tab) -> None:
    add(page, "service", "/adder", "/add", "tutorial_interfaces/srv/AddTwoInts")
    page.evaluate("void (ros.answer = async ({ a, b }) => ({ sum: a + b }))")


def subscribed(page: Tab) -> list[str]:
    found: list[str] = page.evaluate(
        "ros.subscriptions.map(({topic, bytes}) => bytes ? `${topic} bytes` : topic).sort()"
    )
    return found


def stop_clock(page: Tab) -> None:
    """Let the page's time pass only when the test says so, by `page.clock.run_for`."""
    page.clock.install(time=0)
    page.clock.pause_at(3_600_000)


def hide_tab(page: Tab, hidden: bool) -> None:
    page.evaluate(
        """(state) => {
          Object.defineProperty(document, "visibilityState", { value: state, configurable: true });
          document.dispatchEvent(new Event("visibilitychange"));
        }""",
        "hidden" if hidden else "visible",
    )


def cells(panel: Locator) -> list[str]:
    return [" ".join(row.split()) for row in panel.locator("tbody tr").all_inner_texts()]
