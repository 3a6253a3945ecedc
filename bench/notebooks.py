"""Measure how soon Python answers: at the prompt, in a cell of a page, and in JupyterLab."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from statistics import median

from playwright.sync_api import Page

from bench.browser import chromium, serving_site
from bench.counts import Counts
from bench.figure import Figure

SITE = """
site: {title: Notebooks}
nodes:
  shell: {package: sitegen, executable: prompt}
pages:
  - {path: /, title: Prompt, content: [{prompt: shell}]}
  - {path: cells/, title: Cells, content: [{notebook: cells.md}]}
  - {path: lab/, title: Lab, content: [{jupyter: {notebooks: notebooks, open: one.ipynb}}]}
"""
CELL = {"cell_type": "code", "id": "a", "metadata": {}, "source": "6 * 7", "outputs": []}
# Without the name of a kernel, JupyterLab would ask for one.
KERNEL = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
NOTEBOOK = {"nbformat": 4, "nbformat_minor": 5, "metadata": KERNEL, "cells": [CELL]}


@contextmanager
def site() -> Iterator[str]:
    """Serve a page with each of them."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "notebooks").mkdir()
        (folder / "site.yaml").write_text(SITE)
        (folder / "cells.md").write_text("```python\n6 * 7\n```\n")
        (folder / "notebooks/one.ipynb").write_text(json.dumps(NOTEBOOK))
        with serving_site(folder) as url:
            yield url


def notebooks(counts: Counts) -> list[Figure]:
    """Times from navigation to the value of the first expression, with nothing in any cache."""
    ways = {"prompt": at_prompt, "cell of a page": in_cell, "cell of JupyterLab": in_lab}
    times: dict[str, list[float]] = {name: [] for name in ways}
    with site() as url, chromium() as browser:
        for _ in range((counts.starts + 1) // 2):
            for name, ask in ways.items():
                page = browser.new_context().new_page()
                ask(page, url)
                times[name].append(page.evaluate("performance.now()"))
                page.context.close()
    bare = median(times["prompt"])
    return [
        Figure(f"navigation → value in a {name}", "ms", median(found), bare)
        for name, found in times.items()
        if name != "prompt"
    ]


def at_prompt(page: Page, url: str) -> None:
    """Wait for the answer of the prompt."""
    page.goto(url)
    page.get_by_role("button", name="Start", exact=True).click()
    line = page.get_by_role("textbox").first
    line.fill("6 * 7")
    line.press("Enter")
    page.get_by_text("42", exact=True).wait_for()


def in_cell(page: Page, url: str) -> None:
    """Wait for the output of a cell in a page."""
    page.goto(f"{url}cells/")
    page.get_by_role("button", name="Run cell 1", exact=True).click()
    page.get_by_text("42", exact=True).wait_for()


def in_lab(page: Page, url: str) -> None:
    """Wait for the output of a cell in JupyterLab."""
    page.goto(f"{url}lab/")
    cell = page.frame_locator("iframe").locator(".jp-Notebook .jp-Cell").first
    cell.locator(".cm-content").click()
    page.keyboard.press("Shift+Enter")
    cell.get_by_text("42", exact=True).wait_for()
