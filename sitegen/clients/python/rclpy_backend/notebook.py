"""A kernel of Jupyter: run the cells of a notebook in IPython, on the graph of the page.

Requests and answers are JSON texts; jupyter/kernel.js and ui/kernel.js are the other side.
"""

from __future__ import annotations

import asyncio
import json
from collections import deque
from collections.abc import Callable
from typing import Any

import ros_host

from rclpy_backend.system import blocking, loops

# What addresses in a notebook are relative to: its page, or the folder of the notebooks.
address = ""


class Loop(loops.Loop):
    """An event loop that also starts what the page asks for."""

    def __init__(self, kernel: Kernel) -> None:
        super().__init__()
        self._kernel = kernel

    def _process_events(self, event_list: list[object]) -> None:
        self._kernel.take()


class Kernel:
    """Answers the requests of a notebook, one at a time.

    `shell` makes what runs the cells: it has the methods of PyodideKernel that are called below.
    """

    def __init__(self, shell: Callable[[Kernel], Any]) -> None:
        self.loop = Loop(self)
        self._requests: deque[dict[str, Any]] = deque()
        self._replies: deque[str] = deque()
        self._task: asyncio.Task[None] | None = None
        self._over = False
        asyncio.set_event_loop(self.loop)
        self._shell = shell(self)

    def take(self) -> None:
        """Read what has arrived, and begin the next request if none is being answered."""
        self._read()
        if self._over:
            self.loop.stop()
        elif self._requests and self._task is None:
            self._task = self.loop.create_task(self._answer(self._requests.popleft()))

    def serve(self) -> None:
        """Answer requests until the page ends the kernel."""
        self.tell("ready")
        while not self._over:
            try:
                self.loop.run_forever()
            except KeyboardInterrupt:
                # It arrived while a cell awaited something, or while nothing ran.
                if self._task:
                    self._task.cancel()

    def ask(self, prompt: str, *, hidden: bool) -> str:
        """Ask the reader for a line, as input() does."""
        self._replies.clear()
        self.tell("input", prompt=prompt, hidden=hidden)
        while not self._replies:
            blocking.wait(None)
            self._read()
        return self._replies.popleft()

    def tell(self, op: str, **content: Any) -> None:
        """Send an answer, or output, to the notebook."""
        ros_host.answer(json.dumps({"op": op, **content}, default=repr))

    def _read(self) -> None:
        while (typed := ros_host.typed()) is not None:
            request = json.loads(typed.text)
            if request["op"] == "end":
                self._over = True
            elif request["op"] == "at":
                global address
                address = request["address"]
            elif request["op"] == "reply":
                self._replies.append(request["text"])
            else:
                self._requests.append(request)

    async def _answer(self, request: dict[str, Any]) -> None:
        op, code, at = request["op"], request.get("code", ""), request.get("at")
        try:
            if op == "run":
                found = await self._shell.run(code)
            elif op == "complete":
                found = self._shell.complete(code, at)
            elif op == "inspect":
                found = self._shell.inspect(code, at, request.get("detail", 0))
            else:
                found = self._shell.is_complete(code)
        except BaseException as error:  # the notebook waits for an answer
            name = type(error).__name__
            found = {"status": "error", "ename": name, "evalue": str(error), "traceback": []}
        finally:
            self._task = None
        self.tell("done", id=request["id"], content=found)
        # The loop turns once more only if something is scheduled.
        self.loop.call_soon(self.take)


def _ipython(kernel: Kernel) -> Any:
    """Import IPython, as Jupyter's kernel for the browser sets it up, and direct its output."""
    import builtins
    import getpass

    import pyodide_kernel  # type: ignore[import-not-found]

    def stream(name: str, text: str) -> None:
        kernel.tell("stream", name=name, text=text)

    pyodide_kernel.stdout_stream.publish_stream_callback = stream
    pyodide_kernel.stderr_stream.publish_stream_callback = stream
    shell = pyodide_kernel.ipython_shell
    shell.displayhook.publish_execution_result = lambda count, data, metadata: kernel.tell(
        "result", count=count, data=data, metadata=metadata or {}
    )
    shell.display_pub.display_data_callback = lambda data, metadata, transient: kernel.tell(
        "display", data=data, metadata=metadata or {}, transient=transient or {}
    )
    shell.display_pub.update_display_data_callback = lambda data, metadata, transient: kernel.tell(
        "update", data=data, metadata=metadata or {}, transient=transient or {}
    )
    shell.display_pub.clear_output_callback = lambda wait: kernel.tell("clear", wait=bool(wait))
    builtins.input = lambda prompt="": kernel.ask(str(prompt), hidden=False)
    getpass.getpass = lambda prompt="Password: ", *_, **__: kernel.ask(prompt, hidden=True)
    return pyodide_kernel.kernel_instance


def main() -> None:
    """Answer the requests of a notebook until the program ends."""
    Kernel(_ipython).serve()
