"""Read a launch file in a page, with the arguments that a visitor gives.

Pyodide runs this in a worker (workers/launch/launchReader.js), with the files of packages where
programs of the page have them.
"""

from __future__ import annotations

import json
from pathlib import Path

from sitegen.errors import Problems
from sitegen.launch.absent import elsewhere
from sitegen.launch.evaluate import launched
from sitegen.launch.written import launch_entry
from sitegen.model import Launch, Package

SHARE = Path("/ros/share")


def read_again(path: str, given: str, environment: str, share: Path = SHARE) -> str:
    """Return what the launch file at `path`, below `share`, does with the arguments `given`.

    The arguments, the environment and the result are JSON. The result has the nodes (`name`,
    `package`, `executable`, `arguments`, `environment`), the `launch` as in page.json, and lines of
    `problems` and `notes`.
    """
    root = share.resolve()
    packages = {
        folder.name: Package(folder.name, folder, "", (), None, ()) for folder in root.iterdir()
    }
    problems, notes = Problems(root), Problems(root)
    variables = json.loads(environment)
    found = launched(
        root / path, json.loads(given), packages, problems, notes, variables, elsewhere
    )
    names = tuple(node.name for node in found.nodes)
    launch = Launch("", "", names, tuple(found.handlers), tuple(found.arguments))
    nodes = [
        {
            "name": node.name,
            "package": node.package,
            "executable": node.executable,
            "arguments": node.command_line(),
            **({"environment": dict(node.environment)} if node.environment else {}),
        }
        for node in found.nodes
    ]
    return json.dumps(
        {
            "nodes": nodes,
            "launch": launch_entry(launch, ()),
            "problems": problems.lines,
            "notes": notes.lines,
        }
    )
