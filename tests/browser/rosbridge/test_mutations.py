"""Many messages of rosbridge, changed at random: each mistake is told, and nothing is left."""

from __future__ import annotations

import pytest
from memory import held
from mutator import is_invalid, mutations
from playwright.sync_api import Page

# Messages in every run, and with --all.
SHORT, LONG = 10_000, 100_000
CLIENTS = 10
# What the heap may grow by after the first clients, in bytes.
MOST = 3_000_000

BEGIN = """() => {
  const faults = [];
  addEventListener("error", ({ message }) => faults.push(message));
  addEventListener("unhandledrejection", ({ reason }) => faults.push(`rejected: ${reason}`));
  const opened = async () => {
    const socket = new rosbridge.RosbridgeSocket();
    await new Promise((resolve) => { socket.onopen = resolve; });
    return socket;
  };
  const graph = () => JSON.stringify(["topics", "services", "nodes"].map((kind) =>
    ros[kind]().map((one) => one.name ?? one).sort()));
  Object.assign(globalThis, { faults, opened, graph, before: graph() });
}"""
# One client: what it does not hear about, and what it hears of mistakes in the page itself.
SEND = """async (messages) => {
  const INTERNAL = /undefined|is not a function|Cannot \\w+|not iterable|of null|not be handled/;
  const socket = await opened();
  const silent = [];
  let refused = 0;
  let current = "";
  let heard;
  socket.onmessage = ({ data }) => {
    if (typeof data !== "string") return;
    const { op, level, result, msg, values } = JSON.parse(data);
    if (op === "publish") heard?.(msg);
    if (level !== "error" && result !== false) return;
    refused++;
    const text = String(msg ?? values);
    if (INTERNAL.test(text)) faults.push(`${text}: ${current}`);
  };
  for (const [index, [text, invalid]] of messages.entries()) {
    const told = refused;
    current = text;
    socket.send(text);
    await undefined; // Mistakes are told at once.
    if (invalid && refused === told) silent.push(text);
    if (index % 100 === 99) await pause(0);
  }
  const topic = "/after";
  const answer = new Promise((resolve) => { heard = resolve; });
  for (const one of [
    { op: "advertise", topic, type: "std_msgs/String" },
    { op: "subscribe", topic, type: "std_msgs/String" },
    { op: "publish", topic, msg: { data: "well" } },
  ]) socket.send(JSON.stringify(one));
  const { data } = await answer;
  socket.close();
  return { silent, refused, after: data };
}"""


def test_mutated_messages_are_told_and_leave_nothing_behind(
    page: Page, pytestconfig: pytest.Config
) -> None:
    page.evaluate(BEGIN)
    each = (LONG if pytestconfig.getoption("all") else SHORT) // CLIENTS
    heaps = []
    for seed in range(CLIENTS):
        messages = [(text, is_invalid(text)) for text in mutations(seed, each)]
        found = page.evaluate(SEND, messages)
        assert found["silent"] == []
        assert found["refused"] >= sum(invalid for _, invalid in messages) > each / 4
        assert found["after"] == "well"
        page.wait_for_function("() => graph() === before")
        heaps.append(held(page)["heap"])
    assert page.evaluate("faults") == []
    assert max(heaps[2:]) - max(heaps[:2]) < MOST, heaps
