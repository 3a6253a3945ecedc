"""Run ROS in one thread: wait for messages, take them, and do what the event loop asks for.

rclpy's executors are not used: the one in Python rebuilds much for each message, and the one in C++
(rclpy 9.1) fails with callbacks that take the publisher's gid.
"""

from __future__ import annotations

import asyncio
import logging
import threading
import time
from collections import deque
from collections.abc import Callable
from typing import Any, Protocol, TypeVar

from rclpy.impl.implementation_singleton import rclpy_implementation

T = TypeVar("T")
logger = logging.getLogger(__name__)
# Messages taken from one endpoint before the others have their turn, and batches of them that the
# event loop may be behind.
_TURN = 100
_BEHIND = 4


class Source(Protocol):
    """An endpoint that something arrives at: its handle, and how one item is taken from it."""

    handle: Any

    @property
    def kind(self) -> str:
        """One of "subscription", "client" and "service"."""

    def take(self) -> Callable[[], None] | None:
        """Take one item and return what to call in the event loop, or None if there is none."""


class Spin:
    """The thread of ROS."""

    def __init__(self, context: Any, loop: asyncio.AbstractEventLoop) -> None:
        self._context = context
        self._loop = loop
        self._sources: dict[int, Source] = {}
        self._jobs: deque[Callable[[], None]] = deque()
        self._behind = threading.Semaphore(_BEHIND)
        self._stopped = threading.Event()
        self._guard = rclpy_implementation.GuardCondition(context.handle)
        self._thread = threading.Thread(target=self._run, name="ros", daemon=True)

    def start(self) -> None:
        """Start the thread."""
        self._thread.start()

    def stop(self) -> None:
        """End the thread and wait for it."""
        self._stopped.set()
        self._behind.release()
        self._guard.trigger_guard_condition()
        self._thread.join()

    def do(self, job: Callable[[], T]) -> asyncio.Future[T]:
        """Do `job` in the thread of ROS; its result or exception comes as a future."""
        future: asyncio.Future[T] = self._loop.create_future()
        if self._stopped.is_set():
            future.cancel()
            return future

        def done() -> None:
            try:
                result = job()
            except Exception as error:
                self._call(_fail, future, error)
            else:
                self._call(_succeed, future, result)

        self._jobs.append(done)
        self._guard.trigger_guard_condition()
        return future

    def add(self, source: Source) -> None:
        """Take what arrives at an endpoint; called in the thread of ROS."""
        self._sources[source.handle.pointer] = source

    def remove(self, source: Source) -> None:
        """Take no more; called in the thread of ROS, before the endpoint is destroyed."""
        self._sources.pop(source.handle.pointer, None)

    def _call(self, *call: Any) -> None:
        try:
            self._loop.call_soon_threadsafe(*call)
        except RuntimeError:
            # The event loop has ended before this thread.
            self._stopped.set()

    def _run(self) -> None:
        while not self._stopped.is_set() and self._context.ok():
            try:
                ready = self._wait()
            except Exception as error:
                # Without this thread, everybody would wait for ever.
                logger.error("the middleware failed: %s", error)
                ready = []
                time.sleep(0.1)
            while self._jobs:
                self._jobs.popleft()()
            arrived = [
                item
                for pointer in ready
                # A job may just have removed it.
                if (source := self._sources.get(pointer))
                for item in _taken(source)
            ]
            if arrived:
                self._behind.acquire()
                self._call(self._deliver, arrived)

    def _deliver(self, arrived: list[Callable[[], None]]) -> None:
        self._behind.release()
        for item in arrived:
            try:
                item()
            except Exception:
                # One receiver must not cost the others their messages.
                logger.exception("a message was not handled")

    def _wait(self) -> list[int]:
        """Wait until something arrives or is to be done; return the handles of what is ready."""
        kinds = [source.kind for source in self._sources.values()]
        counts = [kinds.count(kind) for kind in ("subscription", "client", "service")]
        wait_set = rclpy_implementation.WaitSet(
            counts[0], 1, 0, counts[1], counts[2], 0, self._context.handle
        )
        with wait_set:
            wait_set.clear_entities()
            for pointer, source in list(self._sources.items()):
                try:
                    getattr(wait_set, f"add_{source.kind}")(source.handle)
                except Exception as error:
                    logger.error("an endpoint is lost: %s", error)
                    del self._sources[pointer]
            wait_set.add_guard_condition(self._guard)
            # The trigger of a job that was added since lasts until a wait sees it.
            wait_set.wait(-1)
            return [
                pointer
                for kind in ("subscription", "client", "service")
                for pointer in wait_set.get_ready_entities(kind)
            ]


def _taken(source: Source) -> list[Callable[[], None]]:
    items = []
    for _ in range(_TURN):
        try:
            item = source.take()
        except Exception as error:
            # Another process has sent what is no message of this type.
            logger.warning("%s", str(error).splitlines()[0])
            continue
        if item is None:
            break
        items.append(item)
    return items


def _succeed(future: asyncio.Future[Any], result: Any) -> None:
    if not future.done():
        future.set_result(result)


def _fail(future: asyncio.Future[Any], error: Exception) -> None:
    if not future.done():
        future.set_exception(error)
