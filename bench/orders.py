"""Orders to senders, and what listeners found: an order is size, count and period (s) as text."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable
from statistics import median, quantiles
from typing import Any

# When messages were sent and received (ns since 1970, the only clock that pages have, too).
Found = list[tuple[int, int]]
SIZES = {"16 B": 16, "1 KB": 1024, "1 MB": 2**20}
# A listener that gets nothing for so long waits no more (s).
QUIET = 2.0


def orders(size: int, turns: int) -> tuple[str, str]:
    """Return an order of one message after another, and one of a burst."""
    # A megabyte a hundred times in a second is more than two cores encode as JSON.
    count, period, burst = (5, 0.1, 10) if size > 10_000 else (50, 0.01, 500)
    return f"{size} {count * turns} {period}", f"{size} {burst * turns} 0"


def follow(found: Found, begin: Callable[[str], None]) -> None:
    """Begin each order of the standard input, and print what was found for it."""
    print("ready", flush=True)
    for order in sys.stdin:
        found.clear()
        print("listening", flush=True)
        begin(order.strip())
        count = int(order.split()[1])
        last = time.time_ns()
        while len(found) < count and time.time_ns() - last < QUIET * 1e9:
            time.sleep(0.01)
            last = max(last, found[-1][1] if found else last)
        print(json.dumps(found), flush=True)


def give(listener: Any, order: str, begin: Callable[[str], object] = lambda order: None) -> Found:
    """Give a listening process an order, let somebody begin, and return what it found."""
    start = len(listener.lines)
    listener.say(order)
    listener.expect("listening", start)
    begin(order)
    found: Found = json.loads(listener.expect("[[", start))
    # Whatever is still on its way.
    time.sleep(0.5)
    return found


def delays(found: Found) -> tuple[float, float]:
    """Return the median, and what one in a hundred is above of (ms)."""
    times = [(received - sent) / 1e6 for sent, received in found]
    return median(times), quantiles(times, n=100)[98]


def rate(found: Found) -> float:
    """Return how many messages were received in a second, counted until the last."""
    return (len(found) - 1) / (found[-1][1] - found[0][0]) * 1e9
