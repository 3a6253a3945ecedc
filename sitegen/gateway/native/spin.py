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
_KINDS = ("subscription", "client", "service")
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
        # The handles in the wait set, by kind; both stay until an endpoint comes or goes.
        self._wait_set: Any = None
        self._handles: dict[str, list[Any]] = {}
        self._changed = True
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
        self._changed = True

    def remove(self, source: Source) -> None:
        """Take no more; called in the thread of ROS, before the endpoint is destroyed."""
        self._sources.pop(source.handle.pointer, None)
        self._changed = True

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
                self._changed = True
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
        # It must not outlive the context.
        self._wait_set = None

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
        if self._changed:
            self._changed = False
            self._prepare()
        wait_set = self._wait_set
        # A wait leaves only what is ready in the set.
        wait_set.clear_entities()
        for kind in _KINDS:
            add = getattr(wait_set, f"add_{kind}")
            for handle in self._handles[kind]:
                try:
                    add(handle)
                except Exception as error:
                    logger.error("an endpoint is lost: %s", error)
                    self._lose(handle)
        wait_set.add_guard_condition(self._guard)
        # The trigger of a job that was added since lasts until a wait sees it.
        wait_set.wait(-1)
        return [pointer for kind in _KINDS for pointer in wait_set.get_ready_entities(kind)]

    def _prepare(self) -> None:
        """Make a wait set for the endpoints that there are now."""
        self._handles = {
            kind: [source.handle for source in self._sources.values() if source.kind == kind]
            for kind in _KINDS
        }
        subscriptions, clients, services = (len(self._handles[kind]) for kind in _KINDS)
        self._wait_set = rclpy_implementation.WaitSet(
            subscriptions, 1, 0, clients, services, 0, self._context.handle
        )

    def _lose(self, handle: Any) -> None:
        for pointer, source in list(self._sources.items()):
            if source.handle is handle:
                del self._sources[pointer]
        self._changed = True


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
