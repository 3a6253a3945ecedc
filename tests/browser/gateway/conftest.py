"""Each module has a ROS domain of its own, and in it, a gateway and a robot if it asks for them."""

from __future__ import annotations

from collections.abc import Iterator

import native as native_side
import pytest
from joined import Gateway, Robot
from native import Native


@pytest.fixture(scope="module", autouse=True)
def own_domain() -> Iterator[None]:
    with native_side.own_domain():
        yield


@pytest.fixture(scope="module")
def native() -> Native:
    return Native()


@pytest.fixture(scope="module")
def gateway(native: Native, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Gateway]:
    """A gateway without a site; some modules have one of their own."""
    gateway = Gateway(native, tmp_path_factory.mktemp("gateway") / "log")
    gateway.start()
    yield gateway
    gateway.stop()


@pytest.fixture(scope="module")
def robot(native: Native) -> Iterator[Robot]:
    robot = Robot(native)
    yield robot
    robot.stop()
