"""Calls of services that never answer do not use up the connections to a rosbridge server."""

from __future__ import annotations

import json
import subprocess

from paths import ROOT

MODULE = ROOT / "sitegen/runtime/rosbridge/robot/calls.js"
# More calls without an answer than there are connections, and then one that is answered.
CALLS = """
import { WebSocket, WebSocketServer } from "ws";
globalThis.WebSocket = class extends WebSocket {
  constructor(address) {
    super(address);
    // As in browsers, a connection that is closed before it is open ends nothing else.
    this.on("error", () => {});
  }
};
const { Calls } = await import(process.argv[1]);
const server = new WebSocketServer({ host: "127.0.0.1", port: 0 });
await new Promise((resolve) => server.on("listening", resolve));
let most = 0;
server.on("connection", (socket) => {
  most = Math.max(most, server.clients.size);
  socket.on("message", (text) => {
    const { op, service } = JSON.parse(text);
    if (service === "/answered") {
      socket.send(JSON.stringify({ op: "service_response", values: { yes: true }, result: true }));
    }
  });
});
const calls = new Calls(`ws://127.0.0.1:${server.address().port}`, () => {}, { patience: 50 });
let failed = 0;
for (let i = 0; i < 30; i++) calls.call("/silent").catch(() => { failed += 1; });
const { yes } = await calls.call("/answered");
// Seven calls had to wait, of which one is answered and keeps its connection.
while (failed < 7) await new Promise((resolve) => setTimeout(resolve, 10));
console.log(JSON.stringify({ yes, most }));
process.exit();
"""


def test_a_call_is_answered_though_others_never_are() -> None:
    words = ["node", "--input-type=module", "-e", CALLS, "--", str(MODULE)]
    done = subprocess.run(words, text=True, capture_output=True, check=True, cwd=ROOT, timeout=60)
    found = json.loads(done.stdout)
    assert found["yes"] is True
    # Those that are given up may still be closing.
    assert found["most"] <= 24 + 7
