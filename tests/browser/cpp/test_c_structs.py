"""C headers of messages: structs, their functions and their type supports."""

from __future__ import annotations

import pytest
from panel import Played
from paths import SITES

pytestmark = pytest.mark.firefox


def test_messages_are_also_c_structs(played: Played) -> None:
    # The program compares with the C++ classes of the same messages, and prints what differs.
    structs = played(SITES / "cstructs", "structs", "structs")
    assert structs.lines() == ["heard Zittau", "done"]
