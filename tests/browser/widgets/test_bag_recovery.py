"""Recordings that nobody ended: the tab was closed, or the browser has no place for them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest
from bags import recorder
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from panel import Panel
from playwright.sync_api import Browser, BrowserContext, Error, Locator, expect
from playwright.sync_api import Page as Tab
from saving import saved

pytestmark = pytest.mark.chromium


@pytest.fixture
def url(bag_pages: str) -> str:
    return f"{bag_pages}record/"


@pytest.fixture
def visitor(browser: Browser) -> Iterator[BrowserContext]:
    context = browser.new_context()
    yield context
    context.close()


def status(tab: Tab) -> Locator:
    return recorder(tab).get_by_role("status").first


def record(visitor: BrowserContext, url: str) -> Tab:
    tab = visitor.new_page()
    tab.goto(url)
    Panel(tab, "sends").wait_for("sent 3")
    recorder(tab).get_by_role("button", name="Record", exact=True).click()
    expect(status(tab)).to_have_text(re.compile(r"Recording .* [1-9]\d\d+ messages"))
    return tab


def words(content: Path) -> list[str]:
    with content.open("rb") as stream:
        reader = make_reader(stream, validate_crcs=True, decoder_factories=[DecoderFactory()])
        return [one[3].data for one in reader.iter_decoded_messages(topics=["/words"])]


def save(tab: Tab, folder: Path) -> Path:
    with tab.expect_download() as download:
        recorder(tab).get_by_role("button", name=re.compile("^Save rosbag2")).first.click()
    path = folder / "saved.mcap"
    download.value.save_as(path)
    return path


def check(found: list[str], least: int) -> None:
    first = int(found[0].removeprefix("word "))
    assert len(found) >= least
    assert found == [f"word {first + number}" for number in range(len(found))]


# Lock the only recording as a tab does that writes it, until told.
LOCK = """async () => {
  const script = `onmessage = async ({ data }) => {
    if (data === "release") { access.close(); return; }
    const bags = await (await navigator.storage.getDirectory()).getDirectoryHandle("sitegen-bags");
    for await (const folder of bags.values())
      for await (const file of folder.values())
        globalThis.access = await file.createSyncAccessHandle();
    postMessage("locked");
  };`;
  window.locker = new Worker(URL.createObjectURL(new Blob([script], { type: "text/javascript" })));
  const locked = new Promise((resolve) => { locker.onmessage = resolve; });
  locker.postMessage("lock");
  await locked;
}"""


def crash(tab: Tab) -> None:
    with tab.expect_event("crash"), suppress(Error):
        tab.goto("chrome://crash")


def test_recordings_are_used_when_they_are_complete(
    visitor: BrowserContext, url: str, tmp_path: Path
) -> None:
    """A tab that has just been closed may still have its recording open."""
    writer = record(visitor, url)
    closing = visitor.new_page()
    closing.goto(url.removesuffix("record/"))
    crash(writer)
    closing.evaluate(LOCK)
    tab = visitor.new_page()
    tab.goto(url)
    recordings = recorder(tab).get_by_role("list", name="Recordings", include_hidden=True)
    expect(recordings).to_have_js_property("inert", True)
    closing.evaluate("locker.postMessage('release')")
    expect(recordings).to_contain_text("recovered")
    expect(recordings).to_have_js_property("inert", False)
    check(words(save(tab, tmp_path)), 8)


@pytest.mark.parametrize("how", ["closed", "crashed"])
def test_a_recording_survives_its_tab(
    visitor: BrowserContext, url: str, tmp_path: Path, how: str
) -> None:
    tab = record(visitor, url)
    if how == "closed":
        tab.close()
    else:
        crash(tab)
    again = visitor.new_page()
    again.goto(url)
    entry = recorder(again).get_by_role("listitem")
    expect(entry).to_have_count(1)
    if how == "crashed":  # a tab that is closed may have time to end it
        expect(entry).to_contain_text("recovered")
    check(words(save(again, tmp_path)), 8)
    entry.get_by_role("button", name=re.compile("^Open ")).click()
    player = again.get_by_role("region", name="Player", exact=True)
    expect(player.get_by_role("checkbox", name="/words")).to_be_checked()
    again.reload()
    expect(recorder(again).get_by_role("listitem")).not_to_contain_text("recovered")
    delete = recorder(again).get_by_role("button", name=re.compile("^Delete "))
    delete.click()
    expect(delete).to_have_text("Really delete?")
    delete.click()
    expect(recorder(again).get_by_role("listitem")).to_have_count(0)


def test_a_recording_that_another_tab_writes_is_left_alone(
    visitor: BrowserContext, url: str, tmp_path: Path
) -> None:
    tab = record(visitor, url)
    other = visitor.new_page()
    other.goto(url)
    expect(recorder(other).get_by_role("listitem")).to_have_count(1)
    expect(recorder(other).get_by_role("listitem")).not_to_contain_text("recovered")
    recorder(tab).get_by_role("button", name="Stop", exact=True).click()
    expect(status(tab)).to_contain_text("Recorded")
    check(words(save(tab, tmp_path)), 8)
    # The other tab has waited for the file, finds it ended, and does not write it again.
    recordings = recorder(other).get_by_role("list", name="Recordings")
    expect(recordings).to_have_js_property("inert", False)
    expect(recordings).not_to_contain_text("recovered")


def test_without_storage_it_is_in_memory_and_that_is_said(
    visitor: BrowserContext, url: str, tmp_path: Path
) -> None:
    # In a worker, the way to refuse is to have no such directory.
    visitor.route(
        re.compile("bagNode.js"),
        lambda route: route.fulfill(
            body="navigator.storage.getDirectory = () => Promise.reject(new Error('no'));\n"
            + route.fetch().text(),
            content_type="text/javascript",
        ),
    )
    tab = record(visitor, url)
    expect(status(tab)).to_contain_text("of at most 256 MB")
    expect(status(tab)).to_contain_text("keeps it in memory only")
    recorder(tab).get_by_role("button", name="Stop", exact=True).click()
    expect(status(tab)).to_contain_text("Recorded")
    _, content = saved(recorder(tab).get_by_role("button", name=re.compile("^Save rosbag2")))
    path = tmp_path / "saved.mcap"
    path.write_bytes(content)
    check(words(path), 8)
