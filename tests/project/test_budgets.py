"""What a page may cost: bytes, and nothing that moves while it loads. No figure here is a time."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest
from browser import Built, Serve
from paths import ROOT
from playwright.sync_api import Browser, Page

# As Lighthouse sums it: what moves, how far, unless the visitor has just done something.
SHIFTS = """
window.shifts = 0;
new PerformanceObserver((list) => {
  for (const shift of list.getEntries()) if (!shift.hadRecentInput) window.shifts += shift.value;
}).observe({ type: "layout-shift", buffered: true });
"""
# Where the first buttons are on the page, which may have scrolled.
TOP = """() => {
  const controls = document.querySelector(".ros-controls");
  return controls && Math.round(controls.getBoundingClientRect().top + scrollY);
}"""
KB = 1000


@dataclass(frozen=True)
class Budget:
    """Bytes, not compressed: of JavaScript up to the first line, and of all that the page loads.

    `files` are those that it has asked for by then: where few are asked for at once, each counts.
    """

    page: str
    script: int
    total: int
    files: int


# Somewhat more than they are; whoever needs more says why in the commit.
BUDGETS = [
    Budget("demo01/", 92 * KB, 290 * KB, 14),
    Budget("demo02/", 92 * KB, 290 * KB, 14),
    Budget("demo03/", 92 * KB, 290 * KB, 14),
    Budget("demo04/", 196 * KB, 434 * KB, 20),
    Budget("demo05/", 262 * KB, 480 * KB, 23),
    # 1,460 kB of these are bytecode of Python's library, which halves the time of a start.
    Budget("demo06/", 1450 * KB, 17600 * KB, 23),
    Budget("demo07/", 1450 * KB, 17608 * KB, 24),
    Budget("demo08/", 1850 * KB, 17950 * KB, 24),
    Budget("demo09/", 580 * KB, 1041 * KB, 22),
]


class Visit:
    """A first visit of a page, with what it asked the server for."""

    def __init__(self, dist: Path, url: str, tab: Page) -> None:
        self._dist, self._url = dist, url
        self.asked: dict[str, str] = {}
        tab.context.on("request", lambda request: self._note(request.url))

    def _note(self, address: str) -> None:
        if address.startswith(self._url):
            path = unquote(urlsplit(address).path).removeprefix("/")
            path = f"{path}index.html" if not path or path.endswith("/") else path
            self.asked[path] = address

    def size(self, *suffixes: str) -> int:
        """Return the bytes of the files with one of these suffixes, or of all."""
        paths = [path for path in self.asked if not suffixes or path.endswith(suffixes)]
        return sum((self._dist / path).stat().st_size for path in paths)


@pytest.fixture
def dist(built: Built) -> Path:
    return built(ROOT)


@pytest.fixture(params=[390, 1280])
def tab(browser: Browser, request: pytest.FixtureRequest) -> Iterator[Page]:
    context = browser.new_context(viewport={"width": request.param, "height": 800})
    context.add_init_script(SHIFTS)
    yield context.new_page()
    context.close()


@pytest.mark.parametrize("budget", BUDGETS, ids=lambda budget: budget.page.rstrip("/"))
def test_a_page_keeps_its_budget(budget: Budget, dist: Path, serve: Serve, tab: Page) -> None:
    url = serve(dist)
    visit = Visit(dist, url, tab)
    tab.goto(url + budget.page)
    tab.wait_for_load_state("networkidle")
    assert tab.evaluate("window.shifts") < 0.1
    start = tab.get_by_role("button", name=re.compile("Start|Run")).first
    before = tab.evaluate(TOP)
    if start.count():
        start.click()
    # The consoles of a stage may be folded; turtlesim has a turtle instead.
    effect = "[role=log] div, .ros-turtle"
    tab.wait_for_selector(effect, state="attached", timeout=60_000)
    script, total = visit.size(".js", ".mjs"), visit.size()
    assert script <= budget.script
    assert total <= budget.total
    assert len(visit.asked) <= budget.files
    # Consoles grow as lines come; what was pressed stays where it is.
    assert tab.evaluate(TOP) == before


@pytest.mark.parametrize("path", ["demo10/", "demo11/"])
def test_a_view_takes_the_place_that_was_kept_for_it(
    path: str, dist: Path, serve: Serve, tab: Page
) -> None:
    url = serve(dist)
    view = tab.locator(".ros-3d").first
    tab.route("**/*.js*", lambda route: route.abort())
    tab.goto(url + path)
    kept = view.bounding_box()
    tab.unroute("**/*.js*")
    tab.goto(url + path)
    tab.wait_for_selector(".ros-3d summary")
    shown = view.bounding_box()
    assert kept
    assert shown
    assert abs(kept["height"] - shown["height"]) <= 1


def test_programs_and_images_have_addresses_that_can_be_kept_for_good(
    dist: Path, serve: Serve, tab: Page
) -> None:
    for file in dist.rglob("page.json"):
        for node in json.loads(file.read_text())["nodes"].values():
            addresses = [a for build in node.get("builds", {}).values() for a in build.values()]
            addresses += node.get("python", {}).get("bundles", [])
            assert addresses
            assert all(re.search(r"\?v=[0-9a-f]{10}$", address) for address in addresses)
    for file in dist.rglob("index.html"):
        images = re.findall(r'<img [^>]*src="([^"]+)"', file.read_text())
        own = [image for image in images if not image.endswith("theme/favicon.svg")]
        assert all(re.search(r"\.[0-9a-f]{10}\.\w+$", image) for image in own)
