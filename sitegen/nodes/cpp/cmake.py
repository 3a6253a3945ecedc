"""Configure and build the CMake projects of ROS packages, for one engine of the page."""

from __future__ import annotations

import hashlib
import subprocess
import sys
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from types import MappingProxyType

from sitegen.model import Package
from sitegen.nodes.cpp import buildtools
from sitegen.nodes.cpp.toolchain import Toolchain
from sitegen.shipped import CLIENTS
from sitegen.workspace.libraries import COMPILED_BY
from sitegen.workspace.manifest import ENVIRONMENT

HERE = Path(__file__).parent
CLIENT = CLIENTS / "cpp"
# How programs of sitegen run that stand in front of the compiler, and the one for all commands.
PYTHON = (sys.executable, "-I", "-S")
FLAGS = (*PYTHON, HERE / "flags.py")
# Programs that record their source lines are optimized less, so that lines stay recognizable.
OPTIMIZE, OPTIMIZE_DEBUG = "-O2", "-O1"
SETTINGS = [
    "-DCMAKE_BUILD_TYPE=Release",
    # Emscripten's toolchain file lets CMake find packages only in its own system root.
    "-DCMAKE_FIND_ROOT_PATH_MODE_PACKAGE=BOTH",
    # CMake cannot run a program for the page to test the compiler, and does not need to.
    "-DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY",
    # ament_cmake says so, too, but packages of type `cmake` do without it.
    "-DBUILD_TESTING=OFF",
    # Warnings for developers would hide the error.
    *("-Wno-dev", "-Wno-deprecated"),
    # CMake looks for packages again, because they may have moved.
    *("-U", "*_DIR"),
]

# Where programs are, in the folder of a build.
PROGRAMS = "bin"
# The build type of packages that are no packages of ament.
PLAIN = "cmake"
UNDEFINED = "error: undefined symbol: "

Done = subprocess.CompletedProcess[str]


def _variables(package: Package) -> dict[str, str]:
    """Return the environment of each command for a package: Ninja may configure it again."""
    return {**ENVIRONMENT, **package.settings.environment}


@dataclass(frozen=True)
class CMake:
    """Runs CMake on packages for one `engine`; all files are below `work`.

    With `debug`, programs record their source lines; the library does not. A `draft` is linked
    with less optimization, in a fifth of the time; it is twice as large.
    """

    tools: Toolchain
    work: Path
    engine: str
    debug: bool = False
    draft: bool = False

    @property
    def ros(self) -> Path:
        """The prefix of the interface packages of ROS, which is the same for all engines."""
        return self.work / "ros"

    @property
    def sources(self) -> Path:
        """The folder of the sources of libraries, which is the same for all versions of sitegen."""
        return self.work.parents[1] / "sources"

    @property
    def headers(self) -> Path:
        """The folder of the headers of this computer that programs may use."""
        return self.work / "headers"

    @property
    def library(self) -> Path:
        """The rclcpp library of this engine."""
        return self.work / self.engine / "rclcpp" / "librclcpp.a"

    @property
    def packages(self) -> Path:
        """The folder of the build folders of packages."""
        return self.work / (f"{self.engine}-debug" if self.debug else self.engine) / "packages"

    def tree(self, package: Package) -> Path:
        """The build folder of `package`, named by its location, so that builds are incremental."""
        what = "\n".join([str(package.path), *package.linked, *package.settings.lines])
        place = hashlib.sha256(what.encode()).hexdigest()[:12]
        return self.packages / f"{package.name}-{place}"

    def prefix(self, package: Package) -> Path:
        """The prefix to which `package` exports its headers and libraries."""
        return self.tree(package) / "prefix"

    def program(self, package: Package, executable: str) -> Path:
        """The path of a built `executable`, without its suffix."""
        return self.tree(package) / PROGRAMS / executable

    def has_strict_warnings(self, package: Package) -> bool:
        """Return whether a configured package asks for errors instead of warnings."""
        return "-Werror" in (self.tree(package) / "build.ninja").read_text(encoding="utf-8")

    @property
    def _launcher(self) -> list[str | Path]:
        """The program that CMake runs in place of the C++ compiler: see precompiled.py."""
        store = self.work / self.engine / "precompiled"
        return [*FLAGS, *PYTHON, HERE / "precompiled.py", store, self.ros / "include"]

    @property
    def _link_launcher(self) -> list[str | Path]:
        """The program that CMake runs to link a program: see loadable.py."""
        return [*FLAGS, *PYTHON, HERE / "loadable.py", self.packages]

    def make_libraries(self, package: Package) -> Done:
        """Build what other packages use of a configured package, and export it to its prefix."""
        if package.build_type != PLAIN:
            return self.make(package, "sitegen_libraries")
        # It has no ament_package(): only its own installation knows what others use. A program or
        # an example of it may fail that is not installed.
        tree = self.tree(package)
        variables = _variables(package)
        made = self.tools.run(self.tools.ninja, "-C", tree, "-k", "0", variables=variables)
        done = self.tools.run(self.tools.cmake, "--install", tree, variables=variables)
        return made if done.returncode and made.returncode else done

    def make_library(self) -> Done:
        """Compile the rclcpp library."""
        tree = self.library.parent
        done = replace(self, debug=False)._configure(CLIENT, tree, [], "rclcpp")
        return done if done.returncode else self.tools.run(self.tools.ninja, "-C", tree)

    def configure(
        self,
        package: Package,
        needs: Sequence[Package],
        shown: str,
        lost: Collection[str] = (),
        left_out: Sequence[str] = (),
    ) -> Done:
        """Configure `package`, with the prefixes of the packages `needs`.

        Its programs show the path of its folder as `shown`. They lack the plugins of the packages
        `lost`. `left_out` are definitions that tell CMake what else they lack (leftout.py).
        """
        buildtools.write(needs, self.prefix)
        prefixes = list(map(self.prefix, needs))
        tree = self.tree(package)
        linked = ";".join(name for name in package.linked if name not in lost)
        more = [*package.settings.cmake, f"-DSITEGEN_LINKED={linked}", *left_out]
        return self._configure(package.path, tree, prefixes, shown, more, _variables(package))

    def make_programs(self, package: Package, *executables: str) -> Done:
        """Build programs of a configured package; of several, a failure stops only its own one."""
        # A target can have another name than its program.
        return self.make(package, *(f"{PROGRAMS}/{name}.js" for name in executables))

    def make(self, package: Package, *targets: str) -> Done:
        """Build targets of a configured package; of several, a failure stops only its own one."""
        command: list[str | Path] = [self.tools.ninja, "-C", self.tree(package), *targets]
        if len(targets) > 1:
            command += ["-k", "0"]
        run = partial(self.tools.run, *command, variables=_variables(package))
        done = run()
        if UNDEFINED in done.stdout:
            # The linker can find out who needs the symbol, but doing so takes time at every link.
            done = run(flags="-s LLD_REPORT_UNDEFINED=1")
        return done

    def _configure(
        self,
        source: Path,
        tree: Path,
        prefixes: Sequence[Path],
        shown: str,
        more: Sequence[str] = (),
        variables: Mapping[str, str] = MappingProxyType(ENVIRONMENT),
    ) -> Done:
        optimize = OPTIMIZE_DEBUG if self.debug else OPTIMIZE
        defines = {
            "CMAKE_TOOLCHAIN_FILE": self.tools.platform_file,
            "CMAKE_MAKE_PROGRAM": self.tools.ninja,
            "CMAKE_PREFIX_PATH": ";".join(map(str, [*prefixes, self.ros, CLIENT])),
            "CMAKE_PROJECT_INCLUDE": CLIENT / "cmake" / "engine.cmake",
            "CMAKE_C_FLAGS_RELEASE": optimize,
            "CMAKE_C_COMPILER_LAUNCHER": ";".join(map(str, FLAGS)),
            "CMAKE_CXX_COMPILER_LAUNCHER": ";".join(map(str, self._launcher)),
            "CMAKE_CXX_FLAGS_RELEASE": optimize,
            "CMAKE_INSTALL_PREFIX": tree / "prefix",
            "SITEGEN_COMPILED": ";".join(f"{a}={b}" for a, b in COMPILED_BY.items()),
            "SITEGEN_DEBUG": "ON" if self.debug else "OFF",
            "SITEGEN_DRAFT": "ON" if self.draft else "OFF",
            "SITEGEN_ENGINE": self.engine,
            "SITEGEN_HEADERS": self.headers,
            "SITEGEN_LINK_LAUNCHER": " ".join(f'"{word}"' for word in self._link_launcher),
            "SITEGEN_PREFIX": tree / "prefix",
            "SITEGEN_PROGRAMS": tree / PROGRAMS,
            "SITEGEN_PYTHON": sys.executable,
            "SITEGEN_RCLCPP": self.library,
            "SITEGEN_SHOWN": shown,
            "SITEGEN_SOURCES": self.sources,
        }
        if self.tools.eigen:
            defines["Eigen3_DIR"] = self.tools.eigen
        words = [*more, *(f"-D{name}={value}" for name, value in defines.items())]
        command: list[str | Path] = [self.tools.cmake, "-S", source, "-B", tree, "-G", "Ninja"]
        return self.tools.run(*command, *SETTINGS, *words, variables=variables)
