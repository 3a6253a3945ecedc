"""Run the C++ compiler, with a precompiled rclcpp.hpp if that does not change the result.

flags.py runs this in place of each em++ command that compiles, as a separate program: `python
precompiled.py STORE ROS em++ ...`. Most of the time that a node takes to compile is spent on
reading rclcpp.hpp, so it is precompiled once for each set of flags and kept in the folder STORE. A
source file uses it only if it includes rclcpp.hpp before anything that could make a difference. If
the compiler prints anything, it runs again without the precompiled header, so that messages are
always about the author's files.

A program that g++ compiles may name what other headers of its standard library include. Those of
libc++ include less, and those of the page less of rclcpp than upstream's. If the compiler does not
know such a name, it runs once more with all of them; if that fails, too, the messages are those of
the source as it is.

A source may have a part for each system that its author knows, and nothing for others. If one that
asks for Linux does not compile, or is empty elsewhere, it is compiled as on Linux. What g++ accepts
and clang does not is left to repaired.py.
"""

from __future__ import annotations

import contextlib
import hashlib
import re
import subprocess
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

# This runs as a separate program, without sitegen on its path, so it repeats a part of shipped.py.
PACKAGE = Path(__file__).absolute().parents[2]
LIBRARY = PACKAGE / "clients" / "cpp" / "include"
HEADER = LIBRARY / "rclcpp" / "rclcpp.hpp"
# The headers that complete the compiler's own (engine.cmake).
SYSTEM = LIBRARY.with_name("system")
# What programs need that include too few headers of the standard library, or of rclcpp.
STANDARD = LIBRARY.parent / "src" / "platform" / "standard.h"
UPSTREAM = STANDARD.with_name("upstream.h")
# What the compiler says about them.
UNKNOWN = re.compile(
    rb"error: (no (member|type|template) named '\w+' in namespace 'std'|"
    rb"implicit instantiation of undefined template 'std::|.*incomplete type 'std::|"
    rb"(use of undeclared identifier|unknown type name) '(u?int\w+_t|mem\w+|str\w+|pthread_\w+|"
    rb"\w*printf|u?sleep|getpid|isatty|read|write|close|errno|exit|abort|assert|time)')"
)
UNKNOWN_TO_ROS = re.compile(
    rb"error: (no (member|type|template) named '\w+' in "
    rb"namespace '(rclcpp|rcpputils|rcutils)[\w:]*'|"
    rb"(use of undeclared identifier|unknown type name) "
    rb"'((RCLCPP|RCPPUTILS|RCUTILS|RCL|RMW)_\w+|(rclcpp|rcpputils|rcutils|rcl|rmw)\w*)'|"
    rb".*(undefined template|incomplete type) '(const )?rclcpp::)"
)
# How sources ask for Linux, what they get, and what a source says that needs its drivers.
ASKS_FOR_LINUX = re.compile(r"\b__(gnu_)?linux(__)?\b")
LINUX = ("-D__linux__=1", "-D__linux=1", "-D__gnu_linux__=1")
CONDITION = re.compile(r"#\s*(if|else|endif)")
ONLY_LINUX = re.compile(r"#\s*if(def)?\s[^!]*\b__(gnu_)?linux(__)?\b[^!]*$")
NOT_FOUND = b" file not found"
# What repaired.py inserts something for.
OF_GCC = re.compile(
    rb"error: (use 'template' keyword to treat|reference to local binding '\w+' declared|"
    rb"'\w+' in capture list does not name a variable)"
)
REPAIRED = PACKAGE / "nodes" / "cpp" / "repaired.py"
# The interface packages that come with sitegen. The headers generated from them are in ROS.
INTERFACES = PACKAGE / "ros" / "include"
# Nothing in these headers depends on what was included before them.
OURS = (PACKAGE / "clients" / "cpp", PACKAGE / "packages", INTERFACES)

FOLDERS = ("-I", "-isystem")
# Options whose argument is a file of this one compilation.
OF_ONE_FILE = ("-o", "-MT", "-MF", "-MQ")
# Options that do not change the result of reading rclcpp.hpp: the compiler does not warn about
# headers that are not the author's.
NO_MATTER = re.compile(r"-(c|MM?D|W(?!system-headers)[^,]*|f\w+-prefix-map=.*)$")
# Options that ask for something else, or change what is read.
UNUSUAL = re.compile(
    r"@|-(E|S|M|MM|[xX].*|fmodules.*|include-pch|i(dirafter|macros|prefix|quote|with).*)$"
)

# Lines that continue after a backslash are left to the compiler.
COMMENT = re.compile(r"//(?:[^\\\n]|\\(?!\s*$))*|/\*.*?\*/", re.DOTALL | re.MULTILINE)
INCLUDE = re.compile(r'#\s*include\s*(?:"([^"]+)"|<([^>]+)>)$')
GUARD = re.compile(r"#\s*ifndef\s+([A-Za-z]\w*)\s*\n\s*#\s*define\s+(\w+)\s*$")
GENERATED = re.compile(r"\w+/(msg|srv|action)/(detail/)?\w+\.h(pp)?")


@dataclass
class Command:
    """A parsed command of the compiler."""

    source: Path = Path()
    # The folders with headers, in the order of the search.
    folders: list[Path] = field(default_factory=list)
    # Everything besides its files that distinguishes one compilation from another.
    flags: list[str] = field(default_factory=list)

    @staticmethod
    def read(words: Sequence[str]) -> Command | None:
        """Parse the arguments of the compiler; return None if any of them is unusual."""
        command, sources = Command(), list[Path]()
        near, far = list[Path](), list[Path]()
        rest = iter(words)
        for word in rest:
            option = next((one for one in FOLDERS if word.startswith(one)), "")
            if option:
                folder = Path(word.removeprefix(option) or next(rest)).absolute()
                (far if option == "-isystem" else near).append(folder)
            elif word in OF_ONE_FILE:
                next(rest)
            elif word == "-include":
                forced = next(rest)
                if not _is_in(Path(forced), OURS):
                    return None
                command.flags += [word, forced]
            elif UNUSUAL.match(word):
                return None
            elif not word.startswith("-"):
                sources.append(Path(word).absolute())
            elif not NO_MATTER.match(word):
                command.flags.append(word)
        if "-c" not in words or len(sources) != 1:
            return None
        if _is_in(LIBRARY, near):  # what there is to say of its headers would be said each time
            return None
        command.source, command.folders = sources[0], near + far
        return command


@dataclass
class Reader:
    """Reads the beginning of a source file as the preprocessor does."""

    folders: Sequence[Path]
    ros: Path
    _read: set[Path] = field(default_factory=set)

    def finds(self, source: Path) -> bool:
        """Return whether `source` includes rclcpp.hpp before anything that could make a difference.

        For the sources of sitegen, including any header of rclcpp is enough.
        """
        if self._reads(source):
            return True
        parts = list(LIBRARY.glob("rclcpp*"))
        return _is_in(source, OURS) and any(_is_in(file, parts) for file in self._read)

    def _reads(self, file: Path) -> bool | None:
        """Return what comes first: rclcpp.hpp (True), something else (False), or the end (None)."""
        self._read.add(file)
        text = COMMENT.sub(" ", file.read_text(encoding="utf-8-sig", errors="replace"))
        lines = [line.strip() for line in text.splitlines() if line.strip()]
        guard = GUARD.match("\n".join(lines[:2]))
        if guard and guard[1] == guard[2]:
            del lines[:2]
        for line in lines:
            include = INCLUDE.match(line)
            if include:
                found = self._follows(include[1], include[2], file.parent)
                if found is not None:
                    return found
            elif not re.match(r"#\s*pragma\s+once$", line):
                return False
        return None

    def _follows(self, quoted: str, angled: str, beside: Path) -> bool | None:
        name = quoted or angled
        candidates = (folder / name for folder in ([beside] if quoted else []) + [*self.folders])
        file = next((candidate for candidate in candidates if candidate.is_file()), None)
        if file == HEADER:
            return True
        if file is None or file in self._read:  # the compiler's own, or read already
            return None
        if _is_in(file, (self.ros, *OURS)):
            return self._reads(file) or None
        if GENERATED.fullmatch(name) and _is_in(file, [self.ros.parent.parent]):
            return None
        return self._reads(file)


def _is_in(file: Path, folders: Sequence[Path]) -> bool:
    return any(file.is_relative_to(folder) for folder in folders)


@dataclass(frozen=True)
class Store:
    """Keeps precompiled headers in `folder`, one for each set of flags."""

    folder: Path
    ros: Path

    def find(self, compiler: str, command: Command) -> Path | None:
        """Return the precompiled header for `command`, made if necessary; None if there is none."""
        key = hashlib.sha256("\0".join(command.flags).encode()).hexdigest()[:16]
        made = self.folder / f"{key}.pch"
        names = made.with_suffix(".names")
        self.folder.mkdir(parents=True, exist_ok=True)
        with _alone(self.folder / f"{key}.lock"):
            if not names.exists():
                names.write_text("\n".join(self._make(compiler, command.flags, made)))
        taken = set(names.read_text().split("\n"))
        others = set(command.folders) - set(self._folders)
        # A header with the same name in a folder of the author's would take precedence.
        there = {entry.name for folder in others if folder.is_dir() for entry in folder.iterdir()}
        return made if made.exists() and taken.isdisjoint(there) else None

    @property
    def _folders(self) -> list[Path]:
        return [SYSTEM, LIBRARY, *sorted(self.ros.iterdir()), *sorted(INTERFACES.iterdir())]

    def _make(self, compiler: str, flags: Sequence[str], made: Path) -> set[str]:
        """Precompile rclcpp.hpp; return the prefixes of the names of all headers in it."""
        draft, listed = made.with_suffix(".draft"), made.with_suffix(".d")
        work = self.ros.parent.parent
        maps = [f"-ffile-prefix-map={LIBRARY.parent}=rclcpp", f"-ffile-prefix-map={work}=build"]
        folders = [word for folder in self._folders for word in ("-isystem", str(folder))]
        how = ["-x", "c++-header", "-Xclang", "-fpch-instantiate-templates", str(HEADER)]
        kept = ["-MD", "-MF", str(listed), "-o", str(draft)]
        done = _run([compiler, *folders, *flags, *maps, *how, *kept])
        if done.returncode or done.stdout:
            draft.unlink(missing_ok=True)
            made.unlink(missing_ok=True)
            return set()
        headers = listed.read_text().replace("\\\n", " ").split()[1:]
        listed.unlink()
        names = {part for header in headers for part in self._first(Path(header))}
        draft.replace(made)
        return names

    def _first(self, header: Path) -> Iterator[str]:
        folder = next((one for one in self._folders if header.is_relative_to(one)), None)
        if folder:
            yield header.relative_to(folder).parts[0]
        else:  # one of the compiler's: <name> or <folder/name>
            yield from (header.name, header.parent.name)


@contextlib.contextmanager
def _alone(lock: Path) -> Iterator[None]:
    try:
        import fcntl
    except ImportError:  # Windows: what two make at once is the same
        yield
        return
    with lock.open("w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


def _asks_for_linux(command: Command) -> bool:
    """Return whether a source, or a header of the author that it includes, has a part for Linux."""
    waiting, seen = [command.source], set[Path]()
    while waiting:
        file = waiting.pop()
        if file in seen or not file.is_file() or _is_in(file, (*OURS, Path("/usr"))):
            continue
        seen.add(file)
        text = file.read_text(encoding="utf-8-sig", errors="replace")
        if ASKS_FOR_LINUX.search(text):
            return True
        found = filter(None, (INCLUDE.match(line.strip()) for line in text.splitlines()))
        folders = (file.parent, *command.folders)
        waiting += [folder / (one[1] or one[2]) for one in found for folder in folders]
    return False


def _is_for_linux(source: Path) -> bool:
    """Return whether a source has parts for Linux and maybe other systems, and nothing else."""
    text = COMMENT.sub(" ", source.read_text(encoding="utf-8-sig", errors="replace"))
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    if not lines or not ONLY_LINUX.match(lines[0]):
        return False
    depth = 0
    for number, line in enumerate(lines, 1):
        kind = condition[1] if (condition := CONDITION.match(line)) else ""
        depth += {"if": 1, "endif": -1}.get(kind, 0)
        if (kind == "else" and depth == 1) or (depth == 0 and number < len(lines)):
            return False
    return True


def _run(words: Sequence[str]) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def main(store: str, ros: str, compiler: str, *words: str) -> int:
    """Run the compiler; return its exit code."""
    made = None
    command = Command.read(words)
    with contextlib.suppress(OSError):
        if command and _is_for_linux(command.source):
            words = (*words, *LINUX)
    # If the compiler fails here, it will report the same error for the source file.
    with contextlib.suppress(OSError, ValueError):
        if command and Reader(command.folders, Path(ros)).finds(command.source):
            made = Store(Path(store), Path(ros)).find(compiler, command)
    if made:
        done = _run([compiler, *words, "-include-pch", str(made)])
        if not done.returncode and not done.stdout:
            return 0
    again = _run([compiler, *words])
    said = again.stdout
    for header, unknown in ((STANDARD, UNKNOWN), (UPSTREAM, UNKNOWN_TO_ROS)):
        if again.returncode and unknown.search(said):
            complete = _run([compiler, *words, "-include", str(header)])
            again = again if complete.returncode else complete
    if again.returncode and NOT_FOUND not in said and command and _asks_for_linux(command):
        linux = _run([compiler, *words, *LINUX])
        # A header that is absent is why the part for Linux does not compile.
        again = linux if not linux.returncode or NOT_FOUND in linux.stdout else again
    if again.returncode and OF_GCC.search(said):
        repaired = _run([sys.executable, "-I", "-S", str(REPAIRED), compiler, *words])
        again = again if repaired.returncode else repaired
    sys.stdout.buffer.write(again.stdout)
    if made and not again.returncode and not again.stdout:
        # The compiler's own headers were installed again, which makes precompiled headers invalid.
        made.with_suffix(".names").unlink(missing_ok=True)
    return again.returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
