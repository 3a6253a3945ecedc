"""Run a command of the compiler without options that only other compilers know.

CMake runs this in front of each command that compiles, or links a program, as a separate program:
`python flags.py COMMAND...`. Packages give options of g++, of its linker and of the robot's
processor. Those that em++ refuses change nothing that a page could show: they are left out, or
replaced by what comes next to them.
"""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator, Sequence

# em++ reads a level that it does not know as a number.
SAME = {
    "-Og": ["-O1"],
    "-Ofast": ["-O3", "-ffast-math"],
    "-std=c++23": ["-std=c++2b"],
    "-std=gnu++23": ["-std=gnu++2b"],
    # Of a library (workspace/libraries.py): without the instructions of other processors.
    "-mvectors": ["-msimd128"],
}
# Warnings as errors: em++ warns of more than the compiler that the author knows, which is no error
# of the program. Processors: all options but those of WebAssembly. Libraries of g++ and of glibc
# that are part of the page's C++ library, or that nothing needs.
DROPPED = re.compile(
    r"-Werror(=.*)?$|-pedantic-errors$|-fcf-protection(=.*)?$"
    r"|-m(?!llvm$|(no-)?(atomics|bulk-memory|exception-handling|extended-const|multivalue|"
    r"mutable-globals|nontrapping-fptoint|reference-types|relaxed-simd|sign-ext|tail-call)$)"
    r"|-l(anl|atomic|crypt|gcc|gcc_s|gcov|gomp|nsl|quadmath|resolv|stdc\+\+fs|supc\+\+|util)$"
)
# Options of GNU's linker.
LINKING = re.compile(
    r"--(no-)?(as-needed|copy-dt-needed-entries|allow-shlib-undefined|fatal-warnings)$"
    r"|--no-undefined$|--(en|dis)able-new-dtags$|--sort-common$"
    r"|-B(static|dynamic|symbolic(-functions)?)$"
    r"|--(build-id|hash-style|unresolved-symbols|exclude-libs|version-script|dynamic-list)(=|$)"
)
WITH_ARGUMENT = ("--exclude-libs", "--version-script", "--dynamic-list")
# What the compiler says about an option that it does not know.
UNKNOWN = re.compile(rb"error: (?:unknown argument:?|unsupported option) '([^']+)'")
# These options have no effect, which is no news to anybody.
QUIET = ("-Wno-unused-command-line-argument", "-Wno-ignored-optimization-argument")


def translated(words: Sequence[str]) -> Iterator[str]:
    """Yield the words of a command as em++ knows them."""
    # SSE and the like are written in terms of this one, if the author wants that.
    vectors = "-msimd128" in words
    for word in words:
        if word.startswith("-Wl,"):
            yield from _linking(word.split(",")[1:])
        elif vectors and word.startswith("-m"):
            yield word
        elif word in SAME:
            yield from SAME[word]
        elif not DROPPED.match(word):
            yield word


def _linking(options: Sequence[str]) -> Iterator[str]:
    rest = iter(options)
    kept = ["-Wl"]
    for option in rest:
        if not LINKING.match(option):
            kept.append(option)
        elif option in WITH_ARGUMENT:
            next(rest, "")
    if len(kept) > 1:
        yield ",".join(kept)


def main(*words: str) -> int:
    """Run a command, again if it has unknown options; return its exit code."""
    command = [*translated(words)]
    if "-c" in command:
        command += QUIET
    while True:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        unknown = {name.decode() for name in UNKNOWN.findall(done.stdout)}
        known = [word for word in command if word not in unknown]
        if not done.returncode or known == command:
            sys.stdout.buffer.write(done.stdout)
            return done.returncode
        command = known


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
