"""Pages with widgets that several files of tests open."""

from __future__ import annotations

import pytest
from browser import Built, Serve
from paths import SITES


@pytest.fixture
def bag_pages(serve: Serve, built: Built) -> str:
    """The address of the site of sites/bags, whose pages play and record."""
    return serve(built(SITES / "bags"))
