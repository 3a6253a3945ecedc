"""Find the bags that pages play; those that pages cannot read are converted to MCAP."""

from __future__ import annotations

import hashlib
import importlib.util
import re
import shutil
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from sitegen.cache.folder import cache_folder
from sitegen.errors import Problems
from sitegen.model import Artifact, Page, Site, Widget

KIND = "bag"
METADATA = "metadata.yaml"
FOLDER = "bags"
# In the cache; changes when conversion does.
VERSION = "1"


@dataclass(frozen=True)
class Bags:
    """The bags of a page: their paths in `dist/` by the path that the author wrote."""

    paths: Mapping[str, str]
    artifacts: Sequence[Artifact]


def bags(site: Site, page: Page) -> Bags:
    """Return the bags that the widgets of a page play.

    Raises: SiteError if one has to be converted and that fails.
    """
    widgets = [part for part in page.leaves if isinstance(part, Widget) and part.kind == KIND]
    paths: dict[str, str] = {}
    artifacts = []
    problems = Problems(site.root)
    for widget in widgets:
        name = str(widget.options.get("file") or "")
        if not name or name in paths:
            continue
        try:
            file = _readable(site.root / name)
        except ValueError as error:
            problems.add(widget.location, "bag.file", f"'{name}' {error}")
            continue
        digest = _digest(file)[:10]
        stem = re.sub(r"[^\w.-]+", "-", Path(name).name.removesuffix(".mcap"))
        paths[name] = f"{FOLDER}/{stem}.{digest}.mcap"
        artifacts.append(Artifact(paths[name], file))
    problems.raise_if_any()
    return Bags(paths, artifacts)


def _readable(path: Path) -> Path:
    """Return a bag as one MCAP file: itself, or what it was converted to.

    Raises: ValueError that says why it cannot be converted.
    """
    if path.is_file() and path.suffix == ".mcap":
        return path
    if path.is_dir():
        inside = sorted(path.glob("*.mcap"))
        if len(inside) == 1 and not any(path.glob("*.db3")):
            return inside[0]
    return _converted(path)


def _converted(path: Path) -> Path:
    files = sorted(path.iterdir()) if path.is_dir() else [path]
    names = "".join(f"{file.name} {_digest(file)}\n" for file in files if file.is_file())
    key = hashlib.sha256(f"{VERSION}\n{names}".encode()).hexdigest()[:32]
    kept = cache_folder() / "bags" / f"{key}.mcap"
    if kept.is_file():
        return kept
    if not importlib.util.find_spec("rosbags"):
        raise ValueError("is not a single .mcap file; to convert it, install 'ros-sitegen[bags]'")
    kept.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=kept.parent) as temporary:
        target = Path(temporary) / "bag"
        _convert(path, target)
        [made] = target.glob("*.mcap")
        shutil.move(made, kept)
    return kept


def _convert(path: Path, target: Path) -> None:
    """Write the messages of a bag to the folder `target`, as they are, in the order of time.

    Raises: ValueError if the bag cannot be read.
    """
    # Only sites with such bags need them.
    from rosbags.highlevel import AnyReader
    from rosbags.rosbag2 import StoragePlugin, Writer
    from rosbags.typesys import Stores, get_typestore

    try:
        with (
            AnyReader([path], default_typestore=get_typestore(Stores.LATEST)) as reader,
            Writer(target, version=9, storage_plugin=StoragePlugin.MCAP) as writer,
        ):
            made = {}
            for one in reader.connections:
                made[one.id] = writer.add_connection(
                    one.topic,
                    one.msgtype,
                    typestore=reader.typestore,
                    serialization_format="cdr",
                    offered_qos_profiles=getattr(one.ext, "offered_qos_profiles", ()),
                )
            for one, time, data in reader.messages():
                writer.write(made[one.id], time, data)
    except Exception as error:  # of sqlite, of YAML, and of its own
        [reason, *_] = str(error).replace(f"{path}/", "").splitlines() or [type(error).__name__]
        raise ValueError(f"cannot be converted: {reason}") from error


def _digest(file: Path) -> str:
    with file.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()
