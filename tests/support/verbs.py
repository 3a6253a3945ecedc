"""The commands of `ros2` in terminals, asked in Node."""

from __future__ import annotations

import json
import subprocess
from typing import Any

from paths import SUPPORT


def asked(what: str, given: Any = None) -> Any:
    """Return what verbs.mjs prints."""
    command = ["node", str(SUPPORT / "verbs.mjs"), what]
    text = json.dumps(given)
    done = subprocess.run(command, input=text, text=True, capture_output=True, check=True)
    return json.loads(done.stdout)
