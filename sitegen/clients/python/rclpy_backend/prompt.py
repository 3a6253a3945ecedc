"""A Python prompt with rclpy imported."""

from __future__ import annotations

import code
import rlcompleter
import sys
from itertools import count
from typing import Any

import ros_host

from rclpy_backend.system import blocking
from rclpy_backend.system.tracebacks import traceback_of

# The maximum number of completions.
MOST_WORDS = 100


class Console(code.InteractiveConsole):
    """Runs the input, and prints exceptions as Python does."""

    def showtraceback(self) -> None:
        """Print the current exception."""
        error = sys.exc_info()[1]
        if isinstance(error, KeyboardInterrupt):
            self.write(traceback_of(error))
        else:
            super().showtraceback()


def main() -> None:
    """Read, run and print until the program ends."""
    import rclpy
    from rclpy.signals import SignalHandlerOptions

    # An interrupt stops the running command without shutting down ROS.
    rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
    version = ".".join(map(str, sys.version_info[:3]))
    print(f"Python {version}, rclpy is imported. Try: node = rclpy.create_node('web_node')")
    sys.ps1, sys.ps2 = ">>> ", "... "
    names = {"__name__": "__main__", "__doc__": None, "rclpy": rclpy}
    console = Console(names)
    completer = rlcompleter.Completer(names)
    more = False
    while True:
        try:
            more = _serve(console, completer, more)
        except KeyboardInterrupt:
            print("KeyboardInterrupt")
            console.resetbuffer()
            more = False


def _serve(console: Console, completer: rlcompleter.Completer, more: bool) -> bool:
    """Run the next line; return whether the command is incomplete."""
    sys.stdout.flush()
    sys.stderr.flush()
    ros_host.ready(more)
    while (typed := ros_host.typed()) is None:
        blocking.wait(None)
    if typed.op == "complete":
        ros_host.complete(typed.text, _words(completer, typed.text))
        return more
    return console.push(typed.text)


def _words(completer: rlcompleter.Completer, text: str) -> Any:
    from pyodide.ffi import to_js

    found: dict[str, None] = {}
    for state in count():
        try:
            word = completer.complete(text, state)
        except Exception:  # raised by a property of the object before the dot
            break
        if word is None or len(found) == MOST_WORDS:
            break
        found[word] = None
    return to_js(list(found))
