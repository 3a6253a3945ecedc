"""Names of the API that published packages use: `tests/nodes/public_names` lists all of them."""

from __future__ import annotations

from panel import Played
from paths import SITES

SITE = SITES / "rclcpp"


def test_names_of_published_packages_work_or_say_why_not(played: Played) -> None:
    names = played(SITE, "names", "names")
    assert names.lines() == [
        "set 1, speed 2.5",
        "waited, speed 2.5",
        "copied 2.5",
        "heard 2",
        "took 1, by hand, the same 1",
        "slept 0",
        "reset 2",
        "reset 1",
        "steady 1, on time 1",
        "overflows 1",
        "in the context 3",
        "malloc 1 0 1",
        "tid 1, other -1",
        "backtrace 1, path 4096",
        "parallel 1 7, sum 15",
        "sched_setscheduler -1 EPERM",
        "mlockall -1 EPERM",
        "setpriority -1 EPERM",
        "cap_set_proc -1 EPERM",
        "thread 1",
        "attributes 0 0 0",
        "opened 0: libother.so: cannot open: a page cannot load libraries, and the program is not "
        "linked with this one",
        "library refused",
        "MultiLibraryClassLoader: no loaded library has the class missing",
    ]
