"""Link a program that finds functions of its libraries by name, with dlopen() and dlsym().

CMake runs this in front of each command that links a program, as a separate program:
`python loadable.py PACKAGES COMMAND...`. All libraries are linked into the program, and WebAssembly
has no names in it. So the C functions and variables of the libraries that packages build below the
folder PACKAGES get into a table (src/platform/dynamic.cpp reads it). Libraries with plugins have
functions of the same name, or copies of what others contain: each gets a name of its library, which
other files of this library use. The one that is linked first also keeps the name in its source, as
on a robot.
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

# The functions that ask for others, as they are in the imports of an object file.
ASKS = re.compile(rb"dlopen|dlsym|rcutils_load_shared_library")
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


def with_table(command: Sequence[str], packages: Path) -> list[str]:
    """Return a command that links a program with its table, which is compiled here.

    In place of a library with C functions, or one that is linked as a whole, the command has all
    object files of it.
    """
    output = Path(command[command.index("-o") + 1])
    folder = Path("CMakeFiles", f"{output.stem}.dlopen")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    paths = {word: path for word in command if (path := _library(word, packages))}
    libraries = read_libraries(paths.values())
    whole = {path for word, path in paths.items() if word.startswith("-")}
    opened = [one for one in libraries if one.declared or one.path in whole]
    own = [Object(Path(word).read_bytes(), "").names for word in command if word.endswith(".o")]
    count = Counter(name for names in (*own, *(one.names for one in libraries)) for name in names)
    copies = {name for name in count if count[name] > 1}
    files = {one.path: one.write(folder, copies) for one in opened}
    words: list[str] = []
    for word in command:
        path = paths.get(word)
        if path in files:
            words += files[path]
            files[path] = []  # the command may name the library again
        else:
            words.append(word)
    source, table = folder / "symbols.cpp", folder / "symbols.o"
    source.write_text(_table(libraries), encoding="utf-8")
    # Flags that the environment has are for the linker.
    environment = {name: value for name, value in os.environ.items() if name != "EMCC_CFLAGS"}
    subprocess.run([command[0], "-c", source, "-o", table], check=True, env=environment)
    return [*words, str(table)]


def _library(word: str, packages: Path) -> Path | None:
    """Return the library of a package that a word of the command names."""
    found = ARCHIVE.match(word)
    path = Path(found[1]).resolve() if found else packages
    return path if path.is_relative_to(packages) and path.is_file() else None


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
        words = with_table(words, root)
    if is_long:
        response = Path("CMakeFiles", f"{Path(words[words.index('-o') + 1]).stem}.linked.rsp")
        response.write_text(shlex.join(words[1:]), encoding="utf-8")
        words[1:] = [f"@{response.as_posix()}"]
    return subprocess.run(words).returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
