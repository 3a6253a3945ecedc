"""Split and join command lines that contain substitutions.

The value of a substitution is never split or expanded again, whatever characters it contains.
"""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable, Iterable, Iterator

from sitegen.launch.substitutions import pieces

# Placeholders for substitutions while a line is split, from a private range of Unicode.
FIRST_MARK = 0xF0000
MARK = re.compile(f"[{chr(FIRST_MARK)}-{chr(FIRST_MARK + 0xFFFD)}]")


def split(line: str, expand: Callable[[str], str], *, escapes: bool = False) -> list[str]:
    """Split a line into words as a shell does, and expand the substitutions in them.

    With `escapes`, the line has those of XML and YAML files.

    Raises: ValueError if a quote is not closed.
    """
    kept: list[str] = []

    def marked() -> Iterator[str]:
        for piece, substitution in pieces(line, escapes=escapes):
            if substitution:
                kept.append(piece)
            yield chr(FIRST_MARK + len(kept) - 1) if substitution else piece

    words = shlex.split("".join(marked()))
    return [MARK.sub(lambda mark: expand(kept[ord(mark[0]) - FIRST_MARK]), word) for word in words]


def join(words: Iterable[str]) -> str:
    """Return the line that split() turns into `words`, if there are no escapes."""
    return " ".join(_quoted(word) for word in words)


def _quoted(word: str) -> str:
    parts = (piece if found else shlex.quote(piece) for piece, found in pieces(word))
    return "".join(parts) or "''"
