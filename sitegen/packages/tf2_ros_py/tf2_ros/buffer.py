"""A buffer that can wait for transforms; use it with a TransformListener."""

from __future__ import annotations

import threading
from collections.abc import Callable
from time import sleep
from typing import Any

from geometry_msgs.msg import TransformStamped
from rclpy.clock import Clock, JumpThreshold
from rclpy.duration import Duration
from rclpy.logging import get_logger
from rclpy.node import Node
from rclpy.task import Future
from rclpy.time import Time
from tf2_msgs.srv import FrameGraph
from tf2_py import BufferCore

from tf2_ros.buffer_interface import BufferInterface

NO_TIME = Duration()
PAUSE = 0.02


class Buffer(BufferCore, BufferInterface):
    """A buffer; a time of 0 requests the latest transform."""

    def __init__(self, cache_time: Duration | None = None, node: Node | None = None) -> None:
        BufferCore.__init__(self, cache_time)
        BufferInterface.__init__(self)
        self._callbacks: list[Callable[[], None]] = []
        self._lock = threading.RLock()
        self.clock = node.get_clock() if node else Clock()
        if node:
            self.srv = node.create_service(FrameGraph, "tf2_frames", self._frames)
        backwards = JumpThreshold(
            min_forward=None, min_backward=Duration(nanoseconds=-1), on_clock_change=True
        )
        self.jump_handle = self.clock.create_jump_callback(backwards, post_callback=self._jumped)

    def _frames(self, _: Any, response: Any) -> Any:
        response.frame_yaml = self.all_frames_as_yaml()
        return response

    def _jumped(self, _: Any) -> None:
        get_logger("tf2_buffer").warning("Detected jump back in time. Clearing tf buffer.")
        self.clear()

    def set_transform(self, transform: TransformStamped, authority: str) -> None:
        """Add a transform."""
        super().set_transform(transform, authority)
        self._tell()

    def set_transform_static(self, transform: TransformStamped, authority: str) -> None:
        """Add a static transform."""
        super().set_transform_static(transform, authority)
        self._tell()

    def _tell(self) -> None:
        with self._lock:
            for callback in list(self._callbacks):
                callback()

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Time, timeout: Duration = NO_TIME
    ) -> TransformStamped:
        """Wait up to `timeout` for the transform and return it.

        Raises:
            TransformException: if it is not available.
        """
        self.can_transform(target_frame, source_frame, time, timeout)
        return self.lookup_transform_core(target_frame, source_frame, time)

    async def lookup_transform_async(
        self, target_frame: str, source_frame: str, time: Time
    ) -> TransformStamped:
        """Wait for the transform and return it."""
        await self.wait_for_transform_async(target_frame, source_frame, time)
        return self.lookup_transform_core(target_frame, source_frame, time)

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_TIME,
    ) -> TransformStamped:
        """Wait up to `timeout` for the transform between two times and return it."""
        way = (target_frame, target_time, source_frame, source_time, fixed_frame)
        self.can_transform_full(*way, timeout)
        return self.lookup_transform_full_core(*way)

    async def lookup_transform_full_async(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
    ) -> TransformStamped:
        """Wait for the transform between two times and return it."""
        way = (target_frame, target_time, source_frame, source_time, fixed_frame)
        await self.wait_for_transform_full_async(*way)
        return self.lookup_transform_full_core(*way)

    def can_transform(
        self,
        target_frame: str,
        source_frame: str,
        time: Time,
        timeout: Duration = NO_TIME,
        return_debug_tuple: bool = False,
    ) -> Any:
        """Return whether a transform is available within `timeout`, and on request the reason."""
        can = self._wait(lambda: self.can_transform_core(target_frame, source_frame, time), timeout)
        return can if return_debug_tuple else can[0]

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_TIME,
        return_debug_tuple: bool = False,
    ) -> Any:
        """Return the same for a transform between two times."""
        way = (target_frame, target_time, source_frame, source_time, fixed_frame)
        can = self._wait(lambda: self.can_transform_full_core(*way), timeout)
        return can if return_debug_tuple else can[0]

    def _wait(self, ask: Callable[[], tuple[bool, str]], timeout: Duration) -> tuple[bool, str]:
        can = ask()
        clock = Clock()
        end = clock.now() + timeout
        while not can[0] and clock.now() < end:
            sleep(PAUSE)
            can = ask()
        return can

    def wait_for_transform_async(self, target_frame: str, source_frame: str, time: Time) -> Future:
        """Return a future that completes when the transform is available."""
        return self._promise(
            lambda: self.can_transform_core(target_frame, source_frame, time)[0],
            lambda: self.lookup_transform_core(target_frame, source_frame, time),
        )

    def wait_for_transform_full_async(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
    ) -> Future:
        """Return a future that completes when the transform between two times is available."""
        way = (target_frame, target_time, source_frame, source_time, fixed_frame)
        return self._promise(
            lambda: self.can_transform_full_core(*way)[0],
            lambda: self.lookup_transform_full_core(*way),
        )

    def _promise(self, can: Callable[[], bool], look_up: Callable[[], TransformStamped]) -> Future:
        future = Future()

        def look() -> None:
            if future.done() or not can():
                return
            if look in self._callbacks:
                self._callbacks.remove(look)
            future.set_result(look_up())

        with self._lock:
            self._callbacks.append(look)
            look()
        return future
