"""One robot and one gateway for a module of tests.

Even idle, the robot takes a quarter of a processor, so it does not live on beside all other tests.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack

import gateways
import native
import pytest


@pytest.fixture(scope="module")
def domain() -> int:
    """The domain of the robot: other tests, which have actions of the same name, have others."""
    return native.free_domain()


@pytest.fixture(scope="module", autouse=True)
def graph(domain: int) -> Iterator[None]:
    with native.in_domain(domain):
        yield


@pytest.fixture(scope="module")
def robot(domain: int) -> Iterator[gateways.Process]:
    """A native robot."""
    with ExitStack() as stack:
        with native.in_domain(domain):
            running = stack.enter_context(gateways.robot())
        yield running


@pytest.fixture(scope="module")
def opened(
    robot: gateways.Process, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[gateways.Gateway]:
    """A gateway without gateway.yaml."""
    with gateways.gateway(folder=tmp_path_factory.mktemp("gateway")) as running:
        yield running
