"""Split command lines of launch files into words, and join words to them.

What a substitution stands for is not split, and not read again, whatever it has in it: a file may.
"""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterable, Iterator

from sitegen.launch.substitutions import pieces

# Stand for substitutions while a line is split: the letters of a range that nobody writes.
FIRST_MARK = 0xF0000
MARK = re.compile(f"[{chr(FIRST_MARK)}-{chr(FIRST_MARK + 0xFFFD)}]")


def split(line: str) -> list[str]:
    """Return the words of a line as a shell has them, each with its substitutions as they are.

    Raises a ValueError where a quote is not closed.
    """
    kept: list[str] = []

    def marked() -> Iterator[str]:
        for piece, substitution in pieces(line):
            if substitution:
                kept.append(piece)
            yield chr(FIRST_MARK + len(kept) - 1) if substitution else piece

    words = shlex.split("".join(marked()))
    return [MARK.sub(lambda mark: kept[ord(mark[0]) - FIRST_MARK], word) for word in words]


def join(words: Iterable[str]) -> str:
    """Return the line that split() makes `words` of."""
    return " ".join(_quoted(word) for word in words)


def _quoted(word: str) -> str:
    parts = (piece if found else shlex.quote(piece) for piece, found in pieces(word))
    return "".join(parts) or "''"
