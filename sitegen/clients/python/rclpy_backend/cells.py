"""Run the Python cells of a page, without IPython."""

from __future__ import annotations

import ast
import base64
import inspect
import json
import linecache
import re
import rlcompleter
import sys
from collections.abc import Callable
from itertools import count
from typing import Any

from rclpy_backend.notebook import Kernel
from rclpy_backend.system.tracebacks import traceback_of

# The images that a value can show of itself, by media type; anything else is shown as its repr().
METHODS = {
    "image/png": "_repr_png_",
    "image/jpeg": "_repr_jpeg_",
    "image/svg+xml": "_repr_svg_",
}
# The largest text that is shown of a value, and the largest HTML.
LONGEST = 100_000
LONGEST_HTML = 1_000_000
# The maximum number of completions.
MOST_WORDS = 100
# The end of what may be completed: a name, or names with dots.
NAME = re.compile(r"[\w.]+$")


class Shell:
    """Runs cells one after another, in one namespace."""

    def __init__(self, tell: Callable[..., None]) -> None:
        self._tell = tell
        self._names: dict[str, Any] = {"__name__": "__main__", "display": self._display}
        self._count = 0

    async def run(self, code: str) -> dict[str, Any]:
        """Run a cell and show the value of its last expression, as IPython does."""
        self._count += 1
        name = f"<cell {self._count}>"
        linecache.cache[name] = (len(code), None, code.splitlines(keepends=True), name)
        try:
            tree = ast.parse(code, name)
            last = tree.body[-1] if tree.body else None
            value = None
            if isinstance(last, ast.Expr):
                tree.body.pop()
                await self._execute(tree, name, "exec")
                value = await self._execute(ast.Expression(last.value), name, "eval")
            else:
                await self._execute(tree, name, "exec")
            if value is not None:
                self._names["_"] = value
                self._tell("result", data=_bundle(value))
        except BaseException as error:
            sys.stdout.flush()
            found = {"ename": type(error).__name__, "evalue": str(error)}
            return {"status": "error", **found, "traceback": [traceback_of(error)]}
        finally:
            sys.stdout.flush()
            sys.stderr.flush()
        return {"status": "ok"}

    def complete(self, code: str, at: int) -> dict[str, Any]:
        """Return what can replace the name before the place `at`."""
        name = NAME.search(code[:at])
        words: dict[str, None] = {}
        completer = rlcompleter.Completer(self._names)
        for state in count() if name else ():
            try:
                word = completer.complete(name[0], state) if name else None
            except Exception:  # raised by a property of the object before the dot
                break
            if word is None or len(words) == MOST_WORDS:
                break
            words[word] = None
        return {"matches": [*words], "start": name.start() if name else at, "end": at}

    async def _execute(self, tree: ast.Module | ast.Expression, name: str, mode: str) -> Any:
        code = compile(tree, name, mode, flags=ast.PyCF_ALLOW_TOP_LEVEL_AWAIT)
        value = eval(code, self._names)  # the purpose of a cell
        return await value if code.co_flags & inspect.CO_COROUTINE else value

    def _display(self, *values: object) -> None:
        for value in values:
            self._tell("display", data=_bundle(value))


def _bundle(value: object) -> dict[str, str]:
    """Return what is shown of a value, by media type; images are in base64."""
    found = {"text/plain": repr(value)[:LONGEST]}
    if isinstance(value, type):
        return found
    if callable(method := getattr(value, "_repr_mimebundle_", None)):
        bundle = method()
        data = bundle[0] if isinstance(bundle, tuple) else bundle
        found |= {
            kind: one if isinstance(one, str) else json.dumps(one) for kind, one in data.items()
        }
    if callable(method := getattr(value, "_repr_html_", None)) and (html := method()):
        found["text/html"] = str(html)[:LONGEST_HTML]
    for kind, name in METHODS.items():
        method = getattr(value, name, None)
        if callable(method) and (data := method()):
            raw = data.encode() if isinstance(data, str) else bytes(data)
            found[kind] = base64.b64encode(raw).decode()
    return found


def main() -> None:
    """Answer the requests of a page until the program ends."""
    Kernel(lambda kernel: Shell(kernel.tell)).serve()
