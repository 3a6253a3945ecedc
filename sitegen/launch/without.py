"""Unsupported launch features, and the notes about them."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator

from sitegen.launch.tree import Action

LEFT_OUT = {"event": "skipped: this event is not supported in the browser"}
# What an event says: see LOCAL in describe_events.py.
FACT = re.compile("\ue000.*?\ue001")
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
