"""A terminal of a page: what is typed into it, and what it shows."""

from __future__ import annotations

from playwright.sync_api import Page as Tab

ROWS = """() => [...document.querySelectorAll(".ros-screen:not([hidden]) .xterm-rows > div")].map(
  (row) => row.textContent.replaceAll("\\u00a0", " ").trimEnd()).join("\\n").trimEnd()"""
# The screen is drawn later than the command ends. Before the command, there is only a prompt.
ENDED = f"""() => {{
  const rows = ({ROWS})().split("\\n");
  const busy = document.querySelector(".ros-screen[aria-busy=true]:not([hidden])");
  return rows.length > 1 && rows.at(-1) === "$" && !busy;
}}"""


# Resolves when all of these names are in the graph.
KNOWN = """async (names) => {
  const { ros } = await import(document.querySelector("script[type=module]").src);
  const known = () => new Set(ros.graph.endpoints().flatMap(({ name, node }) => [name, node]));
  while (!names.every((name) => known().has(name))) {
    await new Promise((resolve) => ros.graph.addEventListener("change", resolve, { once: true }));
  }
}"""


class Terminal:
    """The terminal of a page, with a screen that is high enough for all that a command prints."""

    def __init__(self, tab: Tab, columns: int = 100) -> None:
        self.tab = tab
        tab.wait_for_selector(".xterm-rows")
        # Letters are as wide as the font makes them, so the columns are set by trying.
        tab.evaluate("document.querySelector('.ros-terminal').style.blockSize = '1800px'")
        self._fit(columns)
        self.focus()
        self.wait()

    def _fit(self, columns: int) -> None:
        self.tab.evaluate(
            """async (columns) => {
              const element = document.querySelector(".ros-terminal");
              const cell = document.querySelector(".xterm-char-measure-element");
              const width = cell.getBoundingClientRect().width / cell.textContent.length;
              element.style.inlineSize = `${Math.ceil(width * columns) + 40}px`;
              await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
            }""",
            columns,
        )

    def await_names(self, *names: str) -> None:
        """Wait until nodes, topics or services of these names exist."""
        self.tab.evaluate(KNOWN, names)

    def focus(self) -> None:
        self.tab.locator(".ros-screen:not([hidden]) .xterm-helper-textarea").focus()

    def text(self) -> str:
        """Return what is on the screen."""
        found: str = self.tab.evaluate(ROWS)
        return found

    def wait(self) -> None:
        """Wait until the terminal waits for a command."""
        self.tab.wait_for_function(ENDED)

    def wait_for(self, text: str) -> None:
        self.tab.wait_for_function(f"(text) => ({ROWS})().includes(text)", arg=text)

    def begin(self, line: str) -> None:
        """Enter a line on an empty screen, and do not wait for its end."""
        self.tab.keyboard.press("Control+l")
        self.tab.wait_for_function(f"() => ({ROWS})() === '$'")
        self.tab.keyboard.type(line)
        self.tab.keyboard.press("Enter")

    def run(self, line: str) -> str:
        """Enter a line, and return what it prints."""
        self.begin(line)
        self.wait()
        return self.output(line)

    def output(self, line: str) -> str:
        """Return what is between the entered line and the next prompt."""
        shown = self.text().removesuffix("$").split("\n")
        # A long line goes on in the next row.
        typed, count = "", 0
        while shown and len(typed) < len(f"$ {line}".rstrip()):
            typed += shown.pop(0)
            count += 1
            assert count < 10, f"{line!r} is not on the screen: {self.text()}"
        return "\n".join(shown).rstrip("\n")

    def status(self) -> int:
        """Return the status of the last command."""
        return int(self.run("echo $?"))

    def interrupt(self) -> None:
        self.tab.keyboard.press("Control+c")
        self.wait()
