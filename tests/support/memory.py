"""What pages hold of a browser: memory, and what else there can be too much of."""

from __future__ import annotations

from pathlib import Path

from playwright.sync_api import Browser, Page


def resident(browser: Browser) -> int:
    """Memory of all renderers of a browser, in bytes."""
    session = browser.new_browser_cdp_session()
    processes = session.send("SystemInfo.getProcessInfo")["processInfo"]
    session.detach()
    pids = [process["id"] for process in processes if process["type"] == "renderer"]
    pages = [int(Path(f"/proc/{pid}/statm").read_text().split()[1]) for pid in pids]
    return sum(pages) * 4096


def held(page: Page) -> dict[str, float]:
    """What a page holds after a collection of garbage: its heap in bytes, elements, listeners."""
    session = page.context.new_cdp_session(page)
    session.send("Performance.enable")
    session.send("HeapProfiler.collectGarbage")
    metrics = {m["name"]: m["value"] for m in session.send("Performance.getMetrics")["metrics"]}
    session.detach()
    names = {"heap": "JSHeapUsedSize", "elements": "Nodes", "listeners": "JSEventListeners"}
    return {ours: metrics[theirs] for ours, theirs in names.items()}
