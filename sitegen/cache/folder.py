"""Know where sitegen keeps what it need not make again, and for how long."""

from __future__ import annotations

import contextlib
import os
import shutil
import time
from pathlib import Path

from platformdirs import user_cache_path

# What is made from the workspace, and can be made again. What was fetched stays.
MADE = ("descriptions", "nodes", "work")
# So long (s) after it was last used, something that was made is forgotten.
KEPT = 60 * 24 * 3600


def cache_folder() -> Path:
    """Return where compiled nodes are kept for the next build."""
    own = os.environ.get("SITEGEN_CACHE")
    return Path(own).resolve() if own else user_cache_path("sitegen", appauthor=False).resolve()


def use(kept: Path) -> None:
    """Remember that a folder of the cache was used now."""
    with contextlib.suppress(OSError):  # it is somebody else's, or another build forgot it
        os.utime(kept)


def forget_old(cache: Path) -> None:
    """Remove what was made and not used for so long that nobody will want it again."""
    limit = time.time() - KEPT
    for kept in (each for name in MADE for each in (cache / name).glob("*")):
        with contextlib.suppress(OSError):
            if kept.stat().st_mtime < limit:
                shutil.rmtree(kept)
