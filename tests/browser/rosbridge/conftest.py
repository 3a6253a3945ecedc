"""A page whose graph roslib uses."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from browser import Built, Serve
from paths import SITES
from playwright.sync_api import Page
from roslib import with_roslib

SITE = SITES / "scripts"
AROUND = "<!doctype html><title>Around</title><iframe></iframe>"
# Beside the script: `connected` resolves with a Ros, and `until` with what a callback gets.
READY = """async () => {
  const { transportFactory, RosbridgeSocket } = rosbridge;
  const connected = (factory = transportFactory) => new Promise((resolve, reject) => {
    const one = new ROSLIB.Ros({ transportFactory: factory });
    one.on("connection", () => resolve(one));
    one.on("error", reject);
    one.connect("page:").catch(reject);
  });
  const until = (begin) => new Promise(begin);
  const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
  // The way of roslib's own transports, with frames that its own code decodes.
  class Wire extends ROSLIB.AbstractTransport {
    constructor(socket) {
      super();
      socket.binaryType = "arraybuffer";
      this.socket = socket;
      socket.onopen = (event) => this.emit("open", event);
      socket.onclose = (event) => this.emit("close", event);
      socket.onmessage = ({ data }) => {
        seen.push(typeof data === "string" ? JSON.parse(data).op : "bytes");
        this.handleRawMessage(data);
      };
    }
    send(message) { this.socket.send(JSON.stringify(message)); }
    close() { this.socket.close(); }
    isConnecting() { return this.socket.readyState === 0; }
    isOpen() { return this.socket.readyState === 1; }
    isClosing() { return this.socket.readyState === 2; }
    isClosed() { return this.socket.readyState === 3; }
  }
  const seen = [];
  const wired = () => connected(async () => new Wire(new RosbridgeSocket()));
  Object.assign(globalThis, { connected, until, pause, seen, wired, link: await connected() });
}"""


@pytest.fixture
def beside_python(tab: Page, serve: Serve, built: Built) -> Page:
    """A page with the Python node /helper, whose `link` is a Ros of roslib."""
    tab.goto(f"{serve(built(SITE))}python/")
    tab.wait_for_selector("body[data-scripted]")
    tab.evaluate("() => ros.action('/fibonacci').wait()")
    tab.evaluate(READY)
    return tab


@pytest.fixture
def page(tab: Page, serve: Serve, built: Built) -> Page:
    """A page with the node /robot, whose `link` is a Ros of roslib."""
    tab.goto(serve(built(SITE)))
    tab.wait_for_selector("body[data-scripted]")
    # The last thing that the node makes.
    tab.evaluate("() => ros.action('/fibonacci').wait()")
    tab.evaluate(READY)
    return tab


@pytest.fixture
def inside(built: Built, tmp_path: Path) -> Path:
    """The site, with roslib."""
    return with_roslib(built(SITE), tmp_path)


@pytest.fixture
def around(inside: Path, tmp_path: Path) -> Path:
    """Another site, whose page has an empty frame."""
    folder = tmp_path / "around"
    folder.mkdir()
    (folder / "index.html").write_text(AROUND)
    shutil.copy(inside / "roslib.js", folder)
    shutil.copy(inside / "runtime/rosbridge/outside.js", folder)
    return folder
