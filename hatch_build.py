"""Copy the parts of ROS 2 that sitegen needs from pinned PyPI wheels into `sitegen/ros/`."""

from __future__ import annotations

import hashlib
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path, PurePosixPath
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

ROOT = Path(__file__).parent
PINS = ROOT / "ros.txt"
TARGET = ROOT / "sitegen" / "ros"
STAMP = TARGET / ".digest"

# The wheels are built for one platform, but what is taken from them is text that suits all.
DOWNLOAD = [
    *["--no-deps", "--require-hashes", "--only-binary=:all:", "--platform=manylinux_2_28_x86_64"],
    *["--implementation=cp", "--python-version=3.11", "--abi=cp311"],
]

# Where a file of a wheel goes, by its path below `<wheel>.data/data/`. Type supports of DDS stay
# behind: sitegen generates its own from the type descriptions (*.json).
PURE = "lib/python3.11/site-packages/"
TYPE_SUPPORT = re.compile(r"__(rosidl_)?type_?support")
PLACES = [
    (re.compile(r"include/[^/]+/(?P<path>.+\.hpp)$"), "include"),
    (re.compile(r"include/(rosidl_[^/]+|rcutils)/(?P<path>.+\.h)$"), "include"),
    (re.compile(r"share/(?P<path>[^/]+/(msg|srv|action)/[^/]+\.(json|msg|srv|action))$"), "share"),
    (re.compile(r"share/(?P<path>[^/]+/package\.xml)$"), "share"),
    (re.compile(r"share/(?P<path>rosidl_[^/]+/resource/.+)$"), "share"),
    (re.compile(rf"{PURE}(?P<path>rosidl_[a-z_]+/.+\.(py|em|lark))$"), "python"),
]


class RosBuildHook(BuildHookInterface[Any]):
    """Fill `sitegen/ros/` before a wheel or an editable install is made."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Fetch and unpack, unless what is there came from the same pins and the same rules."""
        if self.target_name == "sdist":
            return
        digest = hashlib.sha256(PINS.read_bytes() + Path(__file__).read_bytes()).hexdigest()
        if STAMP.exists() and STAMP.read_text() == digest:
            return
        with tempfile.TemporaryDirectory() as folder:
            wheels = download(Path(folder), self.app.abort)
            shutil.rmtree(TARGET, ignore_errors=True)
            for wheel in wheels:
                unpack(wheel, TARGET)
        STAMP.write_text(digest)


def download(folder: Path, abort: Any) -> list[Path]:
    """Let pip download the pinned wheels into `folder` and check their hashes."""
    command = [sys.executable, "-m", "pip", "download", "--quiet", "--dest", str(folder)]
    done = subprocess.run(
        [*command, *DOWNLOAD, "--requirement", str(PINS)], text=True, capture_output=True
    )
    if done.returncode:
        abort(f"the ROS 2 wheels of {PINS.name} could not be downloaded:\n{done.stderr}")
    return sorted(folder.glob("*.whl"))


def unpack(wheel: Path, target: Path) -> None:
    """Copy what PLACES names from `wheel` to `target`."""
    package = "_".join(wheel.name.split("-")[0].split("_")[1:])
    with zipfile.ZipFile(wheel) as archive:
        for name in archive.namelist():
            # Wheels of pure Python have their modules at the top.
            inner = name.partition(".data/data/")[2] or f"{PURE}{name}"
            place = destination(inner, package)
            if place:
                file = target / place
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_bytes(archive.read(name))


def destination(name: str, package: str) -> PurePosixPath | None:
    """Return where `name`, a path in the wheel of `package`, goes; None if it is left behind."""
    for pattern, place in PLACES:
        match = pattern.match(name)
        if not match or ".." in name:
            continue
        path = match["path"]
        if place == "include":
            if TYPE_SUPPORT.search(path) and not path.startswith("rosidl_"):
                return None
            return PurePosixPath(place, package, path)
        return PurePosixPath(place, path)
    return None
