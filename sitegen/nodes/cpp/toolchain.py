"""Find Emscripten, CMake and Ninja, and run them."""

from __future__ import annotations

import contextlib
import os
import shutil
import subprocess
import sysconfig
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path

# Debian's Emscripten calls acorn, which its Node finds only here.
DEBIAN_NODE_PATH = Path("/usr/share/nodejs")
# Where Debian, those who compile it, and Homebrew have Eigen.
EIGEN = [Path(root, "share/eigen3/cmake") for root in ("/usr", "/usr/local", "/opt/homebrew")]


class ToolMissingError(Exception):
    """A tool is not installed: the message names it and says how to get it."""


@dataclass(frozen=True)
class Toolchain:
    """The tools that compile C++ for the page, and what identifies the compiler.

    `eigen` is the folder with CMake's package of Eigen, if its headers are installed.
    """

    compiler: Path
    cmake: Path
    ninja: Path
    identity: str
    eigen: Path | None = None

    @staticmethod
    def find() -> Toolchain:
        """Look for the tools on the PATH and beside the running Python."""
        compiler = _find("em++", "apt-get install emscripten, or see emscripten.org")
        cmake = _find("cmake", "pip install cmake")
        ninja = _find("ninja", "pip install ninja")
        eigen = _eigen()
        # Another Eigen makes other programs.
        identity = _identity(compiler) + (f" {eigen.stat().st_mtime_ns}" if eigen else "")
        return Toolchain(compiler, cmake, ninja, identity, eigen)

    def run(self, *command: str | Path, flags: str = "") -> subprocess.CompletedProcess[str]:
        """Run a tool, em++ below it with `flags`; its output, errors included, is in `stdout`."""
        paths = [os.environ.get("NODE_PATH", ""), str(DEBIAN_NODE_PATH)]
        env = os.environ | {"NODE_PATH": os.pathsep.join(path for path in paths if path)}
        if flags:
            env["EMCC_CFLAGS"] = f"{env.get('EMCC_CFLAGS', '')} {flags}"
        return subprocess.run(
            [str(word) for word in command],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            env=env,
        )

    @property
    def platform_file(self) -> Path:
        """Emscripten's CMake toolchain file."""
        return home(self.compiler) / "cmake" / "Modules" / "Platform" / "Emscripten.cmake"


def home(compiler: Path) -> Path:
    """Return Emscripten's folder: `em++` on the PATH is in it or links to it."""
    return compiler.resolve().parent


def _find(name: str, how: str) -> Path:
    # A virtual environment that is not activated has its scripts off the PATH.
    found = shutil.which(name) or shutil.which(name, path=sysconfig.get_path("scripts"))
    if not found:
        raise ToolMissingError(f"{name} not found ({how})")
    return Path(found)


def _eigen() -> Path | None:
    """Return where CMake's package of Eigen is: from PyPI, or where systems have it."""
    folders = [*EIGEN]
    with contextlib.suppress(metadata.PackageNotFoundError):
        place = metadata.distribution("cmeel-eigen").locate_file("cmeel.prefix/share/eigen3/cmake")
        folders.insert(0, Path(str(place)))
    return next((folder for folder in folders if (folder / "Eigen3Config.cmake").is_file()), None)


def _identity(compiler: Path) -> str:
    """Tell one compiler from another without the fifth of a second that asking it takes."""
    version = home(compiler) / "emscripten-version.txt"
    text = version.read_text().strip() if version.exists() else ""
    return f"{text} {compiler.stat().st_mtime_ns}"
