"""WebKitGTK for tests, driven by WebDriver: Playwright cannot drive the one of Debian."""

from __future__ import annotations

import os
import subprocess
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from panel import messages
from selenium.webdriver import WebKitGTK, WebKitGTKOptions, WebKitGTKService
from selenium.webdriver.common.by import By
from selenium.webdriver.remote.webelement import WebElement

DRIVER = os.environ.get("WEBKIT_DRIVER", "/usr/bin/WebKitWebDriver")
# How long (s) anything may take.
LIMIT = 60


class Window:
    """A window of WebKitGTK, with those of the methods of Playwright's pages that tests need."""

    def __init__(self, driver: WebKitGTK) -> None:
        self._driver = driver

    def goto(self, url: str) -> None:
        self._driver.get(url)

    def reload(self) -> None:
        self._driver.refresh()

    def evaluate(self, function: str, argument: Any = None) -> Any:
        """Call a function of JavaScript, wait for it, and return what it returns."""
        return self._driver.execute_script(f"return ({function})(arguments[0])", argument)

    def find(self, selector: str) -> WebElement:
        """Return the first element of a CSS selector, once it is there, and scroll to its panel."""
        self.wait_until(lambda: self._driver.find_elements(By.CSS_SELECTOR, selector))
        found = self._driver.find_element(By.CSS_SELECTOR, selector)
        self.evaluate("(one) => (one.closest('section') ?? one).scrollIntoView()", found)
        return found

    def click(self, selector: str) -> None:
        """Click an element, once a visitor can."""
        element = self.find(selector)
        self.wait_until(lambda: element.is_displayed() and element.is_enabled())
        element.click()

    def fill(self, selector: str, text: str) -> None:
        field = self.find(selector)
        field.clear()
        field.send_keys(text)

    def text(self, selector: str) -> str:
        """Return the text of an element and of all that is in it."""
        return str(self.evaluate("(one) => one.textContent", self.find(selector)))

    def wait_for(self, selector: str, text: str) -> None:
        """Wait until an element contains the text."""
        self.wait_until(lambda: text in self.text(selector))

    def wait_until(self, condition: Callable[[], object]) -> None:
        end = time.monotonic() + LIMIT
        while not condition():
            assert time.monotonic() < end, self.text("body")
            time.sleep(0.05)


class WindowPanel:
    """The buttons and the console of one node, as in panel.py."""

    def __init__(self, window: Window, node: str) -> None:
        self._window = window
        self._panel = f'section[aria-label="{node}"]'
        # In a stage, it is apart from the buttons.
        self._log = f'[role=log][aria-label="{node}"]'

    def press(self, button: str) -> None:
        self._window.click(f"{self._panel} .ros-{button.lower()}")

    def start(self) -> None:
        self.press("Start")

    def stop(self) -> None:
        self.press("Stop")
        self.expect_state("stopped")

    def expect_state(self, state: str) -> None:
        self._window.wait_for(f"{self._panel} [aria-live=polite]", state)

    def lines(self) -> list[str]:
        console = self._window.find(self._log)
        lines: list[str] = self._window.evaluate(
            "(log) => [...log.children].map((row) => row.textContent)", console
        )
        return lines

    def messages(self) -> list[str]:
        return messages(self.lines())

    def wait_for(self, text: str) -> None:
        self._window.wait_until(lambda: any(text in line for line in self.lines()))


@contextmanager
def webkit() -> Iterator[Window]:
    """Run WebKitGTK on a screen that nobody sees: it has no mode without one."""
    with _screen() as display:
        # Safari shares memory in isolated pages; this one wants to be asked.
        asked = {"JSC_useSharedArrayBuffer": "1", "DISPLAY": display}
        service = WebKitGTKService(DRIVER, env={**os.environ, **asked})
        options = WebKitGTKOptions()
        options.add_argument("--automation")
        driver = WebKitGTK(options=options, service=service)
        driver.set_script_timeout(LIMIT)
        try:
            yield Window(driver)
        finally:
            driver.quit()


@contextmanager
def _screen() -> Iterator[str]:
    read, write = os.pipe()
    command = ["Xvfb", "-displayfd", str(write), "-nolisten", "tcp", "-screen", "0", "1280x1024x24"]
    with subprocess.Popen(command, pass_fds=[write], stderr=subprocess.DEVNULL) as server:
        os.close(write)
        try:
            with os.fdopen(read) as number:
                yield f":{number.readline().strip()}"
        finally:
            server.terminate()
