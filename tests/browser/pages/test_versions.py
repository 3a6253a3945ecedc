"""The choice among versions, on a plain host and below a path."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from browser import Serve
from playwright.sync_api import Browser, expect
from playwright.sync_api import Page as Tab

from sitegen.__main__ import main

SITE = """\
site: {title: Fox}
pages:
  - {path: /, file: index.md}
  - {path: den/, file: index.md}
"""


@pytest.fixture
def site(tmp_path: Path) -> Path:
    (tmp_path / "site.yaml").write_text(SITE)
    (tmp_path / "index.md").write_text("# Fox\n\n## Tail\n")
    assert main(["build", str(tmp_path), "--version", "1.0"]) == 0
    # The server of the tests compares times in whole seconds: a list written anew within the same
    # second would be "not modified".
    os.utime(tmp_path / "dist" / "versions.json", (0, 0))
    return tmp_path


def add(site: Path, version: str, *words: str) -> None:
    """Add a version that has another page instead of `den/`."""
    (site / "site.yaml").write_text(SITE.replace("den/", "hunt/"))
    assert main(["build", str(site), "--version", version, *words]) == 0


def test_an_old_version_leads_to_a_new_one(site: Path, tab: Tab, serve: Serve) -> None:
    url = serve(site / "dist", "/fox/")
    tab.goto(f"{url}1.0/den/")
    choice = tab.get_by_role("combobox", name="Version")
    tab.wait_for_load_state("networkidle")
    expect(choice).to_be_hidden()  # of one version, there is nothing to choose

    add(site, "1.1", "--alias", "latest")
    tab.reload()
    expect(choice.get_by_role("option")).to_have_text(["1.1 (latest)", "1.0"])
    expect(choice).to_have_value("1.0")
    tab.goto(f"{url}1.0/#tail")
    choice.select_option("1.1")
    expect(tab).to_have_url(f"{url}1.1/#tail")
    expect(choice).to_have_value("1.1")
    tab.go_back()
    expect(choice).to_have_value("1.0")


def test_arrow_keys_choose_and_enter_goes(site: Path, tab: Tab, serve: Serve) -> None:
    add(site, "1.1")
    add(site, "1.2")
    url = serve(site / "dist")
    tab.goto(f"{url}1.2/")
    choice = tab.get_by_role("combobox", name="Version")
    choice.press("ArrowDown")
    choice.press("ArrowDown")
    expect(choice).to_have_value("1.0")
    expect(tab).to_have_url(f"{url}1.2/")
    choice.press("Enter")
    expect(tab).to_have_url(f"{url}1.0/")


def test_a_page_that_is_not_there_leads_home(site: Path, browser: Browser, serve: Serve) -> None:
    add(site, "1.1")
    url = serve(site / "dist", "/fox/")
    # The browser notes in the console that it asked for a page that is not there.
    tab = browser.new_context().new_page()
    tab.goto(f"{url}1.0/den/")
    tab.get_by_role("combobox", name="Version").select_option("1.1")
    expect(tab).to_have_url(f"{url}1.1/")
    tab.context.close()


@pytest.mark.parametrize("script", [True, False], ids=["script", "none"])
def test_the_root_and_aliases_lead_to_a_version(
    site: Path, browser: Browser, serve: Serve, *, script: bool
) -> None:
    add(site, "1.1", "--alias", "latest")
    url = serve(site / "dist", "/fox/")
    context = browser.new_context(java_script_enabled=script)
    tab = context.new_page()
    tab.goto(url)
    expect(tab).to_have_url(f"{url}1.1/")
    # Only a script knows what follows the path.
    rest = "?a=b#tail" if script else ""
    tab.goto(f"{url}latest/hunt/{rest}")
    expect(tab).to_have_url(f"{url}1.1/hunt/{rest}")
    context.close()
