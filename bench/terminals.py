"""Measure how soon a terminal takes commands, and how soon one of them has printed."""

from __future__ import annotations

import tempfile
from pathlib import Path
from statistics import median

from bench.browser import chromium, serving_site
from bench.counts import Counts
from bench.figure import Figure

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
    ]
