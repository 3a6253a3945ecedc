"""Read the object files of WebAssembly, and rename the functions and variables in them.

Their format: https://github.com/WebAssembly/tool-conventions, Linking.md.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace

# Names in C, but for those that belong to the compiler: among them are all names of C++.
NAME = re.compile(rb"(?!main$|_[_A-Z])[A-Za-z_]\w*$")
TYPES = {0x7F: "int", 0x7E: "long long", 0x7D: "float", 0x7C: "double"}

# Sections, and the part of the section "linking" that has the symbols.
LINKING, TYPE, IMPORT, FUNCTION = 0, 1, 2, 3
SYMBOL_TABLE = 8
# Kinds of symbols, and of imports.
FUNCTIONS, DATA, SECTIONS = 0, 1, 3
TABLES, MEMORIES = 1, 2
WEAK, LOCAL, HIDDEN, UNDEFINED, EXPLICIT_NAME = 1, 2, 4, 0x10, 0x40


@dataclass
class Reader:
    """Reads the binary format of WebAssembly."""

    data: bytes
    at: int = 0

    def number(self) -> int:
        """Read an unsigned number."""
        value = shift = 0
        while True:
            byte = self.data[self.at]
            self.at += 1
            value |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80:
                return value

    def counted(self) -> bytes:
        """Read a number of bytes, and these."""
        size = self.number()
        self.at += size
        return self.data[self.at - size : self.at]

    def parts(self) -> Iterator[tuple[int, bytes]]:
        """Yield the kind and the content of each section, or part of a section, that is left."""
        while self.at < len(self.data):
            yield self.number(), self.counted()


def encoded(value: int) -> bytes:
    """Return an unsigned number in the binary format."""
    out = b""
    while value > 0x7F:
        out += bytes([value & 0x7F | 0x80])
        value >>= 7
    return out + bytes([value])


def _counted(data: bytes) -> bytes:
    return encoded(len(data)) + data


@dataclass(frozen=True)
class Symbol:
    """A symbol of an object file. The linker knows it as `name`, which may stand elsewhere."""

    kind: int
    flags: int
    index: bytes
    name: bytes
    place: bytes

    @property
    def has_name(self) -> bool:
        """Whether the name stands in the symbol."""
        named = self.kind == DATA or not self.flags & UNDEFINED or self.flags & EXPLICIT_NAME
        return bool(named) and self.kind != SECTIONS

    @property
    def is_public(self) -> bool:
        """Whether this is a function or a variable that other files can use, and its only one."""
        hidden = self.flags & (WEAK | LOCAL | HIDDEN | UNDEFINED)
        return not hidden and self.kind in (FUNCTIONS, DATA)

    def encoded(self) -> bytes:
        """Return the symbol in the binary format."""
        name = _counted(self.name) if self.has_name else b""
        return encoded(self.kind) + encoded(self.flags) + self.index + name + self.place


class Object:
    """An object file of a library, whose symbols end with `label`."""

    def __init__(self, data: bytes, label: str) -> None:
        self.data = data
        self.label = label
        # The names of imported functions, and the declarations of all: "int %s(double)".
        self._imports: list[bytes] = []
        self._functions: list[str | None] = []
        self._symbols: list[Symbol] = []
        if data[:4] == b"\0asm":
            self._read()
        public = [symbol for symbol in self._symbols if symbol.is_public]
        #: The functions and variables that the file defines.
        self.names = {symbol.name for symbol in public}
        #: Those of C, with their declarations.
        self.declared = {
            symbol.name: declaration
            for symbol in public
            if NAME.match(symbol.name) and (declaration := self._declaration(symbol))
        }

    def renamed(self, names: Collection[bytes]) -> bytes:
        """Return the file with names of the library in place of `names`, which the library has."""
        symbols, more = [], []
        for symbol in self._symbols:
            own = replace(symbol, name=symbol.name + b"@" + self.label.encode())
            if symbol.is_public and symbol.name in names:
                symbols.append(own)
                more.append(replace(symbol, flags=symbol.flags | WEAK))
            elif symbol.flags & UNDEFINED and symbol.name in names:
                explicit = EXPLICIT_NAME if symbol.kind == FUNCTIONS else 0
                symbols.append(replace(own, flags=symbol.flags | explicit))
            else:
                symbols.append(symbol)
        table = encoded(len(symbols) + len(more))
        table += b"".join(each.encoded() for each in [*symbols, *more])
        out = self.data[:8]
        for kind, content in Reader(self.data, 8).parts():
            new = _with_table(content, table) if _is_linking(kind, content) else content
            out += encoded(kind) + _counted(new)
        return out

    def _declaration(self, symbol: Symbol) -> str | None:
        if symbol.kind == DATA:
            return "extern char %s"
        return self._functions[Reader(symbol.index).number()]

    def _read(self) -> None:
        types: list[str | None] = []
        for kind, content in Reader(self.data, 8).parts():
            if kind == TYPE:
                types = _types(content)
            elif kind == IMPORT:
                for name, number in _imports(content):
                    self._imports.append(name)
                    self._functions.append(types[number])
            elif kind == FUNCTION:
                read = Reader(content)
                self._functions += [types[read.number()] for _ in range(read.number())]
            elif _is_linking(kind, content):
                parts = dict(_linking(content).parts())
                self._symbols = [*self._read_symbols(Reader(parts.get(SYMBOL_TABLE, b"\0")))]

    def _read_symbols(self, read: Reader) -> Iterator[Symbol]:
        for _ in range(read.number()):
            kind, flags = read.number(), read.number()
            start = read.at
            if kind == DATA:
                name = read.counted()
                start = read.at
                if not flags & UNDEFINED:
                    read.number(), read.number(), read.number()  # segment, offset and size
                yield Symbol(kind, flags, b"", name, read.data[start : read.at])
                continue
            index = read.number()
            symbol = Symbol(kind, flags, read.data[start : read.at], b"", b"")
            if symbol.has_name:
                symbol = replace(symbol, name=read.counted())
            elif kind == FUNCTIONS:
                symbol = replace(symbol, name=self._imports[index])
            yield symbol


def _types(section: bytes) -> list[str | None]:
    """Return each type of a function in C, with %s for its name; None for vectors and the like."""
    read = Reader(section)
    found: list[str | None] = []
    for _ in range(read.number()):
        read.number()
        takes, gives = read.counted(), read.counted()
        known = {*takes, *gives} <= {*TYPES} and len(gives) < 2
        result = TYPES.get(gives[0]) if known and gives else "void"
        found.append(f"{result} %s({', '.join(TYPES[one] for one in takes)})" if known else None)
    return found


def _imports(section: bytes) -> Iterator[tuple[bytes, int]]:
    """Yield the name and the number of the type of each imported function."""
    read = Reader(section)
    for _ in range(read.number()):
        read.counted()
        name, kind = read.counted(), read.number()
        if kind == FUNCTIONS:
            yield name, read.number()
            continue
        if kind != MEMORIES:
            read.number()  # the type of a table or of a variable; 0 for a tag
        limits = read.number()  # of a tag, its type; of a variable, whether it changes
        if kind in (TABLES, MEMORIES):
            read.number()
            if limits & 1:
                read.number()


def _is_linking(kind: int, content: bytes) -> bool:
    return kind == LINKING and content.startswith(b"\7linking")


def _linking(content: bytes) -> Reader:
    """Return a reader of the parts of the section, after its name and version."""
    read = Reader(content, len(b"\7linking"))
    read.number()
    return read


def _with_table(section: bytes, table: bytes) -> bytes:
    read = _linking(section)
    out = section[: read.at]
    for kind, content in read.parts():
        out += encoded(kind) + _counted(table if kind == SYMBOL_TABLE else content)
    return out


def members(archive: bytes) -> Iterator[bytes]:
    """Yield the files in an archive, without its own ones: those for names and symbols."""
    at = len(b"!<arch>\n")
    while at < len(archive):
        name, size = archive[at : at + 16], int(archive[at + 48 : at + 58])
        at += 60
        if not re.match(rb"/ |//|/SYM64/", name):
            yield archive[at : at + size]
        at += size + size % 2
