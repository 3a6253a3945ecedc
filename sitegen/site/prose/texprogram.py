"""Read formulas and write MathML, a line of JSON for each; tex.py runs this as a program."""

from __future__ import annotations

import contextlib
import json
import sys

from math_core import LatexError, LatexToMathML

# The most memory of this process (bytes).
MEMORY = 500_000_000


def main() -> None:
    """Answer `[tex, block]` with `[mathml, fault]`, of which one is empty."""
    with contextlib.suppress(ImportError, ValueError, OSError):  # Windows; a lower limit is set
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    sys.stdin.reconfigure(encoding="utf-8")  # type: ignore[union-attr]
    converter = LatexToMathML(fancy_error=False)
    for line in sys.stdin:
        tex, block = json.loads(line)
        found, fault = "", ""
        try:
            found = converter.convert_with_local_state(tex, displaystyle=block)
        except LatexError as error:
            fault = str(error.args[0])
        print(json.dumps([found, fault]), flush=True)


if __name__ == "__main__":
    main()
