"""Remember how long the steps of a build took, to say it when they run again."""

from __future__ import annotations

import contextlib
import hashlib
import math
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Durations:
    """The durations of steps in the folder `cache`; `what` distinguishes them from others."""

    cache: Path
    what: str

    def note(self, step: str, seconds: float) -> None:
        """Record how long a step took."""
        file = self._file(step)
        with contextlib.suppress(OSError):  # the duration is only for people
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(f"{seconds:.1f}\n", encoding="utf-8")

    def recall(self, step: str) -> float | None:
        """Return the seconds that a step took the last time, None if that is unknown."""
        try:
            seconds = float(self._file(step).read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return None  # never recorded, or damaged
        return seconds if math.isfinite(seconds) and seconds > 0 else None

    def _file(self, step: str) -> Path:
        name = hashlib.sha256(f"{self.what}\0{step}".encode()).hexdigest()[:20]
        return self.cache / "durations" / name
