"""Nobody is kept out: axe-core finds nothing serious on any page, whatever its look and size."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import Built, Serve
from paths import ROOT
from playwright.sync_api import Browser
from playwright.sync_api import Page as Tab

from sitegen.config import load

EVERYTHING = ROOT / "tests/sites/prose"
AXE = (ROOT / "node_modules/axe-core/axe.min.js").read_text(encoding="utf-8")
SIZES = {"phone": (390, 844), "desktop": (1280, 900)}
# Colours do not depend on the size: both of each are looked at, if not each with each.
LOOKS = [("light", "phone"), ("dark", "desktop")]
PAGES = [
    (folder, path)
    for folder in (ROOT, EVERYTHING)
    for path in [page.path for page in load(folder / "site.yaml").pages]
] + [(EVERYTHING, "tags/"), (EVERYTHING, "tags/start/")]


def cases() -> list[object]:
    """Each page in both looks; the documentation, whose pages are alike, in one of them in turn."""
    found: list[object] = []
    for number, (folder, path) in enumerate(PAGES):
        for turn, look in enumerate(LOOKS):
            other = path.startswith("docs/") and number % len(LOOKS) != turn
            marks = [pytest.mark.exhaustive] if other else []
            name = f"{folder.name}/{path}-{'-'.join(look)}"
            found.append(pytest.param(look, folder, path, marks=marks, id=name))
    return found


@pytest.fixture(scope="module", params=LOOKS, ids=lambda look: "-".join(look))
def tab(browser: Browser, request: pytest.FixtureRequest) -> Iterator[Tab]:
    """A tab of one look. The test's own code may do what the page's policy forbids pages."""
    scheme, size = request.param
    width, height = SIZES[size]
    context = browser.new_context(
        color_scheme=scheme,
        viewport={"width": width, "height": height},
        reduced_motion="reduce",
        bypass_csp=True,
    )
    yield context.new_page()
    context.close()


def serious(tab: Tab) -> list[str]:
    """What axe-core finds that keeps somebody out."""
    tab.evaluate(AXE)
    found = tab.evaluate("axe.run({ resultTypes: ['violations'] })")
    return [
        f"{each['id']}: {node['target']} {node['any'][0]['message'] if node['any'] else ''}"
        for each in found["violations"]
        if each["impact"] in ("serious", "critical")
        for node in each["nodes"]
    ]


@pytest.mark.parametrize(("tab", "folder", "path"), cases(), indirect=["tab"])
def test_nothing_serious(folder: Path, path: str, tab: Tab, built: Built, serve: Serve) -> None:
    tab.goto(serve(built(folder)) + path)
    tab.wait_for_load_state("networkidle")
    assert serious(tab) == []
    assert tab.evaluate("document.documentElement.scrollWidth <= innerWidth")


def test_nothing_serious_in_the_search(tab: Tab, built: Built, serve: Serve) -> None:
    tab.goto(serve(built(EVERYTHING)))
    tab.keyboard.press("Control+k")
    tab.get_by_role("searchbox").fill("talker")
    tab.wait_for_selector("dialog li")
    assert serious(tab) == []


def test_nothing_serious_where_nodes_run(tab: Tab, built: Built, serve: Serve) -> None:
    tab.goto(f"{serve(built(EVERYTHING))}guide/nodes/")
    for name in ("talker", "listener"):
        tab.get_by_role("group", name=name).get_by_role("button", name="Start").click()
    tab.wait_for_function("() => document.querySelectorAll('.ros-console [role=log] *').length > 5")
    assert serious(tab) == []


def test_nothing_serious_in_what_is_shared(tab: Tab, built: Built, serve: Serve) -> None:
    # A link of another version, so that the page says so.
    tab.goto(f"{serve(built(EVERYTHING))}guide/nodes/#share=0.")
    tab.wait_for_selector(".ros-word")
    assert serious(tab) == []
    tab.get_by_role("button", name="Share").click()
    tab.wait_for_selector("dialog.share[open]")
    assert serious(tab) == []
    # All of it by the keyboard.
    for name in ("Copy", "Copy"):
        tab.keyboard.press("Tab")
        while tab.evaluate("document.activeElement.textContent.trim()") != name:
            tab.keyboard.press("Tab")
    tab.keyboard.press("Escape")
    assert not tab.is_visible("dialog.share")


def test_nothing_serious_in_a_frame_and_where_nothing_is(
    tab: Tab, built: Built, serve: Serve
) -> None:
    url = serve(built(EVERYTHING))
    for path in ("guide/nodes/?embed", "404.html"):
        tab.goto(url + path)
        tab.wait_for_load_state("networkidle")
        assert serious(tab) == []
