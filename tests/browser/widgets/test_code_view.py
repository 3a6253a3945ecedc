"""The editor on paper."""

from __future__ import annotations

from playwright.sync_api import Page as Tab


def test_all_lines_are_printed(stage: Tab) -> None:
    stage.evaluate(
        """async () => {
          const { codeView, PYTHON } = await import("./runtime/ui/codeView.js");
          const main = document.getElementById("main");
          main.innerHTML = "<div id=code style='margin-block-start: 500vh'></div>";
          const text = Array.from({ length: 80 }, (_, at) => `line_${at} = ${"x".repeat(300)}`);
          const nothing = () => {};
          const code = document.getElementById("code");
          const options = { text: text.join("\\n"), language: PYTHON, label: "Source" };
          codeView(code, { ...options, changed: nothing, run: nothing });
        }"""
    )
    stage.emulate_media(media="print")
    stage.wait_for_function(
        """() => {
          const root = document.getElementById("code").shadowRoot;
          const lines = [...root.querySelectorAll(".cm-line")];
          const { right } = root.querySelector(".cm-scroller").getBoundingClientRect();
          const whole = (line) => line.getBoundingClientRect().right <= right + 1;
          return lines.length === 80 && lines.every(whole);
        }"""
    )
