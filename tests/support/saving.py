"""What a panel saves as a file: Firefox, as tests drive it, does not tell of downloads."""

from __future__ import annotations

import base64

from playwright.sync_api import Locator

KEEP = """() => {
  window.saved = [];
  const blobs = new Map();
  URL.createObjectURL = (blob) => {
    const address = `blob:${blobs.size}`;
    blobs.set(address, blob);
    return address;
  };
  URL.revokeObjectURL = () => {};
  HTMLAnchorElement.prototype.click = function () {
    const reader = new FileReader();
    reader.onload = () => saved.push([this.download, reader.result.split(",")[1] ?? ""]);
    reader.readAsDataURL(blobs.get(this.href));
  };
}"""


def saved(button: Locator) -> tuple[str, bytes]:
    """Press a button, and return the name and the content of the file that the panel saves."""
    tab = button.page
    tab.evaluate(KEEP)
    button.click()
    tab.wait_for_function("() => saved.length > 0")
    [[name, content]] = tab.evaluate("saved")
    return name, base64.b64decode(content)
