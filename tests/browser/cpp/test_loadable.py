"""Programs that open libraries by name, with dlopen() and the functions that call it."""

from __future__ import annotations

from panel import Played
from paths import SITES

SITE = SITES / "rclcpp"


def test_a_program_uses_functions_by_their_names(played: Played) -> None:
    opener = played(SITE, "opening", "opener")
    assert opener.lines() == [
        "hammer is there",
        "hammer hammer, version 3: 101.5",
        "half: undefined symbol: half: no C function or variable of libhammer.so",
        "closed 0",
        "saw saw, version 7: 2.5",
        "half: there",
        "closed 0",
        "linked 2, by name 5",
        "none 0: libnone.so: cannot open: a page cannot load libraries, and the program is not "
        "linked with this one",
        "thrown: broken",
        "thrown: undefined symbol: length: no C function or variable of libhammer.so",
        "name 0",
        "loaded 0 libsaw.so 1",
        "half 11.5, more 0",
        "unloaded 0",
    ]


def test_a_program_has_the_nodes_of_its_trees(played: Played) -> None:
    walker = played(SITE, "opening", "walker")
    assert walker.lines() == [
        "libnone.so: cannot open: a page cannot load libraries, and the program is not linked "
        "with this one",
        "turn left",
        "turn right",
    ]
