"""A page that has a script and no nodes, for which nothing is compiled."""

from __future__ import annotations

from pathlib import Path

import pytest
from browser import Serve
from paths import SITES
from playwright.sync_api import Page

from sitegen.build import make, write
from sitegen.options import Options
from sitegen.report import Report

SITE = """\
site: {title: Alone}
pages:
  - path: /
    title: Alone
    script: page.js
    content: [{markdown: Only text.}]
"""


@pytest.fixture(scope="session")
def alone(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a built site, whose page makes `ros` known to tests."""
    site = tmp_path_factory.mktemp("alone")
    (site / "site.yaml").write_text(SITE)
    (site / "page.js").write_text((SITES / "scripts/scripts/page.js").read_text())
    write(make(site, Report(), options=Options(draft=True)).artifacts, site / "dist")
    return site / "dist"


@pytest.fixture
def scripted(tab: Page, serve: Serve, alone: Path) -> Page:
    """That page, whose console must not show an error."""
    tab.goto(serve(alone))
    tab.wait_for_selector("body[data-scripted]")
    return tab
