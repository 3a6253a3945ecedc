"""Match the messages of several filters by their timestamps."""

from __future__ import annotations

import itertools
import threading
from collections.abc import Sequence
from typing import Any

from rclpy.duration import Duration
from rclpy.time import Time

from message_filters.simple_filter import SimpleFilter, stamp_of

Queue = dict[int, Any]


class TimeSynchronizer(SimpleFilter):
    """Passes on sets of messages, one of each filter, with equal timestamps."""

    def __init__(self, fs: Sequence[Any], queue_size: int) -> None:
        super().__init__()
        self.queue_size = queue_size
        self.lock = threading.Lock()
        self.connectInput(fs)

    def connectInput(self, fs: Sequence[Any]) -> None:
        """Connect the inputs to other filters."""
        self.queues: list[Queue] = [{} for _ in fs]
        self.input_connections = [
            each.registerCallback(self.add, queue, index)
            for index, (each, queue) in enumerate(zip(fs, self.queues, strict=True))
        ]

    def add(self, msg: Any, my_queue: Queue, my_queue_index: int | None = None) -> None:
        """Add a message of one filter."""
        with self.lock:
            self._keep(Time.from_msg(msg.header.stamp).nanoseconds, msg, my_queue)
            for time in sorted(set.intersection(*map(set, self.queues))):
                self._match([time] * len(self.queues))

    def _keep(self, time: int, msg: Any, queue: Queue) -> None:
        queue[time] = msg
        while len(queue) > self.queue_size:
            del queue[min(queue)]

    def _match(self, times: Sequence[int]) -> None:
        self.signalMessage(
            *(queue.pop(time) for queue, time in zip(self.queues, times, strict=True))
        )


class ApproximateTimeSynchronizer(TimeSynchronizer):
    """The same for timestamps that differ by less than `slop` seconds."""

    def __init__(
        self, fs: Sequence[Any], queue_size: int, slop: float, allow_headerless: bool = False
    ) -> None:
        self.slop = Duration(seconds=slop)
        self.allow_headerless = allow_headerless
        super().__init__(fs, queue_size)

    def add(self, msg: Any, my_queue: Queue, my_queue_index: int | None = None) -> None:
        """Add a message of one filter."""
        stamp = stamp_of(msg, self.allow_headerless, "approx")
        if stamp is None:
            return
        now, slop = stamp.nanoseconds, self.slop.nanoseconds
        with self.lock:
            self._keep(now, msg, my_queue)
            # The nearest first; of the filter of the new message, only that message.
            choices = [
                [now]
                if queue is my_queue
                else sorted(
                    (time for time in queue if abs(time - now) <= slop),
                    key=lambda time: abs(time - now),
                )
                for queue in self.queues
            ]
            for times in itertools.product(*choices):
                there = all(t in q for t, q in zip(times, self.queues, strict=True))
                if there and max(times) - min(times) < slop:
                    self._match(times)
                    return
