"""Read `build` of site.yaml: how CMake builds packages of the workspace."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from sitegen.config.document import Value, parse, read
from sitegen.config.schema import BUILD
from sitegen.config.section import check
from sitegen.errors import Location, Problems, nearest
from sitegen.model import BuildSettings, Package

DEFINITION = re.compile(r"-D([^\s:=;]+)(?::[A-Z]+)?=.*", re.DOTALL)
# Environment variables as shells take them.
VARIABLE = re.compile(r"[A-Za-z_]\w*", re.ASCII)
# sitegen builds for another platform than this computer, without tests, into its own folders.
RESERVED = re.compile(
    r"SITEGEN_\w*|BUILD_TESTING|Eigen3_DIR|CMAKE_(TOOLCHAIN_FILE|MAKE_PROGRAM|PREFIX_PATH"
    r"|INSTALL_PREFIX|PROJECT_INCLUDE|BUILD_TYPE|TRY_COMPILE_TARGET_TYPE"
    r"|FIND_ROOT_PATH_MODE_PACKAGE|(C|CXX)_(COMPILER|COMPILER_LAUNCHER|FLAGS_RELEASE))"
)


@dataclass(frozen=True)
class Builds:
    """The settings of packages by name, and where they were given."""

    settings: Mapping[str, BuildSettings] = field(default_factory=dict)
    _given: Mapping[str, Value] = field(default_factory=dict)

    def check(self, packages: Mapping[str, Package], problems: Problems) -> None:
        """Report settings of packages that the workspace has not, or that CMake does not build."""
        for name, value in self._given.items():
            package = packages.get(name)
            if package is None:
                message = f"no package '{name}' in the workspace; {nearest(name, packages)}"
                problems.add(value.location, value.key, message)
            elif not (package.path / "CMakeLists.txt").is_file():
                message = f"'{name}' has no CMakeLists.txt, so CMake does not build it"
                problems.add(value.location, value.key, message)


def builds(given: Value | None, problems: Problems) -> Builds:
    """Return the settings of packages, and report those that CMake would not take."""
    if given and given.kind != "mapping":  # else the schema has checked it
        problems.add(given.location, given.label, f"expected packages, found {given.found}")
    values = given.entries(problems) if given else {}
    return Builds({name: _settings(value, problems) for name, value in values.items()}, values)


def builds_of(folder: Path, problems: Problems) -> Builds:
    """Return the settings in the site.yaml of `folder`, if it has one."""
    file = folder / "site.yaml"
    text = read(file, problems) if file.is_file() else None
    top = parse(text, Location(file, 1), problems) if text else None
    return builds(top.entries(problems).get("build") if top else None, problems)


def _settings(value: Value, problems: Problems) -> BuildSettings:
    section = check(value, BUILD, problems)
    definitions, environment = section.get("cmake"), section.get("environment")
    items = definitions.items() if definitions else []
    for item in items:
        found = DEFINITION.fullmatch(item.text)
        if not found:
            message = f"'{item.text}' is not a definition; write it like '{_definition(item.text)}'"
            problems.add(item.location, item.key, message)
        elif RESERVED.fullmatch(found[1]):
            message = f"sitegen sets '{found[1]}' itself, for builds for the browser; remove it"
            problems.add(item.location, item.key, message)
    for name, each in environment.entries(problems).items() if environment else ():
        if not VARIABLE.fullmatch(name):
            message = f"'{name}' is not a valid name of an environment variable"
            problems.add(each.location, each.key, message)
    texts = environment.texts(problems) if environment else {}
    return BuildSettings(tuple(item.text for item in items), texts)


def _definition(text: str) -> str:
    """Return the definition that somebody may have meant."""
    name, _, value = text.removeprefix("-D").partition("=")
    return f"-D{name}={value or 'ON'}" if VARIABLE.fullmatch(name) else "-DWITH_CAMERA=OFF"
