"""Pack compiled nodes into an archive for other sites, and unpack untrusted archives.

`manifest.json` in an archive lists its nodes, whose names say which files they have, and the files
of packages that these open.
"""

from __future__ import annotations

import errno
import json
import re
import stat
import struct
import tempfile
import zipfile
import zlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from sitegen import __version__
from sitegen.model import Build

# Increased when compiled nodes need a different page: it covers host.h, the worker and the graph.
FORMAT = 2
# The one without files of packages, which is still written for nodes that open none.
WITHOUT_SHARE = 1
MANIFEST = "manifest.json"
ENGINES = ("jspi", "asyncify")
# The maximum sizes of an archive, packed and unpacked.
LARGEST, LARGEST_UNPACKED = 200_000_000, 800_000_000
# Those of a JSON file, which takes up to 30 times its size in memory, and of the list of files.
LARGEST_JSON, LARGEST_LIST = 4_000_000, 2_000_000
METHODS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
PIECE = 2**20
# What `zipfile` raises for data that is no archive, beside OSError for an impossible offset.
INVALID = (
    zipfile.BadZipFile,
    zlib.error,
    struct.error,
    EOFError,
    NotImplementedError,
    OverflowError,
    RuntimeError,
    ValueError,
)
MOST_NODES = 1000
PACKAGE = re.compile(r"[A-Za-z][\w-]{0,99}", re.ASCII)
EXECUTABLE = re.compile(r"\w[\w-]{0,99}(\.[\w-]{1,99})*", re.ASCII)
# A file in the share folder of a package: no part of its path leads elsewhere.
SHARED = re.compile(r"share(/(?!\.{1,2}(/|$))[^/\\]{1,200}){2,12}")
LONGEST_NAME = 255
EPOCH = (1980, 1, 1, 0, 0, 0)


class ArchiveError(Exception):
    """The archive is invalid; the message says why."""


@dataclass(frozen=True)
class Member:
    """A node of an archive, its unpacked builds, and the files of packages that it may open."""

    package: str
    executable: str
    builds: tuple[Build, ...]
    share: Mapping[str, Path]


def pack(
    builds: Mapping[tuple[str, str], Sequence[Build]], share: Mapping[str, Path], to: Path
) -> None:
    """Write an archive of nodes and of the files that they open, by their paths below the prefix.

    The same nodes and files always result in the same bytes.
    """
    nodes = [
        {"package": package, "executable": executable, "engines": [form.engine for form in forms]}
        for (package, executable), forms in sorted(builds.items())
    ]
    manifest = {"format": WITHOUT_SHARE, "sitegen": __version__, "nodes": nodes}
    if share:
        manifest |= {"format": FORMAT, "share": sorted(share)}
    to.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=to.parent, prefix=f".{to.name}-") as temporary:
        draft = Path(temporary) / to.name
        with zipfile.ZipFile(draft, "w", zipfile.ZIP_DEFLATED) as archive:
            _add(archive, MANIFEST, (json.dumps(manifest, indent=2) + "\n").encode())
            for (package, executable), forms in sorted(builds.items()):
                _add(archive, _types(package, executable), forms[0].types.read_bytes())
                for form in forms:
                    script, wasm = _names(package, executable, form.engine)
                    _add(archive, script, form.script.read_bytes())
                    _add(archive, wasm, form.wasm.read_bytes())
            for path, file in sorted(share.items()):
                _add(archive, path, file.read_bytes())
        draft.replace(to)


def unpack(archive: Path, to: Path) -> None:
    """Unpack an archive to the new folder `to`: exactly the files that its manifest implies.

    Raises: ArchiveError if the archive is invalid; then nothing is written.
    """
    if archive.stat().st_size > LARGEST:
        raise ArchiveError(f"it is larger than {LARGEST:,} bytes")
    to.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=to.parent) as temporary:
        fresh = Path(temporary) / "new"
        try:
            _check_list(archive)
            with zipfile.ZipFile(archive) as opened:
                _extract(opened, fresh)
        except INVALID:
            raise ArchiveError("it is not a valid zip archive") from None
        except OSError as error:
            if error.errno != errno.EINVAL:
                raise
            raise ArchiveError("it is not a valid zip archive") from None
        if not to.exists():
            fresh.rename(to)


def members(folder: Path) -> list[Member]:
    """Return the nodes of an archive that was unpacked to `folder`."""
    content = _manifest((folder / MANIFEST).read_bytes())
    share = {path: folder / path for path in content.share}
    return [
        Member(name, executable, tuple(_build(folder, name, executable, e) for e in engines), share)
        for name, executable, engines in content.nodes
    ]


def described(nodes: Iterable[Member]) -> str:
    """Return the names of nodes for a message."""
    return ", ".join(f"{node.package}/{node.executable}" for node in nodes)


def _build(folder: Path, package: str, executable: str, engine: str) -> Build:
    script, wasm = _names(package, executable, engine)
    return Build(engine, folder / script, folder / wasm, folder / _types(package, executable))


def _check_list(archive: Path) -> None:
    """Refuse a list of files that is too large, which `zipfile` reads whole when it opens one.

    Its size stands in the record at the end (APPNOTE.TXT of PKWARE, 4.3.16), or in another one for
    sizes of over 4 GB, which these archives do not need.
    """
    with archive.open("rb") as file:
        file.seek(-min(archive.stat().st_size, 2**16 + 100), 2)
        end = file.read()
    found = end.rfind(b"PK\5\6")
    if found < 0 or b"PK\6\7" in end[max(0, found - 20) : found]:
        raise zipfile.BadZipFile
    [size] = struct.unpack_from("<L", end, found + 12)
    if size > LARGEST_LIST:
        raise ArchiveError("it contains too many files")


def _extract(archive: zipfile.ZipFile, to: Path) -> None:
    entries = archive.infolist()
    names = [entry.filename for entry in entries]
    if MANIFEST not in names:
        raise ArchiveError(f"it has no {MANIFEST}; `sitegen compile` writes such archives")
    if len(set(names)) < len(names):
        raise ArchiveError("it contains two files with the same name")
    left = LARGEST_UNPACKED
    manifest = b"".join(_read(archive, MANIFEST, left))
    content = _manifest(manifest)
    nodes = content.nodes
    types = {_types(package, executable) for package, executable, _ in nodes}
    wanted = {MANIFEST, *types, *content.share}
    wanted |= {
        name for p, e, engines in nodes for engine in engines for name in _names(p, e, engine)
    }
    above = {folder for name in wanted for folder in _above(name)}
    if wanted & above:
        raise ArchiveError(f"its {MANIFEST} lists a file that is a folder: {min(wanted & above)!r}")
    folders = {f"{folder}/" for folder in above}
    for entry in entries:
        # The upper bits are the type of the file, if it was packed on Unix.
        kind = stat.S_IFMT(entry.external_attr >> 16)
        is_file = kind in (0, stat.S_IFREG) and entry.filename in wanted
        if not is_file and not (kind in (0, stat.S_IFDIR) and entry.filename in folders):
            raise ArchiveError(f"it contains the unexpected file {entry.filename!r:.120}")
        if entry.compress_type not in METHODS:
            raise ArchiveError(f"its '{entry.filename}' is not compressed with 'deflate'")
    missing = sorted(wanted - set(names))
    if missing:
        raise ArchiveError(f"'{missing[0]}' is missing")
    for name in sorted(wanted):
        file = to / name
        file.parent.mkdir(parents=True, exist_ok=True)
        with file.open("wb") as written:
            for data in _read(archive, name, left):
                written.write(data)
                left -= len(data)
        if name in types and not isinstance(_json(file.read_bytes(), name), dict):
            raise ArchiveError(f"its '{name}' does not contain a JSON object")


def _read(archive: zipfile.ZipFile, name: str, left: int) -> Iterator[bytes]:
    """Yield the contents of a file in pieces, and raise ArchiveError after `left` bytes."""
    is_json = name.endswith(".json") and not _is_shared(name)
    most = min(left, LARGEST_JSON) if is_json else left
    # The size in the header may be wrong.
    with archive.open(name) as file:
        while data := file.read(PIECE):
            most -= len(data)
            if most < 0 and is_json and left > LARGEST_JSON:
                raise ArchiveError(f"its '{name}' is larger than {LARGEST_JSON:,} bytes")
            if most < 0:
                raise ArchiveError(f"it is larger than {LARGEST_UNPACKED:,} bytes when unpacked")
            yield data


class Manifest(NamedTuple):
    """What a manifest lists: package, executable and engines of nodes, and files of packages."""

    nodes: list[tuple[str, str, Sequence[str]]]
    share: list[str]


def _manifest(manifest: bytes) -> Manifest:
    content = _json(manifest, MANIFEST)
    found = content.get("format") if isinstance(content, dict) else None
    if found not in (WITHOUT_SHARE, FORMAT):
        theirs = f"has format {found}" if isinstance(found, int) else "has no format"
        raise ArchiveError(
            f"its {MANIFEST} {theirs}, this version of sitegen reads formats up to {FORMAT}; "
            "compile it again"
        )
    nodes = content.get("nodes")
    if not isinstance(nodes, list) or not 0 < len(nodes) <= MOST_NODES:
        raise ArchiveError(f"its {MANIFEST} lists no nodes")
    read = [_node(node) for node in nodes]
    if len({node[:2] for node in read}) < len(read):
        raise ArchiveError(f"its {MANIFEST} lists a node twice")
    share = content.get("share", []) if found == FORMAT else []
    for path in share if isinstance(share, list) else [share]:
        if not _is_shared(path):
            raise ArchiveError(f"its {MANIFEST} lists an invalid file: {path!r:.80}")
    return Manifest(read, share)


def _node(node: Any) -> tuple[str, str, Sequence[str]]:
    given = node if isinstance(node, dict) else {}
    package, executable = str(given.get("package")), str(given.get("executable"))
    engines = given.get("engines")
    named = PACKAGE.fullmatch(package) and EXECUTABLE.fullmatch(executable)
    if not named or engines not in (["jspi"], list(ENGINES)):
        raise ArchiveError(f"its {MANIFEST} lists an invalid node: {node!r:.80}")
    return package, executable, engines


def _json(data: bytes, name: str) -> Any:
    try:
        return json.loads(data)
    except (ValueError, RecursionError):
        raise ArchiveError(f"its '{name}' is not valid JSON") from None


def _names(package: str, executable: str, engine: str) -> tuple[str, str]:
    stem = f"{package}/{executable}.{engine}"
    return f"{stem}.js", f"{stem}.wasm"


def _types(package: str, executable: str) -> str:
    return f"{package}/{executable}.types.json"


def _is_shared(path: object) -> bool:
    if not isinstance(path, str) or not path.isprintable() or not SHARED.fullmatch(path):
        return False
    return all(len(name.encode()) <= LONGEST_NAME for name in path.split("/"))


def _above(name: str) -> Iterator[str]:
    """Yield the folders that a file of an archive is in."""
    while name := name.rpartition("/")[0]:
        yield name


def _add(archive: zipfile.ZipFile, name: str, data: bytes) -> None:
    entry = zipfile.ZipInfo(name, EPOCH)
    entry.compress_type = zipfile.ZIP_DEFLATED
    entry.external_attr = (stat.S_IFREG | 0o644) << 16
    archive.writestr(entry, data)
