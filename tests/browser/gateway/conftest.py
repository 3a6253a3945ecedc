"""Each module has a ROS domain of its own."""

from __future__ import annotations

from collections.abc import Iterator

import native
import pytest


@pytest.fixture(scope="module", autouse=True)
def own_domain() -> Iterator[None]:
    with native.own_domain():
        yield
