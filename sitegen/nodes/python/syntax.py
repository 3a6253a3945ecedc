"""Check the syntax of Python programs, as the compiler does for C++."""

from __future__ import annotations

import re
import sys
import warnings
from collections.abc import Iterable
from pathlib import Path

from sitegen.errors import Location, Problems
from sitegen.nodes.python import pyodide

# Syntax that the Python of the page may have and that of this computer may lack.
NEWER = re.compile(r"""\s*type\s+\w+.*=|\s*(async\s+)?(def|class)\s+\w+\[|.*\b[tT][rR]?["']""")
MESSAGES = ("f-string", "multiple exception types must be parenthesized")


def check(files: Iterable[Path], problems: Problems) -> None:
    """Report the first syntax error of each of `files` below the root of the site."""
    for file in dict.fromkeys(files):
        if not file.is_relative_to(problems.root):
            continue
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                compile(file.read_bytes(), str(file), "exec", dont_inherit=True)
        except SyntaxError as error:
            text = (error.text or "").strip()
            if not _is_newer(text, error.msg):
                quoted = f": '{text}'" if text else ""
                problems.add(Location(file, error.lineno or 1), "syntax", f"{error.msg}{quoted}")
        except (ValueError, RecursionError, MemoryError) as error:
            problems.add(Location(file, 1), "syntax", f"not valid Python: {error}")


def _is_newer(line: str, message: str) -> bool:
    """Return whether the page may accept a line that this Python does not."""
    page = tuple(map(int, pyodide.python_version().split(".")))
    older = sys.version_info[:2] < page[:2]
    return older and (message.startswith(MESSAGES) or bool(NEWER.match(line)))
