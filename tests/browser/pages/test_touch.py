"""Pages on a phone: large targets, placeholders that can be read, regions with distinct names."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import Built, Serve
from paths import ROOT
from playwright.sync_api import Browser, Page, expect
from touch import alike, pale_placeholders, small_targets

from sitegen.commands.build import build
from sitegen.config import load
from sitegen.report import Report

DEMOS = [page.path for page in load(ROOT / "site.yaml").pages if page.path.startswith("demo")]
SITE = """\
site: {title: Twice}
workspace: .
nodes:
  counter: {package: py_counter, executable: counter}
  shell: {package: sitegen, executable: prompt}
pages:
  - path: /
    title: Twice
    content:
      - stage: {show: {topics: }, nodes: [counter]}
      - console: counter
      - console: counter
      - log:
      - tabs:
          Log: {log: }
          Counter: [{editor: counter}, {console: counter}]
          Prompt: {prompt: shell}
"""


@pytest.fixture
def phone(browser: Browser) -> Iterator[Page]:
    context = browser.new_context(
        color_scheme="light",
        viewport={"width": 390, "height": 844},
        has_touch=True,
        is_mobile=True,
    )
    yield context.new_page()
    context.close()


def open_all(page: Page) -> None:
    """Show the consoles of stages."""
    for summary in page.locator("main summary").filter(visible=True).all():
        summary.click()


@pytest.mark.chromium
@pytest.mark.parametrize("path", DEMOS)
def test_a_demo_is_for_fingers_and_eyes(phone: Page, built: Built, serve: Serve, path: str) -> None:
    phone.goto(serve(built(ROOT)) + path)
    phone.wait_for_load_state("networkidle")
    open_all(phone)
    assert small_targets(phone) == []
    assert pale_placeholders(phone) == []
    assert alike(phone) == []
    phone.emulate_media(color_scheme="dark")
    assert pale_placeholders(phone) == []


@pytest.mark.chromium
def test_what_is_there_twice_has_two_names(phone: Page, tmp_path: Path, serve: Serve) -> None:
    folder = tmp_path / "site"
    shutil.copytree(ROOT / "demos/demo08/src", folder / "src")
    (folder / "site.yaml").write_text(SITE)
    build(folder, output=tmp_path / "dist", report=Report())
    phone.goto(serve(tmp_path / "dist"))
    phone.wait_for_load_state("networkidle")
    open_all(phone)
    for name in ("counter", "counter 2", "counter: Console output", "Log"):
        expect(phone.get_by_role("region", name=name, exact=True)).to_have_count(1)
    for name in ("counter", "counter 2", "counter 3", "counter 4"):
        log = phone.get_by_role("log", name=name, exact=True, include_hidden=True)
        expect(log).to_have_count(1)
    for tab in ("Log", "Counter", "Prompt"):
        phone.locator(".tabbed-labels").get_by_text(tab, exact=True).click()
        assert small_targets(phone) == []
        assert pale_placeholders(phone) == []
    assert alike(phone) == []
