"""Add third-party files that sitegen ships to the package: parts of ROS 2, browser libraries.

`sitegen/ros/` is unpacked from pinned PyPI wheels, `sitegen/runtime/vendor/` is bundled from pinned
npm packages, and `sitegen/bundles/` from the runtime and these. None of them is in the repository.
Finally, the Python of pages compiles the modules of ROS and those of sitegen that run in pages, and
what they need of its own library.
"""

from __future__ import annotations

import hashlib
import json
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Callable
from pathlib import Path, PurePosixPath
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

ROOT = Path(__file__).parent
PINS = ROOT / "ros.txt"
TARGET = ROOT / "sitegen" / "ros"
STAMP = TARGET / ".digest"
LOCK = ROOT / "package-lock.json"
BUNDLER = ROOT / "vendor.mjs"
LIBRARIES = ROOT / "sitegen" / "runtime" / "vendor"
COMPILER = ROOT / "bytecode.mjs"
# The library of Python in pages.
LIBRARY = LIBRARIES / "pyodide" / "python_stdlib.zip"

# The wheels are built for one platform, but the files taken from them are independent of it.
DOWNLOAD = [
    *["--no-deps", "--require-hashes", "--only-binary=:all:", "--platform=manylinux_2_28_x86_64"],
    *["--implementation=cp", "--python-version=3.11", "--abi=cp311"],
]

# The destination of a file in a wheel, by its path below `<wheel>.data/data/`. DDS type supports
# are skipped: sitegen generates its own from the type descriptions (*.json).
PURE = "lib/python3.11/site-packages/"
# What runs in the page: rclpy, all its imports, and the message classes.
PAGE = r"(rclpy|ament_index_python|yaml)/.+|typing_extensions|[a-z_]+/((msg|srv|action)/)?\w+"
TYPE_SUPPORT = re.compile(r"__(rosidl_)?type_?support")
PLACES = [
    (re.compile(r"include/[^/]+/(?P<path>.+\.hpp)$"), "include"),
    (re.compile(r"include/(rosidl_[^/]+|rcutils)/(?P<path>.+\.h)$"), "include"),
    (re.compile(r"share/(?P<path>[^/]+/(msg|srv|action)/[^/]+\.(json|msg|srv|action))$"), "share"),
    (re.compile(r"share/(?P<path>[^/]+/package\.xml)$"), "share"),
    (re.compile(r"share/(?P<path>rosidl_[^/]+/resource/.+)$"), "share"),
    (re.compile(rf"{PURE}(?P<path>(rosidl_[a-z_]+|rpyutils)/.+\.(py|em|lark))$"), "python"),
    (re.compile(rf"{PURE}(?P<path>({PAGE})\.py)$"), "page"),
    (re.compile(rf"{PURE}(?P<path>\w+-[\d.]+\.dist-info/licenses/LICENSE)$"), "page"),
]


class VendorBuildHook(BuildHookInterface[Any]):
    """Fills these folders before an sdist, a wheel or an editable install is made."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Fetch what has changed since the last build: the pins, or the rules in this file.

        An sdist contains all of it, so a wheel is built from it without Node.js and downloads.
        """
        refresh(STAMP, [PINS, Path(__file__)], self._take_ros)
        refresh(LIBRARIES / ".digest", [LOCK, BUNDLER], self._bundle)
        # Parts of sitegen that import only modules of Python itself.
        sys.path.insert(0, str(ROOT))
        self._bundle_runtime()
        self._compile()

    def _take_ros(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            wheels = download(Path(folder), self.app.abort)
            shutil.rmtree(TARGET, ignore_errors=True)
            for wheel in wheels:
                unpack(wheel, TARGET)

    def _bundle(self) -> None:
        self._install()
        shutil.rmtree(LIBRARIES, ignore_errors=True)
        self._node(["node", BUNDLER.name])

    def _install(self) -> None:
        if not shutil.which("npm"):
            self.app.abort("npm not found; the browser libraries need Node.js 20 (nodejs.org)")
        self._node(["npm", "ci", "--no-audit", "--no-fund"])

    def _bundle_runtime(self) -> None:
        from sitegen.errors import SiteError
        from sitegen.site import bundles

        if bundles.is_current():
            return
        if not (ROOT / "node_modules" / "esbuild").is_dir():
            self._install()
        try:
            bundles.make()
        except SiteError as error:
            self.app.abort(str(error))

    def _compile(self) -> None:
        from sitegen.nodes.python import bytecode

        modules = {place: text for place, text in bytecode.brought() if place.endswith(".py")}
        names = {bytecode.key(place, text): place for place, text in modules.items()}
        stamp = bytecode.STORE.with_suffix(".digest")
        state = "".join(sorted(names)).encode() + COMPILER.read_bytes() + LOCK.read_bytes()
        digest = hashlib.sha256(state).hexdigest()
        if LIBRARY.exists() and stamp.exists() and stamp.read_text() == digest:
            return
        with tempfile.TemporaryDirectory() as folder:
            sources = Path(folder) / "sources.zip"
            with zipfile.ZipFile(sources, "w") as archive:
                archive.writestr("places.json", json.dumps(names))
                for name, place in names.items():
                    archive.writestr(name, modules[place])
            self._node(["node", COMPILER.name, *map(str, (sources, bytecode.STORE, LIBRARY))])
        stamp.write_text(digest)

    def _node(self, command: list[str]) -> None:
        done = subprocess.run(command, cwd=ROOT, text=True, capture_output=True)
        if done.returncode:
            self.app.abort(f"{' '.join(command)} failed:\n{done.stdout}{done.stderr}")


def refresh(stamp: Path, sources: list[Path], make: Callable[[], None]) -> None:
    """Call `make` unless `stamp` says that it was called for the same `sources`."""
    digest = hashlib.sha256(b"".join(source.read_bytes() for source in sources)).hexdigest()
    if stamp.exists() and stamp.read_text() == digest:
        return
    make()
    stamp.write_text(digest)


def download(folder: Path, abort: Any) -> list[Path]:
    """Download the pinned wheels into `folder` with pip, which checks their hashes."""
    command = [sys.executable, "-m", "pip", "download", "--quiet", "--dest", str(folder)]
    done = subprocess.run(
        [*command, *DOWNLOAD, "--requirement", str(PINS)], text=True, capture_output=True
    )
    if done.returncode:
        abort(f"the ROS 2 wheels of {PINS.name} could not be downloaded:\n{done.stderr}")
    return sorted(folder.glob("*.whl"))


def unpack(wheel: Path, target: Path) -> None:
    """Copy the files in PLACES from `wheel` to `target`."""
    package = "_".join(wheel.name.split("-")[0].split("_")[1:])
    with zipfile.ZipFile(wheel) as archive:
        for name in archive.namelist():
            # Pure Python wheels have their modules at the top.
            inner = name.partition(".data/data/")[2] or f"{PURE}{name}"
            place = destination(inner, package)
            if place:
                file = target / place
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_bytes(archive.read(name))


def destination(name: str, package: str) -> PurePosixPath | None:
    """Return the destination of `name`, a path in the wheel of `package`; None to skip it."""
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
