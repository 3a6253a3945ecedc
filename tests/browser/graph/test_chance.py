"""A graph in which anything may happen at any time, and what is true of it all the same."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from browser import Scripted, Serve
from scenario import play_peers

pytestmark = [pytest.mark.firefox, pytest.mark.webkit]

STEPS = 3000


@pytest.fixture
def play(any_tab: Scripted, serve: Serve, tmp_path: Path) -> Any:
    """A function that plays a scene with workers and returns what it returns."""
    return play_peers(any_tab, serve, tmp_path)


@pytest.mark.parametrize("seed", [2, 6, 7])
def test_chance_finds_nothing_wrong(play: Any, seed: int) -> None:
    """A failing seed is replayed by its number: the same steps, though in a time of their own."""
    end = play(f'const chance = await import("./chance.js"); return chance.play({seed}, {STEPS});')
    assert end["wrong"] == [], f"seed {seed}"
    assert end["left"] == []
    # How much is heard is a matter of the machine.
    assert end["heard"] > 100, end
