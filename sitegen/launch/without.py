"""What of launch files a page does without, and what its author gets to know of that."""

from __future__ import annotations

from collections.abc import Collection

# Of no consequence for what runs on a page.
IGNORED = {"append_env", "log", "set_env", "unset_env"}
STATES = "launch files cannot change node states in the browser"
LEFT_OUT = {
    "event": "skipped: launch events are not supported in the browser",
    "event_handler": "skipped: launch events are not supported in the browser",
    "lifecycle_transition": f"skipped: {STATES}",
    "shutdown": "skipped: a page runs until it is closed",
}
ON_EXIT = "'on_exit' is ignored: nodes in the browser do not stop each other"
AUTOSTART = f"'autostart' is ignored: {STATES}"
OF_SYSTEM = "skipped: system programs cannot run in the browser"
# Packages of programs that draw on a screen of their own.
SCREENS = ("rviz", "rqt", "gazebo", "ros_gz")
# Programs that read the keys of a terminal.
KEYS = {("turtlesim", "turtle_teleop_key"): "use the arrow keys in the turtlesim window"}


def program(package: str, executable: str, packages: Collection[str]) -> str:
    """Return why a page does without a program, or nothing; `packages` are in the workspace."""
    if package.startswith(SCREENS) and package not in packages:
        return f"'{package}' is skipped: it needs a desktop window"
    if instead := KEYS.get((package, executable)):
        return f"'{executable}' is skipped: it reads keys from a terminal; {instead}"
    return ""
