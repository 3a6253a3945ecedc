"""Find the cache folder of sitegen, and remove old entries."""

from __future__ import annotations

import contextlib
import os
import shutil
import time
from pathlib import Path

from platformdirs import user_cache_path

# Entries that can be built again from the workspace. Downloads are never removed.
MADE = ("descriptions", "durations", "nodes", "work")
# The time in seconds after which an unused entry is removed.
KEPT = 60 * 24 * 3600


def cache_folder() -> Path:
    """Return the cache folder: SITEGEN_CACHE, or the default of the platform."""
    own = os.environ.get("SITEGEN_CACHE")
    return Path(own).resolve() if own else user_cache_path("sitegen", appauthor=False).resolve()


def use(kept: Path) -> None:
    """Record that an entry of the cache is in use."""
    with contextlib.suppress(OSError):  # another user owns it, or another build removed it
        os.utime(kept)


def forget_old(cache: Path) -> None:
    """Remove the entries that were not used for a long time."""
    limit = time.time() - KEPT
    for kept in (each for name in MADE for each in (cache / name).glob("*")):
        with contextlib.suppress(OSError):
            if kept.stat().st_mtime < limit:
                shutil.rmtree(kept) if kept.is_dir() else kept.unlink()
