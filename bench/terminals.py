"""Measure how soon a terminal takes commands and has printed, and what it costs a page."""

from __future__ import annotations

import tempfile
from pathlib import Path
from statistics import median

from playwright.sync_api import Page

from bench.browser import chromium, serving_site
from bench.counts import Counts
from bench.crowd import SITE
from bench.figure import Figure, Target
from bench.plots import p99

PAGE = """
site: {title: Terminal}
pages: [{path: /, title: Terminal, content: [{terminal: }]}]
"""
ROWS = "[...document.querySelectorAll('.xterm-rows > div')].map((row) => row.textContent.trim())"
# Resolves with the time since navigation (ms) when a prompt is on the screen.
PROMPT = f"""async () => {{
  while ({ROWS}.findLast((row) => row) !== "$") {{
    await new Promise((done) => requestAnimationFrame(done));
  }}
  return performance.now();
}}"""
# Types a command, and resolves with the time (ms) until its output is on the screen.
COMMAND = f"""async () => {{
  const input = document.querySelector(".xterm-helper-textarea");
  const enter = {{ key: "Enter", keyCode: 13, bubbles: true, cancelable: true }};
  input.focus();
  const start = performance.now();
  const data = new DataTransfer();
  data.setData("text/plain", "ros2 topic list -c; echo printed");
  input.dispatchEvent(new ClipboardEvent("paste", {{ clipboardData: data, bubbles: true }}));
  input.dispatchEvent(new KeyboardEvent("keydown", enter));
  while (!{ROWS}.includes("printed")) {{
    await new Promise((done) => requestAnimationFrame(done));
  }}
  return performance.now() - start;
}}"""
# Presses Ctrl-C, and resolves with the time (ms) until the prompt is on the screen.
INTERRUPT = f"""async () => {{
  const input = document.querySelector(".xterm-helper-textarea");
  const start = performance.now();
  input.dispatchEvent(new KeyboardEvent("keydown", {{
    key: "c", keyCode: 67, ctrlKey: true, bubbles: true, cancelable: true,
  }}));
  while ({ROWS}.findLast((row) => row) !== "$") {{
    await new Promise((done) => requestAnimationFrame(done));
  }}
  return performance.now() - start;
}}"""


def terminals(counts: Counts) -> list[Figure]:
    """Times from navigation to the first prompt, and from Enter to the output of `ros2`."""
    starts, commands = [], []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "site.yaml").write_text(PAGE)
        with serving_site(folder) as url, chromium() as browser:
            for _ in range(counts.starts):
                page = browser.new_context().new_page()
                page.goto(url)
                starts.append(page.evaluate(PROMPT))
                commands.append(page.evaluate(COMMAND))
                page.context.close()
    return [
        Figure("terminal: navigation to prompt", "ms", median(starts)),
        Figure("terminal: Enter to output of ros2", "ms", median(commands)),
        *_echoing(counts),
    ]


def _echoing(counts: Counts) -> list[Figure]:
    """Times between frames while `echo` shows a topic of 10 kHz, and until Ctrl-C has ended it."""
    with serving_site(SITE) as url, chromium() as browser:
        page = browser.new_page()
        page.goto(f"{url}typed/")
        page.get_by_role("button", name="Start").click()
        page.evaluate(PROMPT)
        page.evaluate("async () => { window.measure = await import('/bench/frames.js'); }")
        bare = list(page.evaluate(f"measure.frames({counts.idle})"))
        frames, interrupts = [], []
        for _ in range(counts.starts):
            _type(page, "ros2 topic echo /rapid")
            page.wait_for_function(f"() => {ROWS}.some((row) => row.startsWith('data: message'))")
            frames += page.evaluate(f"measure.frames({counts.idle})")
            interrupts.append(page.evaluate(INTERRUPT))
    name = "terminal: echo of 10 kHz"
    promised = Target("figure", "≤", 100)
    return [
        Figure(f"{name}, frame, p50", "ms", median(frames), median(bare)),
        Figure(f"{name}, frame, p99", "ms", p99(frames), p99(bare)),
        Figure(f"{name}, Ctrl-C to prompt", "ms", max(interrupts), target=promised),
    ]


def _type(page: Page, line: str) -> None:
    page.locator(".xterm-helper-textarea").focus()
    page.keyboard.press("Control+l")
    page.keyboard.type(line)
    page.keyboard.press("Enter")
