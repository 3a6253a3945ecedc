"""A page of another origin around a frame, which uses the graph of the page in it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from browser import Serve
from panel import Panel
from playwright.sync_api import Browser, Page
from roslib import allow

# Resolves with a Ros that is connected, or with the error.
CONNECT = """async (inside) => {
  const frame = document.querySelector("iframe");
  frame.src = inside;
  const [ROSLIB, { transportTo }] = [await import("/roslib.js"), await import("/outside.js")];
  globalThis.ROSLIB = ROSLIB;
  const transportFactory = transportTo(frame.contentWindow, new URL(inside).origin);
  globalThis.link = new ROSLIB.Ros({ transportFactory });
  return new Promise((resolve) => {
    link.on("connection", () => resolve("connected"));
    link.on("error", ({ message }) => resolve(message));
    link.connect("page:");
  });
}"""


@pytest.mark.firefox
def test_a_page_around_a_frame_uses_its_graph(
    tab: Page, serve: Serve, inside: Path, around: Path
) -> None:
    outer = serve(around)
    allow(inside, outer)
    tab.goto(outer)
    assert tab.evaluate(CONNECT, serve(inside)) == "connected"
    found = tab.evaluate(
        """async () => {
          const heard = await new Promise((resolve) =>
            link.Topic({ name: "/latched", messageType: "std_msgs/String" }).subscribe(resolve));
          const service = link.Service({ name: "/add_two_ints", serviceType: "" });
          const sum = await new Promise((resolve) => service.callService({ a: 1, b: 2 }, resolve));
          const bytes = await new Promise((resolve) => {
            const options = { name: "/b", messageType: "sensor_msgs/CompressedImage" };
            link.Topic({ ...options, compression: "cbor" }).subscribe(resolve);
            link.Topic(options).publish({ data: new Uint8Array([1, 2]) });
          });
          return [heard.data, sum.sum, bytes.data.constructor.name, ...bytes.data];
        }"""
    )
    assert found == ["once", 3, "Uint8Array", 1, 2]
    frame = tab.frames[1]
    assert frame.evaluate("ros.nodes()").count("/rosbridge") == 1
    tab.evaluate("link.close()")
    frame.wait_for_function("!ros.nodes().includes('/rosbridge')")


def test_other_origins_are_refused(
    browser: Browser, serve: Serve, inside: Path, around: Path
) -> None:
    tab = browser.new_page()
    outer = serve(around)
    said: list[str] = []
    tab.on("console", lambda message: said.append(message.text))
    tab.goto(outer)
    origin = outer.rstrip("/")
    assert tab.evaluate(CONNECT, serve(inside)) == f"this page takes no messages from {origin}"
    assert "'messages_from' in site.yaml does not name it" in " ".join(said)
    frame = tab.frames[1]
    assert "/rosbridge" not in frame.evaluate("ros.nodes()")


def test_a_page_without_the_key_hears_nothing(
    browser: Browser, serve: Serve, inside: Path, around: Path
) -> None:
    file = inside / "page.json"
    entry = json.loads(file.read_text())
    del entry["messagesFrom"]
    file.write_text(json.dumps(entry))
    tab = browser.new_page()
    tab.goto(serve(around))
    tab.evaluate("(inside) => { document.querySelector('iframe').src = inside; }", serve(inside))
    tab.wait_for_selector("iframe")
    frame = tab.frames[1]
    frame.wait_for_selector("body[data-scripted]")
    Panel(frame, "robot").expect_state("running")  # type: ignore[arg-type]
    # An answer would come before that of the page itself.
    found = tab.evaluate(
        """async () => {
          const { port1, port2 } = new MessageChannel();
          const answers = [];
          port1.onmessage = ({ data }) => answers.push(data);
          const { contentWindow } = document.querySelector("iframe");
          contentWindow.postMessage({ op: "sitegen-connect", id: "1" }, "*", [port2]);
          await new Promise((resolve) => setTimeout(resolve, 300));
          return answers;
        }"""
    )
    assert found == []
