"""Sites that work without a network, and what becomes of them when a new one is published."""

from __future__ import annotations

import contextlib
import io
import json
import os
import re
import shutil
import time
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
from browser import serving
from panel import Panel
from paths import ROOT
from PIL import Image
from playwright.sync_api import Browser, Error, Page, expect

from sitegen.commands.build import build
from sitegen.commands.serve.live import LiveSite
from sitegen.commands.serve.server import Server
from sitegen.report import Report
from sitegen.site.offline import worker

PREFIX = "/my-robot/"
CACHED = """async () => {
  const found = {};
  for (const name of await caches.keys()) {
    const requests = await (await caches.open(name)).keys();
    found[name] = requests.map(({ url }) => new URL(url).pathname).sort();
  }
  return found;
}"""
READY = "async () => (await navigator.serviceWorker.ready).active.state === 'activated'"


class Host:
    """A host of static files that can be switched off, and on again with other files."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._port = 0
        self._built = time.time() - 1000
        self._running = ExitStack()

    def on(self) -> str:
        url = self._running.enter_context(serving(self.folder / "dist", PREFIX, self._port))
        self._port = int(url.split(":")[2].split("/")[0])
        return url

    def off(self) -> None:
        self._running.close()

    def build(self) -> None:
        build(self.folder, output=self.folder / "dist", report=Report(io.StringIO()))
        # A server tells versions apart by the second, and these come faster than that.
        self._built += 10
        for file in (self.folder / "dist").rglob("*"):
            os.utime(file, (self._built, self._built))


@pytest.fixture
def host(tmp_path: Path) -> Iterator[Host]:
    """A host of demo03, where two nodes talk, and of a second page."""
    site = tmp_path / "site"
    shutil.copytree(ROOT / "demos/demo03", site, ignore=shutil.ignore_patterns("dist"))
    config = (site / "site.yaml").read_text().replace("site:\n", "site:\n  offline: true\n")
    page = "  - {path: more/, title: More, content: [{markdown: The first text.}]}\n"
    (site / "site.yaml").write_text(config.rstrip("\n") + f"\n{page}")
    host = Host(site)
    host.build()
    yield host
    host.off()


@pytest.fixture
def tab(browser: Browser) -> Iterator[Page]:
    """A tab of a new visitor; being without a network is no error."""
    context = browser.new_context()
    yield context.new_page()
    context.close()


def cached(tab: Page) -> dict[str, list[str]]:
    found: dict[str, list[str]] = tab.evaluate(CACHED)
    return found


def until(tab: Page, condition: str) -> None:
    """Wait for what a page cannot wait for itself: it may be loaded anew meanwhile."""
    for _ in range(600):
        with contextlib.suppress(Error):
            if tab.evaluate(condition):
                return
        tab.wait_for_timeout(100)
    raise AssertionError(condition)


def edit(host: Host, old: str, new: str) -> None:
    config = host.folder / "site.yaml"
    assert old in config.read_text()
    config.write_text(config.read_text().replace(old, new))
    host.build()


@pytest.mark.firefox
def test_nodes_run_when_the_server_is_gone(host: Host, tab: Page) -> None:
    url = host.on()
    tab.goto(url)
    until(tab, READY)
    host.off()
    tab.reload()
    Panel(tab, "listener").start()
    Panel(tab, "talker").start()
    Panel(tab, "listener").wait_for("Hello, world! 1")
    tab.goto(f"{url}more/")
    expect(tab.locator("main")).to_contain_text("The first text.")
    # Addresses of other forms, and those that are not there.
    tab.goto(f"{url}more?embed")
    assert tab.url == f"{url}more/?embed"
    tab.goto(f"{url}more/index.html")
    expect(tab.locator("main")).to_contain_text("The first text.")
    assert (answer := tab.goto(f"{url}nowhere/")) and answer.status == 404
    expect(tab.get_by_role("heading", name="Page not found")).to_be_visible()
    # A browser runs one form of each node, and keeps no other.
    (paths,) = cached(tab).values()
    assert [path for path in paths if ".asyncify." in path] == []
    assert [path for path in paths if not path.startswith(PREFIX)] == []


@pytest.mark.firefox
def test_scripts_and_cells_have_their_modules_when_the_server_is_gone(
    host: Host, tab: Page
) -> None:
    script = 'import { REVISION } from "sitegen/roslib";\ndocument.body.dataset.first = REVISION;\n'
    (host.folder / "first.js").write_text(script)
    script = 'import { ros } from "sitegen";\ndocument.body.dataset.second = typeof ros.node;\n'
    (host.folder / "second.js").write_text(script)
    code = 'import { ros } from "sitegen";\nconsole.log(typeof ros.node, "alone");'
    (host.folder / "cells.md").write_text(f"# Cells\n\n```js ros\n{code}\n```\n")
    pages = "scripts: [first.js, second.js],"
    edit(host, "{path: more/, title: More,", f"{{path: more/, title: More, {pages}")
    edit(host, "pages:\n", "pages:\n  - {path: cells/, file: cells.md}\n")
    url = host.on()
    tab.goto(url)
    until(tab, READY)
    host.off()
    tab.goto(f"{url}more/")
    tab.wait_for_selector("body[data-first='2.1.0'][data-second='function']")
    tab.goto(f"{url}cells/")
    tab.get_by_role("button", name="Run JavaScript cell 1", exact=True).click()
    expect(tab.locator(".ros-output")).to_have_text("function alone")


@pytest.mark.firefox
def test_what_somebody_else_wrote_into_the_cache_is_not_served(host: Host, tab: Page) -> None:
    """All pages of a server share its caches: a page without a policy would be served for good."""
    url = host.on()
    tab.goto(url)
    until(tab, READY)
    forged = """async (paths) => {
      for (const name of await caches.keys()) {
        const cache = await caches.open(name);
        for (const { url } of await cache.keys()) {
          if (!paths.includes(new URL(url).pathname)) continue;
          const { headers } = await cache.match(url);
          const html = "<script>document.title = 'forged'</script>";
          await cache.put(url, new Response(html, { headers }));
        }
      }
    }"""
    tab.evaluate(forged, [PREFIX, f"{PREFIX}more/"])
    tab.goto(f"{url}more/")
    expect(tab.get_by_text("The first text.")).to_be_visible()
    # Without the server, there is nothing instead of something forged.
    tab.evaluate(forged, [PREFIX, f"{PREFIX}more/"])
    host.off()
    with pytest.raises(Error):
        tab.goto(url)
    assert tab.title() != "forged"


@pytest.mark.firefox
def test_what_somebody_else_says_about_a_cached_file_is_not_believed(host: Host, tab: Page) -> None:
    """A script that is served as HTML would be a page without a policy."""
    url = host.on()
    tab.goto(url)
    until(tab, READY)
    tab.reload()
    tab.evaluate("""async () => {
      for (const name of await caches.keys()) {
        const cache = await caches.open(name);
        for (const { url } of await cache.keys()) {
          const content = await (await cache.match(url)).arrayBuffer();
          const headers = { "content-type": "text/html", refresh: "0;url=about:blank" };
          await cache.put(url, new Response(content, { status: 203, headers }));
        }
      }
    }""")
    host.off()
    told = tab.evaluate(
        """async (urls) => Promise.all(urls.map(async (url) => {
          const response = await fetch(url);
          return [response.status, Object.fromEntries(response.headers)];
        }))""",
        [f"{url}theme/page.js", f"{url}more/", f"{url}runtime/rosMain.js", f"{url}page.json"],
    )
    kinds = [
        *("text/javascript; charset=utf-8", "text/html; charset=utf-8"),
        *("text/javascript; charset=utf-8", "application/json"),
    ]
    assert told == [
        [200, {"content-type": kind, "x-content-type-options": "nosniff"}] for kind in kinds
    ]


@pytest.mark.firefox
def test_a_new_version_takes_nothing_from_an_old_cache_that_was_forged(
    host: Host, tab: Page
) -> None:
    """The next build has most files of the one before, and knows them by their content only."""
    url = host.on()
    tab.goto(f"{url}more/")
    until(tab, READY)
    edit(host, "The first text.", "The second text.")
    tab.evaluate("""async () => {
      for (const name of await caches.keys()) {
        const cache = await caches.open(name);
        for (const { url } of await cache.keys()) {
          if (!url.includes("/nodes/")) continue; // this page loads the others again
          // With all that the genuine one says of itself.
          const { headers } = await cache.match(url);
          const html = "<script>document.title = 'forged'</script>";
          await cache.put(url, new Response(html, { headers }));
        }
      }
    }""")
    tab.reload()
    tab.get_by_role("button", name="Reload").click()
    expect(tab.locator("main")).to_contain_text("The second text.")
    # They were fetched from the server, so the site works without one.
    host.off()
    tab.goto(url)
    Panel(tab, "talker").start()
    Panel(tab, "talker").wait_for("Hello")
    assert (
        tab.evaluate("""async () => {
      const forged = [];
      for (const name of await caches.keys()) {
        const cache = await caches.open(name);
        for (const { url } of await cache.keys()) {
          if ((await (await cache.match(url)).text()).includes("= 'forged'")) forged.push(url);
        }
      }
      return forged;
    }""")
        == []
    )


def test_a_new_version_comes_as_a_whole_and_the_old_one_goes(host: Host, tab: Page) -> None:
    url = host.on()
    tab.goto(f"{url}more/")
    until(tab, READY)
    (first,) = cached(tab)
    edit(host, "The first text.", "The second text.")
    tab.reload()
    # Still that of the version that the page began with, until the visitor wants the new one.
    expect(tab.locator("main")).to_contain_text("The first text.")
    expect(tab.get_by_text("A new version of this site is available.")).to_be_visible(
        timeout=30_000
    )
    assert len(cached(tab)) == 2
    other = tab.context.new_page()
    other.goto(url)
    other.evaluate("window.old = true")
    tab.get_by_role("button", name="Reload").click()
    expect(tab.locator("main")).to_contain_text("The second text.")
    # All tabs go with it: none is left between two versions.
    other.wait_for_function("() => window.old === undefined")
    until(tab, f"async () => !(await caches.keys()).includes({json.dumps(first)})")
    host.off()
    tab.reload()
    expect(tab.locator("main")).to_contain_text("The second text.")
    other.reload()
    Panel(other, "talker").start()
    Panel(other, "talker").wait_for("Hello")
    assert len(cached(tab)) == 1


def test_who_comes_back_later_has_the_new_version(host: Host, tab: Page) -> None:
    url = host.on()
    tab.goto(f"{url}more/")
    until(tab, READY)
    edit(host, "The first text.", "The second text.")
    tab.reload()
    until(tab, "async () => (await navigator.serviceWorker.getRegistration()).waiting !== null")
    # All pages of the site are closed, and it is visited again.
    context = tab.context
    tab.close()
    # The browser takes its time to see that the old version has no page any more.
    for _ in range(20):
        again = context.new_page()
        again.wait_for_timeout(1000)
        again.goto(f"{url}more/")
        text = again.locator("main").inner_text()
        again.close()
        if "The second text." in text:
            break
    assert "The second text." in text


def test_only_what_changed_is_fetched_again(host: Host, tab: Page) -> None:
    url = host.on()
    tab.goto(f"{url}more/")
    until(tab, READY)
    edit(host, "The first text.", "The second text.")
    # What is the same has to come from the old cache: the server has it no more.
    for file in (host.folder / "dist").rglob("*.wasm"):
        file.unlink()
    tab.reload()
    tab.get_by_role("button", name="Reload").click()
    expect(tab.locator("main")).to_contain_text("The second text.")
    host.off()
    tab.goto(url)
    Panel(tab, "talker").start()
    Panel(tab, "talker").wait_for("Hello")


def test_a_half_published_site_is_not_taken(host: Host, tab: Page) -> None:
    url = host.on()
    tab.goto(f"{url}more/")
    until(tab, READY)
    (first,) = cached(tab)
    before = (host.folder / "dist/more/index.html").read_bytes()
    edit(host, "The first text.", "The second text.")
    # The service worker is new, and the page is not yet.
    (host.folder / "dist/more/index.html").write_bytes(before)
    failed = """async () => {
      const registration = await navigator.serviceWorker.getRegistration();
      const worker = await new Promise((resolve) => {
        registration.addEventListener("updatefound", () => resolve(registration.installing));
        registration.update();
      });
      await new Promise((resolve) => {
        const look = () => { if (worker.state === "redundant") resolve(); };
        worker.addEventListener("statechange", look);
        look();
      });
    }"""
    tab.evaluate(failed)
    tab.reload()
    expect(tab.locator("main")).to_contain_text("The first text.")
    host.off()
    tab.reload()
    expect(tab.locator("main")).to_contain_text("The first text.")
    assert first in cached(tab)


def test_a_large_site_is_kept_page_by_page(
    host: Host, tab: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(worker, "WHOLE", 100_000)
    host.build()
    url = host.on()
    tab.goto(f"{url}more/")
    until(tab, READY)
    (paths,) = cached(tab).values()
    assert [path for path in paths if path.endswith(".wasm")] == []
    assert f"{PREFIX}runtime/rosMain.js" in paths
    tab.goto(url)
    # Both nodes are kept, though none of them ran.
    until(
        tab,
        """async () => {
          const cache = await caches.open((await caches.keys())[0]);
          const kept = (await cache.keys()).map(({ url }) => url);
          return kept.filter((url) => url.endsWith(".jspi.wasm")).length === 2
            && kept.filter((url) => url.endsWith(".jspi.js")).length === 2;
        }""",
    )
    host.off()
    tab.reload()
    Panel(tab, "talker").start()
    Panel(tab, "talker").wait_for("Hello")


def test_other_sites_of_the_server_are_left_alone(host: Host, tab: Page) -> None:
    url = host.on()
    tab.goto(url)
    tab.evaluate("async () => { await caches.open('of another site'); }")
    tab.evaluate("async () => { await caches.open('sitegen:http://127.0.0.1/:1'); }")
    until(tab, READY)
    edit(host, "The first text.", "The second text.")
    tab.reload()
    tab.get_by_role("button", name="Reload").click()
    until(tab, "async () => (await caches.keys()).length === 3")
    assert {"of another site", "sitegen:http://127.0.0.1/:1"} < set(cached(tab))
    scope = tab.evaluate("async () => (await navigator.serviceWorker.ready).scope")
    assert scope == url


@pytest.mark.firefox
def test_a_site_can_take_it_back(host: Host, tab: Page) -> None:
    url = host.on()
    tab.goto(f"{url}more/")
    until(tab, READY)
    tab.reload()
    edit(host, "offline: true", "offline: false")
    tab.evaluate("""async () => { (await navigator.serviceWorker.getRegistration()).update(); }""")
    until(
        tab,
        "async () => !(await navigator.serviceWorker.getRegistration())"
        " && (await caches.keys()).length === 0",
    )
    expect(tab.locator("link[rel=manifest]")).to_have_count(0)


def test_an_author_who_edits_sees_what_was_edited(host: Host) -> None:
    live = LiveSite(host.folder, Report(io.StringIO()))
    live.rebuild()
    page = live.file("index.html")
    assert page
    assert isinstance(page.source, bytes)
    assert b"manifest" not in page.source
    assert live.file("sw.js") is None
    with Server(live, 0) as server:
        import urllib.request

        with urllib.request.urlopen(f"{server.url}sw.js") as answer:
            assert answer.headers["Content-Type"] == "text/javascript; charset=utf-8"
            assert b"unregister" in answer.read()


def test_the_manifest_is_that_of_an_app(host: Host) -> None:
    dist = host.folder / "dist"
    manifest = json.loads((dist / "manifest.webmanifest").read_text())
    assert manifest["display"] == "standalone"
    assert manifest["scope"] == manifest["start_url"] == "./"
    shapes = {(icon["sizes"], icon["purpose"]) for icon in manifest["icons"]}
    assert {("192x192", "any"), ("512x512", "any"), ("512x512", "maskable")} <= shapes
    for icon in manifest["icons"]:
        with Image.open(dist / icon["src"]) as image:
            assert "x".join(map(str, image.size)) == icon["sizes"]
            # What a device cuts away may be anything, but not nothing.
            corner = image.convert("RGBA").getpixel((0, 0))
            assert isinstance(corner, tuple)
            assert corner[3] == (255 if icon["purpose"] == "maskable" else 0)
    policies = [
        re.findall(r'Content-Security-Policy" content="([^"]+)"', page.read_text())[0]
        for page in dist.rglob("index.html")
    ]
    assert all("worker-src" in policy and "manifest-src" in policy for policy in policies)
