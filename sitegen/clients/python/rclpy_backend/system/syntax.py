"""Find syntax errors without running anything."""

from __future__ import annotations

import warnings
from typing import Any

from pyodide.ffi import to_js


def check(text: str) -> Any:
    """Return the line and the message of the first syntax error, or 0 and an empty text."""
    try:
        with warnings.catch_warnings(action="ignore"):
            compile(text, "", "exec", dont_inherit=True)
    except SyntaxError as error:
        return to_js([error.lineno or 1, error.msg])
    except ValueError as error:  # a null character
        return to_js([1, str(error)])
    return to_js([0, ""])
