"""Builds that run at the same time: those of other folders go on, those of the same one wait."""

from __future__ import annotations

import io
import threading
from pathlib import Path

from waiting import until

from sitegen.nodes.cpp.locks import locked
from sitegen.report import Report


class Screen(io.StringIO):
    """What a terminal was told."""

    def isatty(self) -> bool:
        return True


def test_a_build_waits_for_one_in_the_same_folder_and_says_so(tmp_path: Path) -> None:
    screen, folders = Screen(), [tmp_path / "new" / name for name in ("b", "a")]
    entered = threading.Event()

    def second() -> None:
        with locked(reversed(folders), Report(screen)):
            entered.set()

    with locked(folders, Report(io.StringIO())):
        with locked([tmp_path / "new" / "c"], Report(screen)):
            assert screen.getvalue() == ""
        waiting = threading.Thread(target=second, daemon=True)
        waiting.start()
        until(lambda: "sitegen: waiting for another build" in screen.getvalue())
        assert not entered.is_set()
    assert entered.wait(20)
    waiting.join(20)
    with locked(folders, Report(io.StringIO())):
        pass
