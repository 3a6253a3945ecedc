"""Turn the sources of a package into what its executables need and no page has."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from sitegen.model import Package

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([\w.+-]+)/', re.MULTILINE)
OWN = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"\n]+)[>"]', re.MULTILINE)
# What is large, or of hardware, a middleware or a screen, by the folders of headers.
LACKING = {
    "opencv2": "OpenCV",
    "pcl": "PCL",
    **{
        name: name
        for name in (
            *("cv_bridge", "image_transport", "pcl_conversions", "rmw_fastrtps_cpp", "rosbag2_cpp"),
            *("rosbag2_storage", "rosbag2_transport", "rttest", "rviz_common", "tlsf_cpp"),
        )
    },
}


def lacking(package: Package) -> dict[str, str]:
    """Return what is missing for executables of `package`, by their names, as far as is known."""
    found: dict[str, str] = {}
    named = {file for files in package.sources.values() for file in files}
    sources = (file.relative_to(package.path).as_posix() for file in package.path.rglob("*.cpp"))
    others = [file for file in sources if file not in named and not file.startswith("test/")]
    for executable in package.executables or ():
        files = package.sources.get(executable, ())
        # Which files a component is of is not known: it needs what all of them do.
        missing = [_missing(package.path, (file,)) for file in files or others]
        if missing and (all(missing) or (files and any(missing))):
            found[executable] = next(filter(None, missing))
    return found


def _missing(folder: Path, files: tuple[str, ...]) -> str:
    names = (name for text in _texts(folder, files) for name in INCLUDE.findall(text))
    return next((LACKING[name] for name in names if name in LACKING), "")


def _texts(folder: Path, files: tuple[str, ...]) -> Iterator[str]:
    """Yield the texts of source files of a package, and of its own headers that these include."""
    waiting, seen = [folder / file for file in files], set[Path]()
    while waiting:
        file = waiting.pop()
        if file in seen or not file.is_file():
            continue
        seen.add(file)
        text = file.read_text(encoding="utf-8", errors="replace")
        yield text
        near = (file.parent, folder / "include", folder / "src", folder)
        waiting += (folder / name for name in OWN.findall(text) for folder in near)
