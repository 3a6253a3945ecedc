"""Run a node of the gateway, and what parties of it do in the native graph."""

from __future__ import annotations

import asyncio
import contextlib
import itertools
import logging
import os
from collections.abc import Callable
from typing import Any

import rclpy
from rclpy.parameter import Parameter

from sitegen.gateway.native.endpoint import Endpoint, NativeError, Qos
from sitegen.gateway.native.graph import Graph
from sitegen.gateway.native.party import Party
from sitegen.gateway.native.spin import Spin
from sitegen.gateway.native.topics import Shared

logger = logging.getLogger(__name__)
Watcher = Callable[[list[Endpoint], list[Endpoint]], None]
# The graph is read this often (s) while somebody watches it, as rclpy tells of no changes.
_PERIOD = 0.2
# It takes a tenth of the time at most, in steps that messages wait for, with rests between them.
_SHARE = 9
_STEP, _REST = 0.001, 0.004


class Native:
    """The gateway's part in the native graph."""

    spin: Spin
    graph: Graph

    def __init__(self, name: str = "_sitegen_gateway", *, domain: int | None = None) -> None:
        self.name = name
        self._domain = domain
        self._context = rclpy.Context()
        self.node: Any = None
        self.shared: dict[tuple[str, str, Qos], Shared] = {}
        self._watchers: list[Watcher] = []
        self._present: dict[str, Endpoint] = {}
        self._polling: asyncio.Task[None] | None = None
        self._reading: asyncio.Task[None] | None = None
        self._queued: asyncio.Task[None] | None = None
        self._keys = itertools.count(1)

    async def start(self) -> None:
        """Join the graph."""
        self._context.init(args=[], domain_id=self._domain)
        loop = asyncio.get_running_loop()
        self.spin = Spin(self._context, loop)
        # A node waits for the middleware to start, which takes a third of a second.
        self.node = await loop.run_in_executor(None, self.make_node, f"/{self.name}")
        self.graph = Graph(self.node)
        self.spin.start()

    async def stop(self) -> None:
        """Leave the graph with everything that is still there."""
        if self._polling:
            self._polling.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await self._polling
        await asyncio.get_running_loop().run_in_executor(None, self.spin.stop)
        self.node.destroy_node()
        self._context.try_shutdown()

    @property
    def rmw(self) -> str:
        """The name of the middleware."""
        return str(rclpy.get_rmw_implementation_identifier())

    @property
    def domain(self) -> int:
        """The number of the domain."""
        return int(self._context.get_domain_id())

    @property
    def distribution(self) -> str:
        """The distribution of ROS 2, or "" where the environment does not tell."""
        return os.environ.get("ROS_DISTRO", "")

    @property
    def endpoints(self) -> list[Endpoint]:
        """All endpoints of the graph, if it is being watched."""
        return list(self._present.values())

    def watch(self, watcher: Watcher) -> Callable[[], None]:
        """Call `watcher` with endpoints that have come and gone; return what ends that.

        The first call has all endpoints that are known, and may come before this returns.
        """
        self._watchers.append(watcher)
        if self._present:
            watcher(self.endpoints, [])
        if self._polling is None:
            self._polling = asyncio.create_task(self._poll())
        return lambda: self._watchers.remove(watcher) if watcher in self._watchers else None

    async def refresh(self) -> None:
        """Read the graph now, and tell the watchers.

        Those who ask while it is being read share the next reading.
        """
        if self._queued is None:
            self._queued = asyncio.create_task(self._read(self._reading))
        await asyncio.shield(self._queued)

    async def _read(self, before: asyncio.Task[None] | None) -> None:
        if before:
            await asyncio.wait({before})
        self._reading, self._queued = self._queued, None
        while (changes := await self.spin.do(lambda: self.graph.changes(_STEP))) is None:
            await asyncio.sleep(_REST)
        come, gone = changes
        for endpoint in gone:
            self._present.pop(endpoint.key, None)
        for endpoint in come:
            self._present[endpoint.key] = endpoint
        if come or gone:
            for watcher in list(self._watchers):
                watcher(come, gone)

    def lookers(self, topic: str, type_name: str) -> set[str | None]:
        """Return the parties that share a subscription of the gateway to a topic."""
        return {
            owner
            for (name, kind, _), shared in self.shared.items()
            if (name, kind) == (topic, type_name)
            for owner in shared.owners()
        }

    def notify(self) -> None:
        """Tell the watchers that parties look at other topics than before."""
        for watcher in list(self._watchers):
            watcher([], [])

    def join(self, owner: str | None) -> Party:
        """Return a new party, whose endpoints belong to `owner`."""
        return Party(self, owner)

    def key(self, kind: str) -> str:
        """Return a key for an endpoint of this process."""
        return f"own {kind} {next(self._keys)}"

    def make_node(self, full: str) -> Any:
        """Return a new native node without services and topics of its own.

        Raises:
            NativeError: the name is not valid
        """
        namespace, _, name = full.rpartition("/")
        try:
            node = rclpy.create_node(
                name,
                namespace=namespace or "/",
                context=self._context,
                use_global_arguments=False,
                enable_rosout=False,
                start_parameter_services=False,
                parameter_overrides=[Parameter("start_type_description_service", value=False)],
            )
        except Exception as error:
            raise NativeError(f"no node '{full}': {str(error).splitlines()[0]}") from None
        # The events of a page's node come from the page.
        events = getattr(node, "_parameter_event_publisher", None)
        if events is not None:
            node.destroy_publisher(events)
        return node

    async def _poll(self) -> None:
        while True:
            if self._watchers:
                try:
                    await self.refresh()
                except Exception:
                    # Something has gone while it was being read.
                    logger.exception("the graph was not read")
            await asyncio.sleep(max(_PERIOD, _SHARE * self.graph.took))
