"""A prompt: runs what a visitor types, with rclpy at hand."""

from __future__ import annotations

import code
import rlcompleter
import sys
from itertools import count
from typing import Any

import ros_host

from rclpy_backend.system import blocking
from rclpy_backend.system.tracebacks import traceback_of

# More words than anybody reads.
MOST_WORDS = 100


class Console(code.InteractiveConsole):
    """Runs what is typed; an interrupt is told as Python tells it."""

    def showtraceback(self) -> None:
        """Print the exception that was raised."""
        error = sys.exc_info()[1]
        if isinstance(error, KeyboardInterrupt):
            self.write(traceback_of(error))
        else:
            super().showtraceback()


def main() -> None:
    """Read, run and print until the program is ended."""
    import rclpy
    from rclpy.signals import SignalHandlerOptions

    # An interrupt ends what runs, and not ROS with it.
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
    """Run the next line that comes; return whether what was typed goes on."""
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
        except Exception:  # of the properties of what stands before the dot
            break
        if word is None or len(found) == MOST_WORDS:
            break
        found[word] = None
    return to_js(list(found))
