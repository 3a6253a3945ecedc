"""Turn the output of CMake, Ninja and the compiler into errors of the site."""

from __future__ import annotations

import re
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

from sitegen.errors import relative
from sitegen.interfaces.generator import PROBLEM
from sitegen.model import Package
from sitegen.nodes.cpp.cmake import PROGRAMS
from sitegen.report import count
from sitegen.workspace.absent import NO_BUILD, NOT_HERE, clone, without
from sitegen.workspace.libraries import EIGEN, HEADER_ONLY, compiled_for, of_header
from sitegen.workspace.repositories import repository

NOT_FOUND = re.compile(r'package\s+configuration\s+file\s+provided\s+by\s+"([\w.+-]+)"')
# A library or a component that a package does not export.
NOT_EXPORTED = re.compile(
    r"links to:\s+(?P<package>[\w.+-]+)::(?P<library>[\w.+-]+)\s"
    r"|package '(?P<other>\S+)' registers no component"
)
# The command lines of a build, and lines that Ninja and em++ add.
COMMANDS = re.compile(
    r"ninja: (Entering|build stopped)|\[\d+/\d+\] |FAILED: |: && |\S*cmake -E "
    r"|\S*/em(\+\+|cc|ar|ranlib)(\.py)?\s|\S.* -I -S \S.*/flags\.py|em(\+\+|cc): error: '"
    r"|Call Stack \(most recent call first\):$|See also \""
)
# An entry of CMake's cache for a package that was not found.
ABSENT = re.compile(r"^(\w+)_DIR:PATH=\1_DIR-NOTFOUND$", re.MULTILINE)
MISSING_HEADER = re.compile(r"^(\S+):(\d+):\d+: fatal error: '([^']+)' file not found$", re.M)
MISSING_MODULE = re.compile(r"^ModuleNotFoundError: No module named '(\w+)", re.M)
# em++ has libraries, such as SDL 2, that it would download; a build does not let it.
PORT = re.compile(r"File \"\S*/tools/ports/(?!__init__)(\w+)\.py\", line \d+, in get$", re.M)
FAILED_SOURCE = re.compile(
    r"^FAILED: (?P<folder>\S+/)?CMakeFiles/(?P<target>[^/]+)\.dir/(?P<file>.+?)\.o(bj)?\s*$", re.M
)
ERROR = re.compile(r"^(?P<file>/[^:\n]+):(?P<place>\d+:\d+): (fatal )?error: (?P<what>.+)$", re.M)
# The outermost one of an undefined symbol; libraries name their folders of headers so, too.
NAMESPACE = re.compile(r"undefined symbol: (?:(?:typeinfo|vtable) for )?(\w+)::")
# The name of an undefined function or class, without its namespaces and arguments.
SYMBOL = re.compile(r"undefined symbol: (?:(?:typeinfo|vtable) for )?(?:\w+::)*~?(\w+)")
UNDEFINED = re.compile(r"^wasm-ld\S*: error: .*?(undefined symbol: .+)$", re.M)


@dataclass(frozen=True)
class Diagnosis:
    """Explains the errors of `package`; paths are relative to `root`, as one types them there.

    `needs` are the packages of the workspace that it depends on.
    """

    root: Path
    package: Package
    needs: Sequence[Package] = ()

    def missing(self, output: str) -> str:
        """Return the required package that CMake did not find; "" if it failed otherwise."""
        found = NOT_FOUND.search(output)
        return found[1] if found else ""

    def incomplete(self, output: str) -> tuple[str, str]:
        """Return the package of which CMake did not find a part, and that part if it is a library.

        They are empty if it failed otherwise.
        """
        found = NOT_EXPORTED.search(output)
        return (found["package"] or found["other"], found["library"] or "") if found else ("", "")

    def of_cmake(self, output: str) -> list[str]:
        """Return why CMake could not configure the package."""
        own = re.findall(rf"^{PROBLEM}(.+)$", output, re.M)
        if own:
            return [line.replace(f"{self.root}/", "") for line in own]
        missing = self.missing(output)
        if missing:
            if missing in self.package.depends:
                return [self._needs(missing, clone(missing))]
            return [self._needs(missing, without(EIGEN) if missing == "Eigen3" else NO_BUILD)]
        return [f"{self._cmake}: CMake failed\n{self._quote(output)}"]

    def of_builds(
        self,
        outputs: Mapping[str, str],
        tree: Path,
        failed: Mapping[str, Sequence[str]],
        left_out: Mapping[str, Sequence[str]] = MappingProxyType({}),
    ) -> list[str]:
        """Return why executables could not be compiled, by the output of each.

        Each missing header is reported once. `failed` has the errors of other packages, which
        explain why their headers are missing, and `left_out` those of sources that libraries do
        without, which explain why their functions are.
        """
        headers: dict[str, set[str]] = {}
        problems = []
        for executable, output in outputs.items():
            missing = MISSING_HEADER.findall(output)
            for file, line, header in missing:
                headers.setdefault(header, set()).add(f"{self._show(Path(file))}:{line}")
            if not missing:
                why = _of_functions(output, left_out)
                problems += why or self.of_build(executable, output, tree)
        for header, places in headers.items():
            problems += self._without(header, sorted(places), failed)
        return problems

    def of_targets(
        self, output: str, failed: Mapping[str, Sequence[str]]
    ) -> dict[str, dict[str, list[str]]]:
        """Return which headers sources lack, in one line each, by target and path of the source.

        There is no line for a source that does not compile for another reason. `failed` is that of
        `of_builds`.
        """
        lacking: dict[str, dict[str, list[str]]] = {}
        for command in re.split(r"^(?=FAILED: )", output, flags=re.M):
            if failure := FAILED_SOURCE.match(command):
                lines = []
                if MISSING_HEADER.search(command):
                    lines = self.of_builds({failure["target"]: command}, Path(), failed)
                lacking.setdefault(failure["target"], {})[str(self._source(failure))] = lines
        return lacking

    def _without(
        self, header: str, places: Sequence[str], failed: Mapping[str, Sequence[str]]
    ) -> list[str]:
        folder, _, rest = header.partition("/")
        library_package = compiled_for(header)
        folder = library_package or folder
        # A package of the workspace takes precedence over a library with the same headers.
        theirs = folder in failed or any(need.name == folder for need in self.needs)
        # Only the CMake package of Eigen adds this folder, which is in that of all headers.
        unfound = header.startswith(("Eigen/", "unsupported/Eigen/"))
        if not theirs and not unfound and (library := of_header(header)):
            return [self._needs(library.name, without(library))]
        others = f" (and {count(len(places) - 1, 'other file')})" if len(places) > 1 else ""
        problem = f"{places[0]}: '{self.package.name}' includes '{header}', which was not found"
        if folder in failed:
            return [f"{problem}, because package '{folder}' failed{others}", *failed[folder]]
        hint = f"; is package '{folder}' in the workspace?" if rest else ""
        if rest and (known := repository(folder)):
            hint = f"; clone the sources of '{folder}' into the workspace: {known.command}"
        if library_package or unfound:
            finds = "Eigen3" if unfound else folder
            hint = f"; add find_package({finds} REQUIRED) to CMakeLists.txt"
        if any(need.name == folder for need in self.needs):
            hint = f"; package '{folder}' has no such header"
        return [f"{problem}{others}{hint}"]

    def of_build(self, executable: str, output: str, tree: Path) -> list[str]:
        """Return why `executable` could not be compiled in the build folder `tree`."""
        if f"unknown target '{PROGRAMS}/{executable}.js'" in output:
            what = f"has no executable '{executable}'"
            if names := " and ".join(f"'{name}'" for name in _not_found(tree)):
                what += f" without {names}, {NO_BUILD}"
            return [f"{self._cmake}: package '{self.package.name}' {what}"]
        if module := MISSING_MODULE.search(output):
            what = f"a program that the build of '{self.package.name}' runs needs the Python module"
            return [
                f"{self._cmake}: {what} '{module[1]}': {sys.executable} -m pip install {module[1]}"
            ]
        if port := PORT.search(output):
            return [self._needs(port[1], NO_BUILD)]
        source = FAILED_SOURCE.search(output)
        if source:
            what = f"{self._error(output, self._source(source))} (package '{self.package.name}')"
        else:
            undefined = UNDEFINED.search(output)
            why = f": {undefined[1]}" if undefined else ""
            space = NAMESPACE.search(why)
            library = of_header(space[1]) if space else None
            if library in HEADER_ONLY:
                why += f"; pages have only the headers of {library.name}"
            what = f"{self._cmake}: could not link '{executable}'{why}"
            what += f" (package '{self.package.name}')"
        return [f"{what}\n{self._quote(output)}"]

    def _source(self, failure: re.Match[str]) -> Path:
        """Return the file that a command failed to compile."""
        return self.package.path / (failure["folder"] or "") / failure["file"]

    def _error(self, output: str, file: Path) -> str:
        """Return the first error in a file of the site, with its place, for the source `file`."""
        for found in ERROR.finditer(output):
            place = self._show(Path(found["file"]))
            if not Path(place).is_absolute():
                return f"{place}:{found['place']}: could not compile: {found['what']}"
        return f"{self._show(file)}: could not compile"

    def _needs(self, missing: str, why: str) -> str:
        return f"{self._cmake}: '{self.package.name}' needs '{missing}', {why}"

    @property
    def _cmake(self) -> str:
        return self._show(self.package.path / "CMakeLists.txt")

    def _show(self, file: Path) -> str:
        return relative(file, self.root)

    def _quote(self, output: str) -> str:
        """Return the output of a tool without the command lines in it."""
        shown = [line.rstrip() for line in output.splitlines() if not COMMANDS.match(line)]
        shown = [line for line in shown if not line.startswith("-- ")]
        text = re.sub(r"\n{3,}", "\n\n", "\n".join(shown)).strip()
        return text.replace(f"{self.root}/", "")


def lacks_library(problem: str) -> bool:
    """Return whether a program does not compile because it needs what no page can have."""
    return problem.endswith(NO_BUILD)


def lacks_package(problem: str) -> bool:
    """Return whether a program does not compile because the workspace lacks a package."""
    return f", {NOT_HERE};" in problem


def brief(problem: str) -> str:
    """Return the first line of a problem without its file, for readers who do not have it."""
    first = problem.split("\n", 1)[0]
    return re.sub(r"^\S+: ", "", first)


def _of_functions(output: str, left_out: Mapping[str, Sequence[str]]) -> list[str]:
    """Return why the source is left out that has a function which the linker did not find."""
    for name in dict.fromkeys(SYMBOL.findall(output)):
        for file, lines in left_out.items():
            text = Path(file).read_text(encoding="utf-8-sig", errors="replace")
            if re.search(rf"\b{name}\b", text):
                return [*lines]
    return []


def _not_found(tree: Path) -> list[str]:
    """Return the optional packages that CMake did not find."""
    cache = tree / "CMakeCache.txt"
    return ABSENT.findall(cache.read_text(encoding="utf-8")) if cache.exists() else []
