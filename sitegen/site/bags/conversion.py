"""Convert bags of other formats to MCAP, the format that pages play."""

from __future__ import annotations

import functools
import hashlib
import importlib.util
import io
import shutil
import tempfile
from collections.abc import Sequence
from contextlib import redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from sitegen.cache.folder import cache_folder

if TYPE_CHECKING:
    from rosbags.typesys.store import Typestore

ROS1 = ".bag"
# In the cache; changes when conversion does.
VERSION = "2"
# Its field `seq` is gone in ROS 2, and nobody misses it.
HEADER = "std_msgs/msg/Header"


@dataclass(frozen=True)
class Conversion:
    """A bag of another format, and what it becomes: a file in the cache."""

    source: Path
    target: Path

    @property
    def note(self) -> str:
        """What the author should know of the result, or nothing."""
        file = self.target.with_suffix(".txt")
        return file.read_text() if file.exists() else ""

    @property
    def is_done(self) -> bool:
        """Whether an earlier build has done it."""
        return self.target.is_file()

    def run(self) -> None:
        """Write the target.

        Raises: ValueError that says why the bag cannot be converted.
        """
        if not importlib.util.find_spec("rosbags"):
            message = "is not a single .mcap file; to convert it, install 'ros-sitegen[bags]'"
            raise ValueError(message)
        self.target.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=self.target.parent) as temporary:
            folder = Path(temporary) / "bag"
            note = _convert(self.source, folder)
            if note:
                self.target.with_suffix(".txt").write_text(note)
            [made] = folder.glob("*.mcap")
            shutil.move(made, self.target)


def conversion(path: Path) -> Conversion | None:
    """Return how a bag, a file or a folder, becomes MCAP; None if pages can read it as it is."""
    if readable(path) is not None:
        return None
    files = sorted(path.iterdir()) if path.is_dir() else [path]
    names = "".join(f"{file.name} {digest(file)}\n" for file in files if file.is_file())
    key = hashlib.sha256(f"{VERSION}\n{names}".encode()).hexdigest()[:32]
    return Conversion(path, cache_folder() / "bags" / f"{key}.mcap")


def readable(path: Path) -> Path | None:
    """Return the file of a bag that pages can read as it is, if it is one."""
    if path.is_file():
        return path if path.suffix == ".mcap" else None
    inside = sorted(path.glob("*.mcap"))
    return inside[0] if len(inside) == 1 and not any(path.glob("*.db3")) else None


def digest(file: Path) -> str:
    """Return the digest of a file that may be large; it is read again only after a change."""
    found = file.stat()
    return _digest(file, found.st_mtime_ns, found.st_size)


@functools.lru_cache(maxsize=256)
def _digest(file: Path, time: int, size: int) -> str:
    """Return the digest of a file, cached by its modification time and size."""
    with file.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def _convert(path: Path, folder: Path) -> str:
    """Write the messages of a bag to `folder`, in the order of time, and return a note.

    Raises: ValueError if the bag cannot be read.
    """
    # Only sites with such bags need them.
    from rosbags.convert import convert
    from rosbags.typesys import Stores, get_typestore

    known = get_typestore(Stores.LATEST)
    try:
        note = _add_types(path, known) if path.suffix == ROS1 else ""
        # It prints the types that it adapts.
        with redirect_stdout(io.StringIO()):
            convert(
                srcs=[path],
                dst=folder,
                dst_storage="mcap",
                dst_version=9,
                compress="zstd",
                compress_mode="storage",
                default_typestore=known,
                typestore=known if path.suffix == ROS1 else None,
                exclude_topics=(),
                include_topics=(),
                exclude_msgtypes=(),
                include_msgtypes=(),
            )
    except Exception as error:  # of sqlite, of YAML, and of its own
        cause = error.__cause__ or error
        text = str(cause).replace(f"{path}/", "").replace(str(path), path.name)
        [reason, *_] = text.splitlines() or [type(cause).__name__]
        raise ValueError(f"cannot be converted: {reason}") from error
    return note


def _add_types(path: Path, known: Typestore) -> str:
    """Add the types of a ROS 1 bag that ROS 2 has not, and return which of the others differ."""
    from rosbags.highlevel import AnyReader

    with AnyReader([path]) as reader:
        own = reader.typestore.fielddefs
    different = [
        name.replace("/msg/", "/")
        for name, (_, fields) in own.items()
        if name in known.fielddefs
        and name != HEADER
        and _plain(fields) != _plain(known.fielddefs[name][1])
    ]
    known.register({name: one for name, one in own.items() if name not in known.fielddefs})
    if not different:
        return ""
    names = ", ".join(sorted(different))
    return f"these types have other fields in ROS 2, and only what both have is kept: {names}"


def _plain(fields: Sequence[tuple[str, object]]) -> list[tuple[str, object]]:
    """Return fields with names as ROS 2 writes them: `D` of ROS 1 is `d`."""
    return [(name.lower(), kind) for name, kind in fields]
