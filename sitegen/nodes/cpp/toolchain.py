"""Find Emscripten, CMake and Ninja, and run them."""

from __future__ import annotations

import os
import shutil
import subprocess
import sysconfig
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from sitegen.cache.digest import digest_of
from sitegen.nodes.cpp import libraries

# Emscripten of Debian uses acorn, which its Node finds only in this folder.
DEBIAN_NODE_PATH = Path("/usr/share/nodejs")
# The interval at which a tool that runs is watched (s).
TICK = 1


class ToolMissingError(Exception):
    """A tool is not installed; the message says how to install it."""


@dataclass(frozen=True)
class Toolchain:
    """The tools that compile C++ for the page, and the identity of the compiler.

    `eigen` is the folder with the CMake package of Eigen, if its headers are installed. `watch` is
    called every second with what the tool that runs has printed so far.
    """

    compiler: Path
    cmake: Path
    ninja: Path
    identity: str
    eigen: Path | None = None
    watch: Callable[[str], None] | None = None

    @staticmethod
    def find() -> Toolchain:
        """Find the tools on the PATH and beside the running Python."""
        compiler = _find("em++", "apt-get install emscripten, or see emscripten.org")
        cmake = _find("cmake", "pip install cmake")
        ninja = _find("ninja", "pip install ninja")
        eigen = libraries.find_eigen()
        # Programs depend on the versions of headers, not on when these were installed.
        identity = f"{_identity(compiler)} {libraries.identity()}"
        identity += f" {digest_of([eigen])}" if eigen else ""
        return Toolchain(compiler, cmake, ninja, identity, eigen)

    def run(
        self, *command: str | Path, flags: str = "", variables: Mapping[str, str] | None = None
    ) -> subprocess.CompletedProcess[str]:
        """Run a tool, em++ below it with `flags`; `stdout` has its output, errors included.

        `variables` are set in its environment.
        """
        paths = [os.environ.get("NODE_PATH", ""), str(DEBIAN_NODE_PATH)]
        env = os.environ | {"NODE_PATH": os.pathsep.join(path for path in paths if path)}
        env |= variables or {}
        if flags:
            env["EMCC_CFLAGS"] = f"{env.get('EMCC_CFLAGS', '')} {flags}"
        words = [str(word) for word in command]
        with subprocess.Popen(
            words,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            env=env,
        ) as process:
            output = self._output(process)
        return subprocess.CompletedProcess(words, process.returncode, output)

    def _output(self, process: subprocess.Popen[str]) -> str:
        """Return the output of a tool when it ends."""
        while True:
            try:
                return process.communicate(timeout=TICK if self.watch else None)[0]
            except subprocess.TimeoutExpired as so_far:
                if self.watch:
                    # These are bytes, whatever the output is; on Windows, there are none.
                    self.watch((so_far.output or b"").decode(errors="replace"))
            except BaseException:  # an interrupt ends the tool, too
                process.kill()
                raise

    @property
    def platform_file(self) -> Path:
        """The CMake toolchain file of Emscripten."""
        return home(self.compiler) / "cmake" / "Modules" / "Platform" / "Emscripten.cmake"


def home(compiler: Path) -> Path:
    """Return the folder of Emscripten: `em++` on the PATH is in it or links to it."""
    return compiler.resolve().parent


def _find(name: str, how: str) -> Path:
    # The scripts of a virtual environment that is not activated are not on the PATH.
    found = shutil.which(name) or shutil.which(name, path=sysconfig.get_path("scripts"))
    if not found:
        raise ToolMissingError(f"{name} not found ({how})")
    return Path(found)


def _identity(compiler: Path) -> str:
    """Return a value that identifies the compiler; asking it would take a fifth of a second."""
    version = home(compiler) / "emscripten-version.txt"
    text = version.read_text().strip() if version.exists() else ""
    return f"{text} {compiler.stat().st_mtime_ns}"
