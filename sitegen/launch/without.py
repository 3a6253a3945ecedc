"""What of launch files a page does without, and what its author gets to know of that."""

from __future__ import annotations

from collections.abc import Collection

# Of no consequence for what runs on a page.
IGNORED = {"append_env", "log", "set_env", "unset_env"}
STATES = "a launch file does not change the states of nodes in a page"
LEFT_OUT = {
    "event": "events of launch files do not happen in a page; this is left out",
    "event_handler": "events of launch files do not happen in a page; this is left out",
    "lifecycle_transition": f"{STATES}; this is left out",
    "shutdown": "a page ends when its reader leaves it; this is left out",
}
ON_EXIT = "programs of a page do not end with another one; 'on_exit' is left out"
AUTOSTART = f"{STATES}; 'autostart' is left out"
OF_SYSTEM = "a program of the system does not run in a page; this is left out"
# Packages of programs that draw on a screen of their own.
SCREENS = ("rviz", "rqt", "gazebo", "ros_gz")
# Programs that read the keys of a terminal.
KEYS = {("turtlesim", "turtle_teleop_key"): "the window of turtlesim has keys"}


def program(package: str, executable: str, packages: Collection[str]) -> str:
    """Return why a page does without a program, or nothing; `packages` are in the workspace."""
    if package.startswith(SCREENS) and package not in packages:
        return f"'{package}' draws on a screen of its own and is left out of the page"
    if instead := KEYS.get((package, executable)):
        return f"'{executable}' reads the keys of a terminal and is left out; {instead}"
    return ""
