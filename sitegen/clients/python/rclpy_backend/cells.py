"""Run the Python cells of a page, without IPython."""

from __future__ import annotations

import ast
import base64
import inspect
import linecache
import sys
from collections.abc import Callable
from typing import Any

from rclpy_backend.notebook import Kernel
from rclpy_backend.system.tracebacks import traceback_of

# What a value can show of itself, by media type; anything else is shown as its repr().
METHODS = {
    "image/png": "_repr_png_",
    "image/jpeg": "_repr_jpeg_",
    "image/svg+xml": "_repr_svg_",
}
# The largest text that is shown of a value.
LONGEST = 100_000


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
    for kind, name in METHODS.items():
        method = getattr(value, name, None)
        if callable(method) and not isinstance(value, type) and (data := method()):
            raw = data.encode() if isinstance(data, str) else bytes(data)
            found[kind] = base64.b64encode(raw).decode()
    return found


def main() -> None:
    """Answer the requests of a page until the program ends."""
    Kernel(lambda kernel: Shell(kernel.tell)).serve()
