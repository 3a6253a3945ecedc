"""Configure and build the CMake project of a package, without what no page can have."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from sitegen.errors import SiteError
from sitegen.model import Build, Package
from sitegen.nodes.cpp import leftout, plugins
from sitegen.nodes.cpp.cmake import CMake, Done
from sitegen.nodes.cpp.diagnosis import Diagnosis
from sitegen.nodes.cpp.leftout import LeftOut, Problems


@dataclass(frozen=True)
class Project:
    """The CMake project of `package`, which depends on the packages `needs`, for one engine.

    `failed` has the errors of these packages. `state` identifies all sources. Programs show the
    path of the package as `shown`, and messages are relative to `root`. With `keep_going`, programs
    do without plugins whose sources have errors.
    """

    cmake: CMake
    package: Package
    needs: Sequence[Package]
    failed: Problems
    state: str
    shown: str
    root: Path
    keep_going: bool

    @property
    def tree(self) -> Path:
        """The build folder."""
        return self.cmake.tree(self.package)

    @property
    def is_prepared(self) -> bool:
        """Whether other packages can use what is built of this one."""
        return self._stamp.exists() and self._stamp.read_text() == self.state

    def prepare(self) -> None:
        """Build and export what other packages use.

        Raises: SiteError if that is not possible.
        """
        self.configure()
        made = self.make(lambda: self.cmake.make_libraries(self.package))
        if made.returncode:
            raise self.error({"libraries": made.stdout})
        self._stamp.write_text(self.state)

    def forget(self) -> None:
        """Remove what other packages use."""
        shutil.rmtree(self.cmake.prefix(self.package), ignore_errors=True)

    def configure(self, left_out: LeftOut | None = None) -> None:
        """Configure the project, without the libraries and sources `left_out`.

        Raises: SiteError if CMake cannot do so.
        """
        # Drafts are built in the same folder, whose contents may be those of another kind of build.
        self._stamp.unlink(missing_ok=True)
        left_out = left_out or LeftOut()
        left_out.keep(self.tree)
        done = self.cmake.configure(
            self.package, self.needs, self.shown, self._lost, left_out.definitions
        )
        if done.returncode:
            diagnosis = Diagnosis(self.root, self.package)
            why = self.failed.get(diagnosis.missing(done.stdout)) or self._left_out_of(
                *diagnosis.incomplete(done.stdout)
            )
            raise SiteError([*why] or diagnosis.of_cmake(done.stdout))

    def make(self, build: Callable[[], Done]) -> Done:
        """Run a build. Leave out what needs a library that no page can have."""
        diagnosis = Diagnosis(self.root, self.package, self.needs)
        while (done := build()).returncode:
            lacking = diagnosis.of_targets(done.stdout, self.failed)
            left_out = leftout.more(self.tree, lacking)
            if not left_out:
                break
            self.configure(left_out)
        return done

    def error(self, outputs: Mapping[str, str]) -> SiteError:
        """Return why programs did not compile, by the output of each."""
        diagnosis = Diagnosis(self.root, self.package, self.needs)
        sources: dict[str, Sequence[str]] = {}
        for one in (*self.needs, self.package):
            sources |= LeftOut.of(self.cmake.tree(one)).sources
        return SiteError(diagnosis.of_builds(outputs, self.tree, self.failed, sources))

    def note(self, build: Build) -> None:
        """Note beside a program what it is built without."""
        linked = [one for one in self.needs if one.name in self.package.linked]
        trees = map(self.cmake.tree, (*linked, self.package))
        libraries = [LeftOut.of(tree).libraries for tree in trees]
        plugins.note(build, self._lost, libraries)

    @property
    def _stamp(self) -> Path:
        return self.tree / "prepared"

    @property
    def _lost(self) -> Problems:
        return plugins.lost(self.package, self.failed, keep_going=self.keep_going)

    def _left_out_of(self, name: str, library: str) -> list[str]:
        """Return why a library, or any, was left out of a package that this one depends on."""
        trees = (self.cmake.tree(need) for need in self.needs if need.name == name)
        found = {key: lines for tree in trees for key, lines in LeftOut.of(tree).libraries.items()}
        return [line for key in found if library in ("", key) for line in found[key]]
