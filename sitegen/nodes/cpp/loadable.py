"""Link what are shared libraries on a robot into one program.

CMake runs this in front of each command that links a program, as a separate program:
`python loadable.py PACKAGES COMMAND...`. Libraries that packages build below the folder PACKAGES
may have functions of the same name, such as those of plugins, or copies of what others contain,
such as functions in a header that are not inline: each gets a name of its library, which other
files of this library use. The one that is linked first also keeps the name in its source, as on a
robot.

A program that finds functions by name, with dlopen() and dlsym(), has no names in WebAssembly. So
the C functions and variables of its libraries get into a table (src/platform/dynamic.cpp reads it).
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Sequence
from pathlib import Path

if __name__ == "__main__":
    # As a program of its own, it does not search where sitegen is.
    sys.path.insert(0, str(Path(__file__).parents[3]))

from sitegen.nodes.cpp.flags import translated
from sitegen.nodes.cpp.objectfile import Object, members
from sitegen.workspace.libraries import COMPILED_BY

# The functions that ask for others, as they are in the imports of an object file.
ASKS = re.compile(rb"dlopen|dlsym|rcutils_load_shared_library")
# What the linker says of what several files define.
DUPLICATE = b"duplicate symbol: "
ARCHIVE = re.compile(r"(?:-Wl,--whole-archive,)?([^,]+\.(?:a|so))(?:,--no-whole-archive)?$")

TABLE = """\
struct Symbol {{const char * library; const char * name; const void * address;}};
extern "C" {{
{declarations}
extern const Symbol sitegen_symbols[] = {{
{entries}
  {{nullptr, nullptr, nullptr}}}};
}}
"""


class Library:
    """The library of a package at `path`. Its symbols end with `label`, which no other one has."""

    def __init__(self, path: Path, label: str) -> None:
        self.path = path
        self.label = label
        self.objects = [Object(data, label) for data in members(path.read_bytes())]
        self.names = {name for each in self.objects for name in each.names}
        self.declared = {
            name.decode(): declaration
            for each in self.objects
            for name, declaration in each.declared.items()
        }

    def write(self, folder: Path, copies: Collection[bytes]) -> list[str]:
        """Write the object files, with names of their own for `copies` too; return their paths."""
        names = {name for name in self.names if name.decode() in self.declared or name in copies}
        files = []
        for number, each in enumerate(self.objects):
            file = folder / f"{self.label}.{number}.o"
            file.write_bytes(each.renamed(names))
            files.append(str(file))
        return files


def read_libraries(paths: Iterable[Path]) -> list[Library]:
    """Return the libraries at these paths, each once."""
    libraries: list[Library] = []
    for path in dict.fromkeys(paths):
        taken = any(path.stem == one.path.stem for one in libraries)
        label = f"{path.stem}.{len(libraries)}" if taken else path.stem
        libraries.append(Library(path, f"{label}.so"))
    return libraries


def _table(libraries: Iterable[Library]) -> str:
    declarations: list[str] = []
    entries = []
    for library in libraries:
        name = library.path.stem
        entries.append(f'  {{"{name}", "", nullptr}},')
        for function, declaration in library.declared.items():
            symbol = f"symbol{len(declarations)}"
            label = f'__asm__("{function}@{library.label}")'
            declarations.append(f"{declaration % symbol} {label};")
            entries.append(f'  {{"{name}", "{function}", (const void *)&{symbol}}},')
    return TABLE.format(declarations="\n".join(declarations), entries="\n".join(entries))


def with_own_names(command: Sequence[str], packages: Path, *, opens: bool) -> list[str]:
    """Return a command that links libraries with names of their own.

    For a program that `opens` libraries, it has a table, which is compiled here, and all object
    files of libraries with C functions and of those that are linked as a whole.
    """
    folder = Path("CMakeFiles", f"{_output(command).stem}.dlopen")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    paths = {word: path for word in command if (path := _library(word, packages))}
    libraries = read_libraries(paths.values())
    whole = {path for word, path in paths.items() if word.startswith("-")}
    own = [Object(Path(word).read_bytes(), "").names for word in command if word.endswith(".o")]
    count = Counter(name for names in (*own, *(one.names for one in libraries)) for name in names)
    copies = {name for name in count if count[name] > 1}
    opened: dict[Path, list[str]] = {}
    archives: dict[Path, str] = {}
    for one in libraries:
        if opens and (one.declared or one.path in whole):
            opened[one.path] = one.write(folder, copies)
        elif one.names & copies:
            archives[one.path] = f"{folder / one.label}.a"
            _archive(command[0], archives[one.path], one.write(folder, copies))
    words: list[str] = []
    for word in command:
        path = paths.get(word)
        if path in opened:
            words += opened[path]
            opened[path] = []  # the command may name the library again
        elif path in archives:
            words.append(word.replace(ARCHIVE.sub(r"\1", word), archives[path]))
        else:
            words.append(word)
    return [*words, _compiled_table(command[0], libraries, folder)] if opens else words


def _archive(compiler: str, path: str, files: Sequence[str]) -> None:
    name = Path(compiler).name.replace("em++", "emar")
    subprocess.run([Path(compiler).with_name(name), "rcs", path, *files], check=True)


def _compiled_table(compiler: str, libraries: Iterable[Library], folder: Path) -> str:
    source, table = folder / "symbols.cpp", folder / "symbols.o"
    source.write_text(_table(libraries), encoding="utf-8")
    # Flags that the environment has are for the linker.
    environment = {name: value for name, value in os.environ.items() if name != "EMCC_CFLAGS"}
    subprocess.run([compiler, "-c", source, "-o", table], check=True, env=environment)
    return str(table)


def _output(command: Sequence[str]) -> Path:
    return Path(command[command.index("-o") + 1])


def _library(word: str, packages: Path) -> Path | None:
    """Return the library of a package that a word of the command names."""
    found = ARCHIVE.match(word)
    path = Path(found[1]).resolve() if found else packages
    if not path.is_relative_to(packages) or not path.is_file():
        return None
    # Nobody opens the libraries that come with sitegen, and many of them have functions of C.
    package = path.relative_to(packages).parts[0].rpartition("-")[0]
    return None if package in COMPILED_BY.values() else path


def _expanded(command: Sequence[str]) -> Iterator[str]:
    """Yield the words of a command and of its response files, which CMake writes if it is long."""
    for word in command:
        if word.startswith("@"):
            yield from translated(shlex.split(Path(word[1:]).read_text(encoding="utf-8")))
        else:
            yield word


def main(packages: str, *command: str) -> int:
    """Link a program, with a table if it asks for names; return the exit code."""
    root = Path(packages).resolve()
    words = [*_expanded(command)]
    is_long = len(words) > len(command)
    files = [Path(word) for word in words if word.endswith(".o")]
    files += filter(None, (_library(word, root) for word in words))
    if any(ASKS.search(path.read_bytes()) for path in files):
        words = with_own_names(words, root, opens=True)
    done = _linked(words, is_long=is_long)
    if done.returncode and DUPLICATE in done.stdout:
        done = _linked(with_own_names(words, root, opens=False), is_long=is_long)
    sys.stdout.buffer.write(done.stdout)
    return done.returncode


def _linked(words: list[str], *, is_long: bool) -> subprocess.CompletedProcess[bytes]:
    if is_long:
        response = Path("CMakeFiles", f"{_output(words).stem}.linked.rsp")
        response.write_text(shlex.join(words[1:]), encoding="utf-8")
        words = [words[0], f"@{response.as_posix()}"]
    return subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
