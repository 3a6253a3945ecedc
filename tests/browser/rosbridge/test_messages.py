"""JSON and CDR of the same messages.

The CDR was written by rclpy; what it fills up with is zero here.
"""

from __future__ import annotations

import json

import pytest
from paths import SUPPORT
from playwright.sync_api import Page

KNOWN = json.loads((SUPPORT / "rosbridge/messages.json").read_text())
# Publishes the JSON, and resolves with what arrives as CDR, and, published as CDR, as JSON.
BOTH = """async ({ type, json, cdr }) => {
  const bytes = Uint8Array.from(cdr.match(/../g), (two) => parseInt(two, 16));
  const hex = (given) => Array.from(given, (one) => one.toString(16).padStart(2, "0")).join("");
  const options = { name: "/known", messageType: type };
  const raw = until((resolve) => link.Topic({ ...options,
    compression: "cbor-raw" }).subscribe(resolve));
  link.Topic(options).publish(json);
  const written = hex((await raw).bytes);
  const other = await connected();
  const read = until((resolve) => other.Topic(options).subscribe(resolve));
  ros.topic("/known", type).publish(bytes);
  return { written, read: await read };
}"""


@pytest.mark.parametrize("known", KNOWN, ids=lambda known: known["type"].split("/")[-1])
def test_json_and_cdr(page: Page, known: dict[str, object]) -> None:
    found = page.evaluate(BOTH, known)
    assert found["read"] == known["json"]
    assert found["written"] == known["cdr"]
