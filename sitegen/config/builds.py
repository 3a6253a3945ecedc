"""Read `build` of site.yaml: how CMake builds packages of the workspace."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

from sitegen import workspace
from sitegen.config.document import Value, parse, read
from sitegen.config.schema import BUILD, FILE
from sitegen.config.section import check, conforms
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


def build_settings(given: Value | None, problems: Problems) -> dict[str, BuildSettings]:
    """Return the settings of packages by name, and report those that CMake would not take."""
    values = given.entries(problems) if given else {}
    return {name: _settings(value, problems) for name, value in values.items()}


def check_settings(
    settings: Mapping[str, BuildSettings], packages: Mapping[str, Package], problems: Problems
) -> None:
    """Report settings of packages that the workspace has not, or that CMake does not build."""
    for name, each in settings.items():
        message = ""
        if name not in packages:
            message = f"no package '{name}' in the workspace; {nearest(name, packages)}"
        elif not (packages[name].path / "CMakeLists.txt").is_file():
            message = f"'{name}' has no CMakeLists.txt, so CMake does not build it"
        if message and each.location:
            problems.add(each.location, f"build.{name}", message)


def packages_of(folder: Path, problems: Problems) -> dict[str, Package]:
    """Return the packages of a workspace, with the settings in its site.yaml, if it has one."""
    file = folder / "site.yaml"
    text = read(file, problems) if file.is_file() else None
    top = parse(text, Location(file, 1), problems) if text else None
    given = top.entries(problems).get("build") if top else None
    key = next(key for key in FILE if key.name == "build")
    sound = given if given and conforms(given, key, problems) else None
    settings = build_settings(sound, problems)
    packages = workspace.scan(folder, settings, problems)
    check_settings(settings, packages, problems)
    return packages


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
    variables = environment.entries(problems) if environment else {}
    for name, each in variables.items():
        if not VARIABLE.fullmatch(name):
            message = f"'{name}' is not a valid name of an environment variable"
            problems.add(each.location, each.key, message)
    texts = {name: each.text for name, each in variables.items()}
    return BuildSettings(tuple(item.text for item in items), texts, value.location)


def _definition(text: str) -> str:
    """Return the definition that somebody may have meant."""
    name, _, value = text.removeprefix("-D").partition("=")
    return f"-D{name}={value or 'ON'}" if VARIABLE.fullmatch(name) else "-DWITH_CAMERA=OFF"
