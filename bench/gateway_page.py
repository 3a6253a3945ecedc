"""Measure between a native robot and a page that has joined its gateway, in both directions."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from pathlib import Path
from shutil import copy
from typing import Any

from bench.browser import chromium, serving_site
from bench.counts import Counts
from bench.figure import Figure, Target
from bench.orders import SIZES, Found, delays, give, orders, rate

SITE = """
site: {{title: Gateway}}
connect: {{addresses: [ws://127.0.0.1:{port}], autoconnect: true}}
pages:
  - path: /
    title: Messages to and from a robot
    script: page.js
    content: [connect:]
"""
SCRIPT = Path(__file__).parent / "gateway_site" / "page.js"
# What a way through the gateway may take, of the time over a bare WebSocket.
MOST = 2.5
# The engine compiles what it runs often.
WARM_UP = "16 4000 0"


def between_page_and_robot(
    port: int,
    address: str,
    robot: Any,
    plain: Any,
    natively: Mapping[str, float],
    counts: Counts,
) -> list[Figure]:
    """One way in each direction, beside a WebSocket from the same page to an address.

    `robot` and `plain` are the processes that notice what the page sends to them. `natively` is
    what a message takes between native nodes, by size (ms).
    """
    figures = []
    listeners = {"gateway": robot, "bare": plain}
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "site.yaml").write_text(SITE.format(port=port))
        copy(SCRIPT, folder)
        with serving_site(Path(folder), isolated=True) as url, chromium() as browser:
            # The policy of the page lets it connect to the gateway alone.
            page = browser.new_page(bypass_csp=True)
            page.goto(url)
            page.wait_for_selector("body[data-ready]")
            page.evaluate("openBare", address)

            def received(way: str, order: str) -> Found:
                found = page.evaluate("([way, order]) => receive(way, order)", [way, order])
                return [(sent * 1e6, got * 1e6) for sent, got in found]

            def sent(way: str, order: str) -> Found:
                begin = "([way, order]) => send(way, order)"
                return give(listeners[way], order, lambda order: page.evaluate(begin, [way, order]))

            for way in listeners:
                received(way, WARM_UP)
            for title, run in (("robot → page", received), ("page → robot", sent)):
                for shown, size in SIZES.items():
                    paced, burst = orders(size, counts.turns)
                    ours, bare = (delays(run(way, paced)) for way in listeners)
                    figures.append(Figure(f"{title}, {shown}, p50", "ms", ours[0], bare[0]))
                    target = Target("ratio", "≤", MOST)
                    for name, mine, theirs in zip(("p50", "p99"), ours, bare, strict=True):
                        name = f"{title} beyond ROS, {shown}, {name}"
                        part = mine - natively[shown]
                        figures.append(Figure(name, "ms", part, theirs, target))
                    many, most = (rate(run(way, burst)) for way in listeners)
                    figures.append(Figure(f"{title} in a burst, {shown}", "/s", many, most))
    return figures
