"""Wait for what no library waits for."""

from __future__ import annotations

import time
from collections.abc import Callable


def until(
    check: Callable[[], object], seconds: float = 60, told: Callable[[], object] = str
) -> None:
    """Wait until `check` returns something true; after these seconds, fail with what is told."""
    limit = time.monotonic() + seconds
    while not check():
        assert time.monotonic() < limit, told() or "it has not come true"
        time.sleep(0.02)
