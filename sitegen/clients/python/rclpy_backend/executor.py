"""The experimental EventsExecutor, implemented by rclpy's SingleThreadedExecutor."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Self

if TYPE_CHECKING:
    from rclpy.context import Context
    from rclpy.node import Node
    from rclpy.task import Future, Task


class EventsExecutor:
    """Natively, this executor avoids the cost of wait sets; here it would save nothing."""

    def __init__(self, context: Context) -> None:
        # rclpy imports the extension before its executors.
        from rclpy.executors import SingleThreadedExecutor

        self._executor = SingleThreadedExecutor(context=context)

    @property
    def context(self) -> Context:
        """The context of the executor."""
        return self._executor.context

    def create_task(self, callback: Callable[..., Any], *args: Any, **kwargs: Any) -> Task[Any]:
        """Schedule a function or a coroutine."""
        return self._executor.create_task(callback, *args, **kwargs)

    def create_future(self) -> Future[Any]:
        """Return a future whose callbacks this executor runs."""
        return self._executor.create_future()

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """Wait until the running callback has ended; return whether it has."""
        return bool(self._executor.shutdown(timeout_sec))

    def add_node(self, node: Node) -> bool:
        """Add a node; return whether it was not there before."""
        return bool(self._executor.add_node(node))

    def remove_node(self, node: Node) -> None:
        """Remove a node."""
        self._executor.remove_node(node)

    def wake(self) -> None:
        """Make the executor look for work again."""
        self._executor.wake()

    def get_nodes(self) -> list[Node]:
        """Return the nodes."""
        return list(self._executor.get_nodes())

    def spin(self) -> None:
        """Run callbacks until the context is shut down."""
        self._executor.spin()

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Run one callback."""
        self._executor.spin_once(timeout_sec)

    def spin_until_future_complete(
        self, future: Future[Any], timeout_sec: float | None = None
    ) -> None:
        """Run callbacks until `future` has a result."""
        self._executor.spin_until_future_complete(future, timeout_sec)

    def spin_once_until_future_complete(
        self, future: Future[Any], timeout_sec: float | None = None
    ) -> None:
        """Run one callback, or return when `future` has a result."""
        self._executor.spin_once_until_future_complete(future, timeout_sec)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.shutdown()
