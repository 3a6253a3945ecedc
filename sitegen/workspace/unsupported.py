"""Find the libraries that a package needs and that are not available in browsers."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from sitegen.model import Package

HEADER_FOLDER = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([\w.+-]+)/', re.MULTILINE)
HEADER = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"\n]+)[>"]', re.MULTILINE)
# Libraries that are too large, or need hardware, a middleware or a screen, by header folder.
UNSUPPORTED = {
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


def unsupported_libraries(package: Package) -> dict[str, str]:
    """Return the first unsupported library of each executable, where it is known."""
    found: dict[str, str] = {}
    named = {file for files in package.sources.values() for file in files}
    sources = (file.relative_to(package.path).as_posix() for file in package.path.rglob("*.cpp"))
    others = [file for file in sources if file not in named and not file.startswith("test/")]
    for executable in package.executables or ():
        files = package.sources.get(executable, ())
        # The source files of a component are not known, so it is assumed to need all libraries.
        missing = [_missing(package.path, (file,)) for file in files or others]
        if missing and (all(missing) or (files and any(missing))):
            found[executable] = next(filter(None, missing))
    return found


def _missing(folder: Path, files: tuple[str, ...]) -> str:
    names = (name for text in _texts(folder, files) for name in HEADER_FOLDER.findall(text))
    return next((UNSUPPORTED[name] for name in names if name in UNSUPPORTED), "")


def _texts(folder: Path, files: tuple[str, ...]) -> Iterator[str]:
    """Yield the source files of a package, and its own headers that they include, as text."""
    waiting, seen = [folder / file for file in files], set[Path]()
    while waiting:
        file = waiting.pop()
        if file in seen or not file.is_file():
            continue
        seen.add(file)
        text = file.read_text(encoding="utf-8-sig", errors="replace")
        yield text
        near = (file.parent, folder / "include", folder / "src", folder)
        waiting += (folder / name for name in HEADER.findall(text) for folder in near)
