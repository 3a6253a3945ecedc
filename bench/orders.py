"""What listeners do with the orders of their standard input: size, count and period (s) as text."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable

# A listener that gets nothing for so long waits no more (s).
QUIET = 2.0


def follow(found: list[tuple[int, int]], begin: Callable[[str], None]) -> None:
    """Begin each order, and print what has been found when it is complete: sent, received (ns)."""
    print("ready", flush=True)
    for order in sys.stdin:
        found.clear()
        begin(order.strip())
        count = int(order.split()[1])
        last = time.monotonic_ns()
        while len(found) < count and time.monotonic_ns() - last < QUIET * 1e9:
            time.sleep(0.01)
            last = max(last, found[-1][1] if found else last)
        print(json.dumps(found), flush=True)
