"""The history of one frame: its transforms to its parent, by time."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from typing import NamedTuple

from tf2_py.geometry import Pose, between


class Sample(NamedTuple):
    """A transform of a frame; `stamp` is in nanoseconds."""

    stamp: int
    pose: Pose
    parent: str


class FrameHistory:
    """The samples of one frame within the last `kept` nanoseconds."""

    def __init__(self, is_static: bool, kept: int) -> None:
        self.is_static = is_static
        self.samples: list[Sample] = []  # the oldest first
        self.authority = ""
        self._kept = kept

    @property
    def newest(self) -> int:
        """The time of the newest sample; 0 for a static frame."""
        return 0 if self.is_static or not self.samples else self.samples[-1].stamp

    @property
    def oldest(self) -> int:
        """The time of the oldest sample."""
        return 0 if self.is_static or not self.samples else self.samples[0].stamp

    @property
    def parent(self) -> str:
        """The newest parent."""
        return self.samples[-1].parent if self.samples else ""

    def insert(self, sample: Sample) -> bool:
        """Add a sample; return False if it is older than the history."""
        if self.is_static:
            self.samples = [sample]
            return True
        limit = self.newest - self._kept
        while self.samples and self.samples[0].stamp < limit:
            self.samples.pop(0)
        if self.samples and sample.stamp < limit:
            return False
        stamps = [each.stamp for each in self.samples]
        end = bisect_right(stamps, sample.stamp)
        if sample not in self.samples[bisect_left(stamps, sample.stamp) : end]:
            self.samples.insert(end, sample)
        return True

    def at(self, time: int) -> Sample | str:
        """Return the sample at a time, or the newest one for 0; or the reason why there is none."""
        if not self.samples:
            return ""
        if self.is_static or time == 0:
            return self.samples[-1]._replace(stamp=time or self.newest)
        stamps = [each.stamp for each in self.samples]
        later = bisect_right(stamps, time)
        if later and stamps[later - 1] == time:
            return self.samples[later - 1]
        if later in (0, len(stamps)):
            return self._why_not(time)
        older, newer = self.samples[later - 1], self.samples[later]
        if older.parent != newer.parent:
            return older
        ratio = (time - older.stamp) / (newer.stamp - older.stamp)
        return Sample(time, between(older.pose, newer.pose, ratio), older.parent)

    def _why_not(self, time: int) -> str:
        begin = "Lookup would require extrapolation "
        if self.oldest == self.newest:
            return (
                f"{begin}at time {shown(time)}, but only time {shown(self.newest)} is in the buffer"
            )
        if time > self.newest:
            return (
                f"{begin}into the future.  Requested time {shown(time)} but the latest data is at"
                f" time {shown(self.newest)}"
            )
        return (
            f"{begin}into the past.  Requested time {shown(time)} but the earliest data is at"
            f" time {shown(self.oldest)}"
        )


def shown(time: int) -> str:
    """Return a time in seconds as text."""
    return f"{time / 1e9:.6f}"
