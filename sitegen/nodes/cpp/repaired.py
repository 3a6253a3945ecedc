"""Run the C++ compiler on a source that g++ accepts and clang 14 does not.

precompiled.py runs this as a separate program, when a source does not compile: `python repaired.py
em++ ...`. Clang 14 wants the word `template` where g++ finds out by itself, and its lambdas do not
capture structured bindings, which is in C++20. Each such error has a place; what is lacking there
is inserted in a copy, which the compiler reads in place of the file. The output is that of the last
run.
"""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path

ERROR = re.compile(r"^(?P<file>/[^:\n]+):(?P<line>\d+):(?P<column>\d+): error: (?P<what>.+)$", re.M)
KEYWORD = re.compile(r"use 'template' keyword to treat '\w+' as a dependent template name")
CAPTURED = re.compile(r"'(\w+)' in capture list does not name a variable")
USED = re.compile(r"reference to local binding '(\w+)' declared in enclosing function")
# The beginning of a lambda that captures all that it uses.
LAMBDA = re.compile(r"\[\s*(?P<how>[&=])\s*(?=[],])")
# Insertions for other errors than these would be guesses.
REPAIRED = (KEYWORD, CAPTURED, USED)
# Nested lambdas need one each.
ROUNDS = 8

# Where to insert what, in each file.
Insertions = dict[Path, set[tuple[int, str]]]


def insertions(output: str, texts: dict[Path, str]) -> Insertions | None:
    """Return what the errors in `output` ask for; None if there are others.

    `texts` are those of the files as the compiler read them.
    """
    found: Insertions = {}
    for error in ERROR.finditer(output):
        if not any(each.match(error["what"]) for each in REPAIRED):
            return None
        file = Path(error["file"])
        text = texts.setdefault(
            file, file.read_text(encoding="utf-8-sig", errors="surrogateescape")
        )
        at = _position(text, int(error["line"]), int(error["column"]))
        if KEYWORD.match(error["what"]):
            found.setdefault(file, set()).add((at, "template "))
        elif captured := CAPTURED.match(error["what"]):
            found.setdefault(file, set()).add((at, f"{captured[1]} = "))
        elif used := USED.match(error["what"]):
            found.setdefault(file, set()).update(_captures(text, at, used[1]))
    return {file: new for file, new in found.items() if new}


def _position(text: str, line: int, column: int) -> int:
    """Return the index of a place; columns count bytes."""
    lines = text.splitlines(keepends=True)
    before = lines[line - 1].encode("utf-8", "surrogateescape")[: column - 1]
    return sum(map(len, lines[: line - 1])) + len(before.decode("utf-8", "surrogateescape"))


def _captures(text: str, at: int, name: str) -> Iterator[tuple[int, str]]:
    """Yield the capture of a binding for the outermost lambda after it that is around a use."""
    bindings = re.compile(rf"\[[\w\s,]*\b{name}\b[\w\s,]*\]\s*[:=({{]")
    declared = max((each.end() for each in bindings.finditer(text, 0, at)), default=at)
    for start in LAMBDA.finditer(text, declared, at):
        if _end(text, start.end()) > at:
            mark = "&" if start["how"] == "&" else ""
            capture = f", {mark}{name} = {name}"
            if capture not in text[start.start() : text.index("]", start.end())]:
                yield start.end("how"), capture
                return


def _end(text: str, start: int) -> int:
    """Return where the body of a lambda ends that begins before `start`."""
    depth = 0
    for index in range(text.find("{", start), len(text)):
        depth += {"{": 1, "}": -1}.get(text[index], 0)
        if depth == 0:
            return index
    return len(text)


def inserted(text: str, changes: set[tuple[int, str]]) -> str:
    """Return `text` with all changes."""
    for at, new in sorted(changes, reverse=True):
        text = text[:at] + new + text[at:]
    return text


def main(*words: str) -> int:
    """Run the compiler until nothing can be inserted; return its exit code."""
    texts: dict[Path, str] = {}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(ROUNDS):
            done = _run([*words, "-ferror-limit=0", *_remapped(texts, Path(folder))])
            output = done.stdout.decode(errors="replace")
            changes = insertions(output, texts) if done.returncode else None
            if not changes:
                break
            for file, new in changes.items():
                texts[file] = inserted(texts[file], new)
    sys.stdout.buffer.write(done.stdout)
    return done.returncode


def _remapped(texts: dict[Path, str], folder: Path) -> list[str]:
    """Write the copies; return the options that put them in place of their files."""
    options = []
    for number, (file, text) in enumerate(texts.items()):
        copy = folder / str(number)
        copy.write_text(text, encoding="utf-8", errors="surrogateescape")
        options += ["-Xclang", "-remap-file", "-Xclang", f"{file};{copy}"]
    return options


def _run(words: Sequence[str]) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
