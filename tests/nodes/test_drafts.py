"""Why a build for publication makes programs again that `sitegen serve` has made."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

from sitegen.model import Build
from sitegen.nodes.cpp.drafts import draft_of, reason

OPTIMIZING = "optimizing {} for publication (up to half the size)"
SERVE = "; `sitegen serve` leaves this out to be faster"


def builds(folder: Path, engine: str, *names: str, drafts: Sequence[str] = ()) -> list[Build]:
    """The programs of a package that are to be made, some of which exist as drafts."""
    draft_of(folder).mkdir(exist_ok=True)
    for name in drafts:
        (draft_of(folder) / f"{name}.{engine}.wasm").touch()
    found = []
    for name in names:
        script, wasm, types = (folder / f"{name}.{engine}.{end}" for end in ("js", "wasm", "json"))
        found.append(Build(engine, script, wasm, types))
    return found


@pytest.mark.parametrize(
    ("drafts", "said"),
    [
        (["talker", "listener"], OPTIMIZING.format("2 nodes") + SERVE),
        # It is compiled for another reason: a program of it is new.
        (["talker"], ""),
        ([], ""),
    ],
)
def test_drafts_of_a_package_are_the_reason_if_all_are_there(
    tmp_path: Path, drafts: Sequence[str], said: str
) -> None:
    pubsub = builds(tmp_path / "a", "jspi", "talker", "listener", drafts=drafts)
    other = builds(tmp_path / "b", "jspi", "other")
    assert reason([pubsub, other]) == said


def test_browsers_that_no_draft_is_for_are_named(tmp_path: Path) -> None:
    current = builds(tmp_path / "a", "jspi", "talker", drafts=["talker"])
    older = builds(tmp_path / "a", "asyncify", "talker")
    all_of_them = " and compiling them for all browsers"
    assert reason([current, older]) == f"{OPTIMIZING.format('1 node')}{all_of_them}{SERVE}"
    older = builds(tmp_path / "a", "asyncify", "talker", drafts=["talker"])
    assert reason([current, older]) == OPTIMIZING.format("1 node") + SERVE
