"""The modules and functions that a setup.py may use, for one package."""

from __future__ import annotations

import collections
import fnmatch
import glob
import io
import itertools
import os
import posixpath
import re
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path, PurePosixPath
from typing import Any

from sitegen.workspace.manifest import ENVIRONMENT
from sitegen.workspace.setupvalues import LARGEST

WILDCARD = re.compile(r"[*?\[]")
SETUP = object()
# Texts that a setup.py reads: versions and lists of names.
LONGEST_FILE = 1_000_000


class Files:
    """What the file system answers below `limit`; relative paths begin at the package `folder`."""

    def __init__(self, folder: Path, limit: Path) -> None:
        self.folder = folder.resolve()
        self._limit = limit.resolve()

    def real(self, path: Any) -> Path:
        """Return where `path` leads.

        Raises: ValueError if that is outside of the limit.
        """
        found = (self.folder / str(path)).resolve()
        if not found.is_relative_to(self._limit):
            raise ValueError
        return found

    def glob(self, pattern: Any, *, recursive: bool = False, root_dir: Any = "") -> list[str]:
        """Return the paths that match `pattern`, ordered."""
        text = str(pattern)
        fixed, wild, rest = text, "", ""
        if found := WILDCARD.search(text):
            fixed, wild, rest = text[: found.start()], found[0], text[found.start() :]
        top = self.real(root_dir or ".")
        self.real(top / posixpath.dirname(fixed))
        if wild and ".." in rest.split("/"):
            raise ValueError
        # Path.glob() has other rules: for hidden files, and for absolute patterns.
        return sorted(glob.glob(text, recursive=recursive, root_dir=top))  # noqa: PTH207

    def walk(
        self, path: Any, topdown: bool = True, onerror: None = None, followlinks: bool = False
    ) -> list[tuple[str, list[str], list[str]]]:
        """Return what os.walk() yields, ordered."""
        self.real(path)
        found: list[tuple[str, list[str], list[str]]] = []
        for at, folders, files in os.walk(self.folder / str(path), followlinks=followlinks):
            folders.sort()
            if len(found) > LARGEST or Path(at).resolve() in Path(at).resolve().parents:
                raise ValueError
            shown = posixpath.relpath(at, self.folder / str(path))
            place = str(path) if shown == "." else posixpath.join(str(path), shown)
            found.append((place, list(folders), sorted(files)))
        return found if topdown else found[::-1]

    def packages(
        self,
        where: Any = ".",
        exclude: Sequence[str] = (),
        include: Sequence[str] = ("*",),
        *,
        namespaces: bool = False,
    ) -> list[str]:
        """Return what find_packages() of setuptools finds."""
        top = self.real(where)
        found: list[str] = []
        waiting = [top]
        while waiting:
            folder = waiting.pop()
            for inside in sorted(folder.iterdir(), reverse=True):
                name = ".".join(inside.relative_to(top).parts)
                if not inside.is_dir() or "." in inside.name or inside.resolve() in inside.parents:
                    continue
                if not namespaces and not (inside / "__init__.py").is_file():
                    continue
                wanted = any(fnmatch.fnmatchcase(name, each) for each in include)
                if wanted and not any(fnmatch.fnmatchcase(name, each) for each in exclude):
                    found.append(name)
                if f"{name}*" not in exclude and f"{name}.*" not in exclude:
                    waiting.append(inside)
        return sorted(found)

    def open(self, path: Any, mode: str = "r", *_: Any, **__: Any) -> io.StringIO:
        """Return the text of a file that is opened for reading."""
        file = self.real(path)
        if mode not in ("r", "rt") or file.stat().st_size > LONGEST_FILE:
            raise ValueError
        return io.StringIO(file.read_text(encoding="utf-8-sig"))

    def stay(self, path: Any) -> None:
        """Change the directory to that of the package, where it is already."""
        if self.real(path) != self.folder:
            raise ValueError

    def names(self, path: Any = ".") -> list[str]:
        """Return what os.listdir() does, ordered."""
        return sorted(each.name for each in self.real(path).iterdir())

    def path_method(self, path: PurePosixPath, name: str) -> Callable[..., Any]:
        """Return a method of a pathlib.Path.

        Raises: TypeError if there is none.
        """
        known: dict[str, Callable[..., Any]] = {
            "glob": lambda pattern: self._paths(path, str(pattern)),
            "rglob": lambda pattern: self._paths(path, f"**/{pattern}"),
            "iterdir": lambda: [path / each for each in self.names(path)],
            "exists": lambda: self.real(path).exists(),
            "is_file": lambda: self.real(path).is_file(),
            "is_dir": lambda: self.real(path).is_dir(),
            "resolve": lambda *_: PurePosixPath(self.real(path)),
            "absolute": lambda: PurePosixPath(self.folder / path),
            "read_text": lambda *_, **__: self.open(path).read(),
            **{
                each: getattr(path, each)
                for each in ("as_posix", "joinpath", "relative_to", "with_suffix", "with_name")
            },
        }
        if name not in known:
            raise TypeError
        return known[name]

    def _paths(self, path: PurePosixPath, pattern: str) -> list[PurePosixPath]:
        found = self.glob(pattern, recursive=True, root_dir=path)
        return [path / each for each in found if each]


def _chain(*parts: Iterable[Any]) -> list[Any]:
    return list(itertools.chain(*parts))


def _range(*numbers: int) -> range:
    if len(range(*numbers)) > LARGEST:
        raise ValueError
    return range(*numbers)


def _text(value: Any = "") -> str:
    if isinstance(value, list | tuple | dict | set):
        raise TypeError
    return str(value)


def _listed(function: Callable[..., Iterable[Any]]) -> Callable[..., list[Any]]:
    """Return a function with a list instead of an iterator, which is used up after one use."""

    def call(*arguments: Any, **named: Any) -> list[Any]:
        return list(itertools.islice(function(*arguments, **named), LARGEST))

    return call


def builtins(files: Files) -> dict[str, Any]:
    """Return the names that are there without an import."""
    same = (bool, int, float, list, tuple, set, dict, len, sorted, sum, min, max, any, all, abs)
    return {
        **{function.__name__: function for function in (*same, isinstance, round)},
        **{each.__name__: _listed(each) for each in (map, filter, zip, enumerate, reversed)},
        "str": _text,
        "range": _range,
        "print": lambda *_, **__: None,
        "open": files.open,
        "setup": SETUP,
        "__name__": "__main__",
        "__file__": str(files.folder / "setup.py"),
    }


def modules(files: Files) -> dict[str, Any]:
    """Return what imports bring, by full name."""
    pure = ("join", "basename", "dirname", "splitext", "split", "normpath", "isabs", "commonpath")
    paths = {f"os.path.{name}": getattr(posixpath, name) for name in pure}
    return {
        **paths,
        "os.path.abspath": lambda path: posixpath.normpath(posixpath.join(files.folder, path)),
        "os.path.realpath": lambda path: str(files.real(path)),
        "os.path.relpath": lambda path, start=".": posixpath.relpath(
            posixpath.join(files.folder, path), posixpath.join(files.folder, start)
        ),
        "os.path.exists": lambda path: files.real(path).exists(),
        "os.path.isfile": lambda path: files.real(path).is_file(),
        "os.path.isdir": lambda path: files.real(path).is_dir(),
        "os.path.sep": "/",
        "os.sep": "/",
        "os.curdir": ".",
        "os.name": "posix",
        "os.fspath": str,
        "os.listdir": files.names,
        "os.walk": files.walk,
        "os.getcwd": lambda: str(files.folder),
        "os.chdir": files.stay,
        "os.environ": dict(ENVIRONMENT),
        "os.getenv": dict(ENVIRONMENT).get,
        "glob.glob": files.glob,
        "glob.iglob": files.glob,
        "fnmatch.fnmatch": fnmatch.fnmatch,
        "fnmatch.filter": fnmatch.filter,
        "itertools.chain": _chain,
        "itertools.chain.from_iterable": lambda parts: _chain(*parts),
        "collections.defaultdict": collections.defaultdict,
        "collections.OrderedDict": dict,
        "io.open": files.open,
        "codecs.open": files.open,
        "pathlib.Path": PurePosixPath,
        "pathlib.PurePath": PurePosixPath,
        "pathlib.Path.cwd": lambda: PurePosixPath(files.folder),
        "sys.platform": "linux",
        "sys.argv": ["setup.py", "install"],
        "sys.version_info": (3, 14, 0, "final", 0),
        "typing.List": list,
        "setuptools.setup": SETUP,
        "setuptools.find_packages": files.packages,
        "setuptools.find_namespace_packages": _namespaces(files),
        "distutils.core.setup": SETUP,
    }


def _namespaces(files: Files) -> Callable[..., list[str]]:
    def find(*arguments: Any, **named: Any) -> list[str]:
        return files.packages(*arguments, **named, namespaces=True)

    return find
