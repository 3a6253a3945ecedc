"""Scenarios in an empty page, with the modules of the runtime and nothing around them."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

from browser import Scripted, Serve
from paths import ROOT, SUPPORT

RUNTIME = ROOT / "sitegen" / "runtime"

# Counts what is under way between ports, so that a scenario can wait until all of it has come.
PORTS = """
let underWay = 0;
const { postMessage } = MessagePort.prototype;
MessagePort.prototype.postMessage = function (...message) {
  underWay++;
  postMessage.apply(this, message);
};
globalThis.MessageChannel = class extends MessageChannel {
  constructor() {
    super();
    for (const port of [this.port1, this.port2]) {
      port.addEventListener("message", () => underWay--);
    }
  }
};
const arrived = async () => {
  for (let tries = 0; tries < 6000; tries++) {
    await new Promise((resolve) => setTimeout(resolve, 10));
    if (underWay === 0) return;
  }
  throw new Error(`${underWay} messages never came`);
};
"""


def player(tab: Scripted, serve: Serve, folder: Path, setting: str) -> Callable[[str], Any]:
    """Return a function that runs a scenario after `setting` and returns what it returns."""
    shutil.copytree(RUNTIME, folder, dirs_exist_ok=True)
    (folder / "index.html").write_text('<!doctype html><link rel="icon" href="data:,">')
    tab.goto(serve(folder))
    return lambda scenario: tab.evaluate(f"async () => {{ {PORTS} {setting} {scenario} }}")


def play_peers(tab: Scripted, serve: Serve, folder: Path) -> Callable[[str], Any]:
    """Like `player`, for scenes with workers; see peers/."""
    shutil.copytree(RUNTIME, folder / "runtime")
    shutil.copytree(SUPPORT / "peers", folder, dirs_exist_ok=True)
    tab.goto(serve(folder))
    opening = 'const { complaints, graph, random, start, until } = await import("./peers.js");'
    return lambda scene: tab.evaluate(f"async () => {{ {opening} {scene} }}")
