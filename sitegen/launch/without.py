"""Unsupported launch features, and the notes about them."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator

from sitegen.launch.tree import Action

NO_EVENT = "skipped: this event is not supported in the browser"
LEFT_OUT = {"event": NO_EVENT}
# Functions that events would call.
FUNCTION = "skipped: the functions of a launch file run when the site is built, not on the page"
NOT_MEANT = "skipped: only nodes of the launch file can be meant here"
NOT_HERE = "skipped: what it waits for does not run on the page"
# What stands around the name of a value that only an event has, such as `event.returncode`.
LOCAL = ("\ue000", "\ue001")
FACT = re.compile(".*?".join(LOCAL))
NOT_YET = "what an event says is left out here; it can be logged, but not given to a node"
LOADED = "a page loads components with their container, not later"
SHUTDOWN = "skipped: the nodes of the page would stop at once"
OPTIONS = {
    "cwd": "'cwd' is ignored: a node in the browser has a folder of its own",
    "launch_prefix": "'launch-prefix' is ignored: nodes in the browser run by themselves",
}
DOMAIN = "ROS_DOMAIN_ID"
ONE_DOMAIN = f"'{DOMAIN}' has no effect: all nodes of a page are in one domain"
OF_SYSTEM = "skipped: system programs cannot run in the browser"
# Prefixes of packages whose programs open desktop windows.
SCREENS = ("rviz", "rqt", "gazebo", "ros_gz")
# Programs that read keys from a terminal.
KEYS = {("turtlesim", "turtle_teleop_key"): "use the arrow keys in the turtlesim window"}


def parts(action: Action) -> Iterator[str]:
    """Yield a note about each option of a node that is ignored."""
    for name, why in OPTIONS.items():
        if action.attributes.get(name, "false").lower() != "false":
            yield why


def program(package: str, executable: str, packages: Collection[str]) -> str:
    """Return the note about an unsupported program, else ""; `packages` are in the workspace."""
    if package.startswith(SCREENS) and package not in packages:
        return f"'{package}' is skipped: it needs a desktop window"
    if instead := KEYS.get((package, executable)):
        return f"'{executable}' is skipped: it reads keys from a terminal; {instead}"
    return ""
