"""Import the modules of rosidl, which are vendored because its wheels are for one platform."""

from __future__ import annotations

import importlib
import re
import sys
from typing import Any

from sitegen.shipped import ROS

PARSER = "rosidl_adapter.parser"
# Matches what rosidl's own pattern matches. That one tries all ways to divide a name: 26 letters
# with a lower-case one at the end took minutes, and each further letter doubles the time.
CONSTANT_NAME = re.compile(r"^[A-Z](_?[A-Z0-9])*$")


def module(name: str) -> Any:
    """Return a module of rosidl."""
    python = str(ROS / "python")
    if python not in sys.path:
        sys.path.insert(0, python)
    parser: Any = importlib.import_module(PARSER)
    parser.VALID_CONSTANT_NAME_PATTERN = CONSTANT_NAME
    return importlib.import_module(name)
