"""Measure how soon Python answers and hears: at the prompt, in cells, and in JupyterLab."""

from __future__ import annotations

import json
import re
import shutil
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from statistics import median

from playwright.sync_api import Locator, Page, Response

from bench.browser import chromium, serving_site
from bench.counts import Counts
from bench.figure import Figure

SITE = """
site: {title: Notebooks}
nodes:
  shell: {package: sitegen, executable: prompt}
  talker: {package: cpp_pubsub, executable: talker}
pages:
  - {path: /, title: Prompt, content: [{prompt: shell}]}
  - {path: cells/, title: Cells, content: [{notebook: cells.md}]}
  - {path: lab/, title: Lab, content: [{jupyter: {notebooks: notebooks, open: one.ipynb}}]}
  - {path: hear/, title: Prompt, content: [{prompt: shell}, {console: talker}]}
  - {path: hear-cells/, title: Cells, content: [{notebook: hear.md}, {console: talker}]}
  - path: hear-lab/
    title: Lab
    content: [{jupyter: {notebooks: notebooks, open: hear.ipynb}}, {console: talker}]
"""
# The C++ node that is heard.
TALKER = Path(__file__).parent.parent / "demos/demo03/src/cpp_pubsub"
MESSAGES = 9
# From the time that the publisher notes to the callback, in ms.
HEAR = f"""\
import time
import rclpy
from std_msgs.msg import String
if not rclpy.ok():
    rclpy.init()
node = rclpy.create_node("ear")
lags = []
def hear(message, info):
    lags.append(time.time_ns() - info["source_timestamp"])
subscription = node.create_subscription(String, "chatter", hear, 10)
while len(lags) < {MESSAGES}:
    rclpy.spin_once(node)
print(f"median {{sorted(lags)[{MESSAGES} // 2] / 1e6:.3f}} ms")
"""
MEDIAN = re.compile(r"median (\d+\.\d+) ms")
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
        (folder / "hear.md").write_text(f"```python\n{HEAR}```\n")
        shutil.copytree(TALKER, folder / "src/cpp_pubsub")
        (folder / "notebooks/one.ipynb").write_text(json.dumps(NOTEBOOK))
        hearing = {**NOTEBOOK, "cells": [{**CELL, "source": HEAR}]}
        (folder / "notebooks/hear.ipynb").write_text(json.dumps(hearing))
        with serving_site(folder) as url:
            yield url


def notebooks(counts: Counts) -> list[Figure]:
    """From navigation to the value of the first expression, with nothing in any cache.

    Then the way of a message of a C++ node to a callback, and the size of JupyterLab.
    """
    ways = {"prompt": at_prompt, "cell of a page": in_cell, "cell of JupyterLab": in_lab}
    times: dict[str, list[float]] = {name: [] for name in ways}
    lags = {
        "prompt": hear_at_prompt,
        "cell of a page": hear_in_cell,
        "cell of JupyterLab": hear_in_lab,
    }
    heard: dict[str, list[float]] = {name: [] for name in lags}
    with site() as url, chromium() as browser:
        for _ in range((counts.starts + 1) // 2):
            for name, ask in ways.items():
                page = browser.new_context().new_page()
                ask(page, url)
                times[name].append(page.evaluate("performance.now()"))
                page.context.close()
            for name, hear in lags.items():
                page = browser.new_context().new_page()
                heard[name].append(hear(page, url))
                page.context.close()
        loaded = size(browser.new_context().new_page(), url)
    return [
        *_beside_prompt("navigation → value in a {}", times),
        *_beside_prompt("C++ message → callback in a {}", heard),
        Figure("JupyterLab up to the first value, without Python", "MB", loaded),
    ]


def _beside_prompt(name: str, found: Mapping[str, Sequence[float]]) -> list[Figure]:
    bare = median(found["prompt"])
    return [
        Figure(name.format(way), "ms", median(each), bare)
        for way, each in found.items()
        if way != "prompt"
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


def hear_at_prompt(page: Page, url: str) -> float:
    """Return the median way of a message to a callback at the prompt, in ms."""
    page.goto(f"{url}hear/")
    page.get_by_role("button", name="Start", exact=True).first.click()
    line = page.get_by_role("textbox").first
    line.fill(f"exec({HEAR!r}, {{}})")
    line.press("Enter")
    return _median(page.get_by_role("log", name="shell", exact=True))


def hear_in_cell(page: Page, url: str) -> float:
    """Return the same in a cell of a page."""
    page.goto(f"{url}hear-cells/")
    page.get_by_role("button", name="Run cell 1", exact=True).click()
    return _median(page.locator(".ros-cell .ros-output"))


def hear_in_lab(page: Page, url: str) -> float:
    """Return the same in a cell of JupyterLab."""
    page.goto(f"{url}hear-lab/")
    cell = page.frame_locator("iframe").locator(".jp-Notebook .jp-Cell").first
    cell.locator(".cm-content").click()
    page.keyboard.press("Shift+Enter")
    return _median(cell.locator(".jp-OutputArea"))


def _median(output: Locator) -> float:
    found = output.get_by_text(MEDIAN).first
    found.wait_for()
    match = MEDIAN.search(found.inner_text())
    assert match
    return float(match[1])


def size(page: Page, url: str) -> float:
    """Return what JupyterLab itself adds to the first value in a cell, uncompressed, in MB."""
    sizes: dict[str, int] = {}

    def note(response: Response) -> None:
        if "/jupyter/" in response.url:
            sizes[response.url] = int(response.headers.get("content-length", 0))

    page.on("response", note)
    in_lab(page, url)
    return sum(sizes.values()) / 1e6
