"""Unsupported launch features, and the notes about them."""

from __future__ import annotations

from collections.abc import Collection

# Actions without an effect in the browser.
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
# Prefixes of packages whose programs open desktop windows.
SCREENS = ("rviz", "rqt", "gazebo", "ros_gz")
# Programs that read keys from a terminal.
KEYS = {("turtlesim", "turtle_teleop_key"): "use the arrow keys in the turtlesim window"}


def program(package: str, executable: str, packages: Collection[str]) -> str:
    """Return the note about an unsupported program, else ""; `packages` are in the workspace."""
    if package.startswith(SCREENS) and package not in packages:
        return f"'{package}' is skipped: it needs a desktop window"
    if instead := KEYS.get((package, executable)):
        return f"'{executable}' is skipped: it reads keys from a terminal; {instead}"
    return ""
