"""A tree of frames with their transforms over time; each frame has one parent."""

from __future__ import annotations

import math
import sys
from typing import NamedTuple

from geometry_msgs.msg import TransformStamped
from rclpy.duration import Duration
from rclpy.time import Time

from tf2_py.exceptions import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TransformException,
)
from tf2_py.frame_history import FrameHistory, Sample, shown
from tf2_py.geometry import IDENTITY, Pose, chained, inverted

KEPT = 10_000_000_000
DEEPEST = 1000
# The tolerance for the squared length of a quaternion, which should be 1.
TOLERANCE = 10e-3


class _Climb(NamedTuple):
    """A path from a frame upwards: its end, the transform to there, and why it failed."""

    end: str
    pose: Pose
    met: bool
    error: str | None


class BufferCore:
    """Stores transforms, and computes the transform between any two frames."""

    def __init__(self, cache_time: Duration | None = None) -> None:
        self._kept = KEPT if cache_time is None else cache_time.nanoseconds
        self._histories: dict[str, FrameHistory] = {}
        self._names: dict[str, None] = {}  # of those that are known as parents only, too

    def clear(self) -> None:
        """Remove all transforms that are not static."""
        for history in self._histories.values():
            if not history.is_static:
                history.samples.clear()

    def set_transform(self, transform: TransformStamped, authority: str) -> None:
        """Store the transform of a frame at a time."""
        self._set(transform, authority, is_static=False)

    def set_transform_static(self, transform: TransformStamped, authority: str) -> None:
        """Store the transform of a frame for all times."""
        self._set(transform, authority, is_static=True)

    def _set(self, transform: TransformStamped, authority: str, *, is_static: bool) -> None:
        parent = transform.header.frame_id.removeprefix("/")
        child = transform.child_frame_id.removeprefix("/")
        t, r = transform.transform.translation, transform.transform.rotation
        faults = _faults(t, r, parent, child, authority)
        for line in faults:
            print(f"Error:   {line}", file=sys.stderr)
        if faults:
            return
        history = self._histories.get(child)
        if history is None or history.is_static != is_static:
            history = self._histories[child] = FrameHistory(is_static, self._kept)
        self._names |= {child: None, parent: None}
        stamp = Time.from_msg(transform.header.stamp).nanoseconds
        pose = Pose((r.x, r.y, r.z, r.w), (t.x, t.y, t.z))
        if history.insert(Sample(stamp, pose, parent)):
            history.authority = authority
        else:
            message = f"TF_OLD_DATA ignoring data from the past for frame {child} at time"
            print(
                f"Warning: {message} {shown(stamp)} according to authority {authority}",
                file=sys.stderr,
            )

    def lookup_transform_core(
        self, target_frame: str, source_frame: str, time: Time
    ) -> TransformStamped:
        """Return the transform from the source frame to the target frame.

        Raises: TransformException if it is not available.
        """
        pose, stamp = self._look_up(target_frame, source_frame, time.nanoseconds)
        return _stamped(pose, stamp, target_frame, source_frame)

    def lookup_transform_full_core(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
    ) -> TransformStamped:
        """Return the transform between two times; `fixed_frame` does not move in between."""
        frames = {"target": target_frame, "source": source_frame, "fixed": fixed_frame}
        for which, frame in frames.items():
            self._check(f"lookupTransform argument {which}_frame", frame)
        before, _ = self._look_up(fixed_frame, source_frame, source_time.nanoseconds)
        after, stamp = self._look_up(target_frame, fixed_frame, target_time.nanoseconds)
        return _stamped(chained(after, before), stamp, target_frame, source_frame)

    def can_transform_core(
        self, target_frame: str, source_frame: str, time: Time
    ) -> tuple[bool, str]:
        """Return whether the transform is available, and the reason if not."""
        return self._can(target_frame, source_frame, time.nanoseconds)

    def can_transform_full_core(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
    ) -> tuple[bool, str]:
        """Return the same for a transform between two times."""
        can, why = self._can(target_frame, fixed_frame, target_time.nanoseconds)
        return self._can(fixed_frame, source_frame, source_time.nanoseconds) if can else (can, why)

    def get_latest_common_time(self, target_frame: str, source_frame: str) -> Time:
        """Return the latest time at which there is a transform."""
        return Time(nanoseconds=self._latest_common_time(target_frame, source_frame))

    def all_frames_as_string(self) -> str:
        """Return a line for each frame."""
        return "".join(
            f"Frame {name} exists with parent {history.parent}.\n"
            for name, history in self._histories.items()
        )

    def all_frames_as_yaml(self) -> str:
        """Return the state of all frames as YAML."""
        text = ""
        for name, history in self._histories.items():
            length = (history.newest - history.oldest) / 1e9
            text += (
                f"{name}: \n  parent: '{history.parent}'\n  broadcaster: '{history.authority}'\n"
                f"  rate: {len(history.samples) / max(length, 1e-4):.3f}\n"
                f"  most_recent_transform: {shown(history.newest)}\n"
                f"  oldest_transform: {shown(history.oldest)}\n  buffer_length: {length:.3f}\n"
            )
        return text or "[]"

    def _frameExists(self, frame_id: str) -> bool:
        return frame_id in self._names

    def _getFrameStrings(self) -> list[str]:
        return list(self._names)

    def _can(self, target: str, source: str, time: int) -> tuple[bool, str]:
        try:
            self._look_up(target, source, time, "canTransform")
        except TransformException as error:
            return False, str(error)
        return True, ""

    def _check(self, what: str, frame: str) -> None:
        argument = f'Invalid argument "{frame}" passed to {what}'
        if not frame:
            raise InvalidArgumentException(f"{argument} - in tf2 frame_ids cannot be empty")
        if frame.startswith("/"):
            raise InvalidArgumentException(f"{argument} - in tf2 frame_ids cannot start with a '/'")
        if frame not in self._names:
            raise LookupException(f'"{frame}" passed to {what} does not exist. ')

    def _look_up(
        self, target: str, source: str, time: int, asking: str = "lookupTransform"
    ) -> tuple[Pose, int]:
        """Return the transform and its time."""
        if target == source:
            history = self._histories.get(target)
            return IDENTITY, history.newest if history and time == 0 else time
        self._check(f"{asking} argument target_frame", target)
        self._check(f"{asking} argument source_frame", source)
        time = time or self._latest_common_time(target, source)
        up = self._climb(source, {target}, time)
        if up.met:
            return up.pose, time
        other = self._climb(target, {source, up.end}, time)
        error = other.error if other.error is not None else up.error
        if not other.met and error is not None:
            raise ExtrapolationException(
                f"{error}, when looking up transform from frame [{source}] to frame [{target}]"
            )
        if not other.met:
            raise _unconnected(target, source)
        back = inverted(other.pose)
        return (back if other.end == source else chained(back, up.pose)), time

    def _climb(self, frame: str, stops: set[str], time: int) -> _Climb:
        pose = IDENTITY
        for _ in range(DEEPEST):
            history = self._histories.get(frame)
            if frame in stops or history is None:
                return _Climb(frame, pose, frame in stops, None)
            sample = history.at(time)
            if isinstance(sample, str):
                return _Climb(frame, pose, False, sample)
            pose = chained(sample.pose, pose)
            frame = sample.parent
        raise self._loop()

    def _ancestors(self, frame: str) -> list[str]:
        found: list[str] = []
        while frame:
            found.append(frame)
            if len(found) > DEEPEST:
                raise self._loop()
            history = self._histories.get(frame)
            frame = history.parent if history else ""
        return found

    def _latest_common_time(self, target: str, source: str) -> int:
        up, other = self._ancestors(source), self._ancestors(target)
        top = next((frame for frame in up if frame in other), None)
        if top is None:
            raise _unconnected(target, source)
        frames = up[: up.index(top)] + other[: other.index(top)]
        # Static transforms do not limit the time.
        times = [self._histories[frame].newest for frame in frames]
        return min(filter(None, times), default=0)

    def _loop(self) -> LookupException:
        frames = self.all_frames_as_string()
        return LookupException(f"The tf tree is invalid because it contains a loop.\n{frames}\n")


def _unconnected(target: str, source: str) -> ConnectivityException:
    return ConnectivityException(
        f"Could not find a connection between '{target}' and '{source}' because they are not part"
        " of the same tree.Tf has two or more unconnected trees."
    )


def _stamped(pose: Pose, stamp: int, target: str, source: str) -> TransformStamped:
    message = TransformStamped()
    message.header.stamp = Time(nanoseconds=stamp).to_msg()
    message.header.frame_id = target
    message.child_frame_id = source
    t, r = message.transform.translation, message.transform.rotation
    t.x, t.y, t.z = pose.translation
    r.x, r.y, r.z, r.w = pose.rotation
    return message


def _faults(t: object, r: object, parent: str, child: str, authority: str) -> list[str]:
    """Return why a transform is invalid, a line for each reason."""
    found = []
    if child == parent:
        found.append(
            f'TF_SELF_TRANSFORM: Ignoring transform from authority "{authority}" with frame_id and '
            f' child_frame_id "{child}" because they are the same'
        )
    if not child:
        found.append(
            f'TF_NO_CHILD_FRAME_ID: Ignoring transform from authority "{authority}" because'
            " child_frame_id not set "
        )
    if not parent:
        found.append(
            f'TF_NO_FRAME_ID: Ignoring transform with child_frame_id "{child}"  from authority'
            f' "{authority}" because frame_id not set'
        )
    turn = [getattr(r, axis) for axis in "xyzw"]
    numbers = " ".join(f"{value:f}" for value in turn)
    if any(math.isnan(value) for value in [*turn, *(getattr(t, axis) for axis in "xyz")]):
        found.append(
            f'TF_NAN_INPUT: Ignoring transform for child_frame_id "{child}" from authority'
            f' "{authority}" because of a nan value in the transform ({numbers})'
        )
    if not abs(sum(value * value for value in turn) - 1) < TOLERANCE:
        found.append(
            f'TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id "{child}" from'
            f' authority "{authority}" because of an invalid quaternion in the transform'
            f" ({numbers})"
        )
    return found
