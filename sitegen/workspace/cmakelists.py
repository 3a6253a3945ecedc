"""Read a CMakeLists.txt: the names of what it builds and installs."""

from __future__ import annotations

import posixpath
import re
from dataclasses import dataclass, field
from pathlib import Path

from sitegen.model import BuildSettings, Fault
from sitegen.workspace.cmakeabsent import Absent, is_maker
from sitegen.workspace.cmakeinstalls import (
    KINDS,
    Arguments,
    Install,
    below_prefix,
    of_interest,
    unescaped,
)
from sitegen.workspace.cmakelibraries import COMMANDS, Libraries
from sitegen.workspace.cmakescript import INCLUDES, PREFIX, VARIABLE, Script
from sitegen.workspace.dependencies import TREES
from sitegen.workspace.presence import exists, is_file

INTERFACE = (".msg", ".srv", ".action", ".idl")
ADDS_EXECUTABLE = ("add_executable", "ament_auto_add_executable")
SETS_PROPERTIES = ("set_target_properties", "set_property")
AUTO = {"INSTALL_TO_PATH", "USE_SCOPED_HEADER_INSTALL_DIR", "SCOPED_HEADER_INSTALL_DIR"}
# The beginning of a value that only CMake knows.
UNKNOWN = re.compile(r"\$(?:\w*\{|<)")
# Commands in install(CODE) that may install something.
ACTIONS = re.compile(r"(?:file|execute_process|configure_file|include)\s*\(", re.IGNORECASE)
# What the build makes: any file, or a program that is compiled.
BUILT = re.compile(r"\$\{\w*BINARY_DIR\}/?")
TARGET = "$<TARGET_"
# A definition of libraries that have nodes of behavior trees.
DEFINES_BEHAVIORS = {"BT_PLUGIN_EXPORT", "-DBT_PLUGIN_EXPORT"}
SETS_UP = "ament_python_install_package"
AFTER_INTERFACES = ("DEPENDENCIES", "LIBRARY_NAME", "SKIP_INSTALL", "ADD_LINTER_TESTS")


@dataclass
class Listing:
    """The result so far; `executables` is None if only CMake can tell their names.

    `sources` maps executables to source files, relative to the CMakeLists.txt of the package, and
    `components` to the classes of the nodes that they run.
    `installs` maps paths below the prefix to what is installed there unchanged. `finds` has the
    packages that are not optional, `requires` those without which CMake fails; with
    `finds_all`, it finds what package.xml names. `plugins` has the packages for which plugins are
    described.
    """

    script: Script
    folder: Path
    executables: list[str] | None = field(default_factory=list)
    interfaces: list[str] = field(default_factory=list)
    sources: dict[str, list[str]] = field(default_factory=dict)
    components: dict[str, str] = field(default_factory=dict)
    installs: list[Install] = field(default_factory=list)
    finds: list[str] = field(default_factory=list)
    requires: list[str] = field(default_factory=list)
    finds_all: bool = False
    plugins: list[str] = field(default_factory=list)
    # The setup.cfg files whose programs ament_python_install_package() installs.
    configs: list[Path] = field(default_factory=list)
    # What CMake refuses, or what is installed and known to CMake only; and where that is uncertain.
    faults: list[Fault] = field(default_factory=list)
    notes: list[Fault] = field(default_factory=list)
    absent: Absent = field(default_factory=Absent)
    libraries: Libraries = field(init=False)

    def __post_init__(self) -> None:
        self.libraries = Libraries(self.folder)

    def add(self, name: str, words: list[str]) -> None:
        """Process one command and its arguments."""
        if is_maker(name, words):
            self.absent.makers.append((name, self.script.values(words)))
        if DEFINES_BEHAVIORS & {*words}:
            self.plugins += TREES
        if name in COMMANDS:
            self.libraries.add(name, self.script.values(words), self.script.folder)
        if name in ADDS_EXECUTABLE and words and not {"IMPORTED", "ALIAS"} & set(words[1:3]):
            self._add_executable(words[0])
            self._add_sources(words)
        elif name in SETS_PROPERTIES and "OUTPUT_NAME" in words[:-1]:
            self._rename(words)
        elif name == "rclcpp_components_register_node" and "EXECUTABLE" in words[:-1]:
            self._add_component(words)
        elif name in INCLUDES and words:
            self._add_include(name, words)
        elif name == "rosidl_generate_interfaces":
            self._add_interfaces(words[1:])
        elif name == "find_package" and ("QUIET" not in words or "REQUIRED" in words):
            self.finds += self.script.values(words[:1])
            if "REQUIRED" in words and self.script.unconditional:
                self.requires += self.script.values(words[:1])
        elif name == "ament_auto_find_build_dependencies" and self.script.unconditional:
            self.finds_all = True
        elif name == "pluginlib_export_plugin_description_file":
            self.plugins += self.script.values(words[:1])
        elif name == "install":
            self._add_install(words)
        elif name == "file" and words[:1] in (["COPY"], ["INSTALL"]):
            if any(word.startswith(PREFIX) for word in self.script.values(words)):
                self._not_run("file", words[0])
        elif name == "ament_auto_package" and "INSTALL_TO_SHARE" in words:
            self._add_shared(words)
        elif name == "ament_python_install_package":
            self._add_python(words)
        elif name == "ament_python_install_module":
            self._add_module(words)

    def _add_include(self, name: str, words: list[str]) -> None:
        """Process another file of the package, or a file of CMake or of another package."""
        path, *options = self.script.values(words)
        certain = self.script.unconditional and self.script.certain(words[:1])
        if "$" in path:
            self.executables = None
            # What other packages and CMake have in their variables is theirs.
            own = self.script.computed.intersection(VARIABLE.findall(path))
            if name == "add_subdirectory" or own:
                self._say(f"sitegen does not know the value of '{path}'; write it out", name)
        elif name == "add_subdirectory":
            self.absent.check(self._at(name), self.script.folder / path, certain=certain)
        elif path.endswith(".cmake") and "OPTIONAL" not in options:
            self.absent.check(self._at(name), self.script.module(path), certain=certain)

    def _at(self, key: str) -> Fault:
        return Fault(self.script.location, key, "")

    def _say(
        self, message: str, key: str = "install", *, hides: bool = True, optional: bool = False
    ) -> None:
        certain = self.script.unconditional and not optional
        said = Fault(self.script.location, key, message, hides)
        (self.faults if certain else self.notes).append(said)

    def _add_install(self, given: list[str]) -> None:
        words = self.script.values(given)
        if not words or not self.script.installed:
            return
        if words[0] in ("CODE", "SCRIPT") and self._acts(*words):
            self._not_run("install", words[0])
        if words[0] not in KINDS:
            return
        arguments = Arguments.of([unescaped(word) for word in words])
        if not arguments.by_default:
            return
        try:
            to = arguments.destination(self.script.variables)
        except ValueError as error:
            unknown = next((word for word in words if UNKNOWN.search(word)), "")
            what = f"sitegen does not know the value of '{unknown}'; write it out"
            self._say(what if unknown else str(error))
            return
        self._install(arguments, to, given)

    def _acts(self, kind: str, *words: str) -> bool:
        """Return whether the code or the script of install() may install something."""
        text = words[0] if words else ""
        if kind == "SCRIPT":
            try:
                text = (self.script.folder / text).read_text(encoding="utf-8-sig", errors="replace")
            except (OSError, ValueError):
                return True
        return bool(ACTIONS.search(text))

    def _not_run(self, key: str, kind: str) -> None:
        what = f"{kind} is not run for Python programs; a page lacks the files that it installs"
        self.notes.append(Fault(self.script.location, key, what, hides=False))

    def _add_shared(self, words: list[str]) -> None:
        """Process the folders that ament_auto_package() installs."""
        after = words[words.index("INSTALL_TO_SHARE") + 1 :]
        end = next((n for n, word in enumerate(after) if word in AUTO), len(after))
        share = f"share/{''.join(self.script.variables['PROJECT_NAME'])}"
        names = self.script.values(after[:end])
        self._install(Arguments("DIRECTORY", {"DIRECTORY": names}), share, after[:end])

    def _install(self, arguments: Arguments, to: str, given: list[str]) -> None:
        """Note what is installed; `given` are the arguments before they are evaluated."""
        names = [name for name in arguments.names if not name.startswith(TARGET)]
        optional = "OPTIONAL" in arguments.options
        unknown = next((word for word in (to, *names) if UNKNOWN.search(word)), "")
        destination = below_prefix(to, PREFIX)
        if destination is None:
            return
        if unknown and of_interest(destination):
            what = f"sitegen does not know the value of '{unknown}'; write it out"
            if BUILT.match(unknown):
                name = BUILT.sub("", unknown)
                what = f"'{name}' is made by the build, which is not run for Python programs"
                what += "; install a file of the package"
            self._say(what, hides=not destination.startswith("share/"), optional=optional)
        if UNKNOWN.search(to):
            return
        here = f"{self.script.folder.as_posix()}/"
        known = [posixpath.join(here, word) for word in names if not UNKNOWN.search(word)]
        certain = self.script.unconditional and self.script.certain(given)
        self.installs.append(
            Install(
                arguments.kind,
                tuple(known),
                destination,
                self.script.location,
                arguments.rename,
                tuple(arguments.rules),
                only_matching="FILES_MATCHING" in arguments.options,
                needed=certain and not optional,
            )
        )

    def _add_python(self, given: list[str]) -> None:
        words = self.script.values(given)
        if words:
            at = words.index("PACKAGE_DIR") + 1 if "PACKAGE_DIR" in words[:-1] else 0
            folder = Arguments("DIRECTORY", {"DIRECTORY": [f"{words[at]}/"]})
            self._install(folder, f"python/{words[0]}", given)
            if "SCRIPTS_DESTINATION" in words[:-1]:
                self._add_programs(words)

    def _add_programs(self, words: list[str]) -> None:
        """Note the setup.cfg with the programs of a Python package, if `ros2 run` finds them."""
        to = below_prefix(words[words.index("SCRIPTS_DESTINATION") + 1], PREFIX)
        given = words[words.index("SETUP_CFG") + 1] if "SETUP_CFG" in words[:-1] else ""
        file = self.script.folder / (given or "setup.cfg")
        if to != f"lib/{''.join(self.script.variables['PROJECT_NAME'])}":
            return
        if given and not is_file(file):
            self._say(f"no file '{given}'; add it, or remove SETUP_CFG", SETS_UP)
        elif is_file(file):
            self.configs.append(file)

    def _add_module(self, given: list[str]) -> None:
        words = self.script.values(given)
        if words:
            at = words.index("DESTINATION_SUFFIX") + 1 if "DESTINATION_SUFFIX" in words[:-1] else 0
            to = f"python/{words[at]}" if at else "python"
            self._install(Arguments("FILES", {"FILES": words[:1]}), to, given)

    def _add_executable(self, word: str) -> None:
        name = self.script.surely(word)
        if name is None:
            self.executables = None
        elif self.executables is not None and name not in self.executables:
            self.executables.append(name)

    def _rename(self, words: list[str]) -> None:
        """Process a property that gives the program of a target another name."""
        end = next(at for at, word in enumerate(words) if word in ("PROPERTY", "PROPERTIES"))
        name = self.script.surely(words[words.index("OUTPUT_NAME") + 1])
        for target in self.script.values(words[:end]):
            if self.executables is None or target not in self.executables:
                continue
            if name is None:
                self.executables = None
            else:
                self.executables[self.executables.index(target)] = name
                self.sources[name] = self.sources.pop(target, [])
                self.libraries.rename(target, name)

    def _add_component(self, words: list[str]) -> None:
        executable = words[words.index("EXECUTABLE") + 1]
        self._add_executable(executable)
        if "PLUGIN" in words[:-1]:
            names = self.script.values([executable])
            plugins = self.script.values([words[words.index("PLUGIN") + 1].removeprefix("::")])
            self.components |= dict(zip(names, plugins, strict=False))

    def _add_sources(self, words: list[str]) -> None:
        for name, *files in filter(None, [self.script.values(words)]):
            self.sources[name] = [
                self._below(word) for word in files if "." in word and "$" not in word
            ]
            if "DIRECTORY" in files[:-1]:  # of ament_cmake_auto
                self.sources[name] = self.libraries.files(files, self.script.folder)

    def _below(self, word: str) -> str:
        """Return a name relative to the package if the script gives its whole path."""
        return word.removeprefix(f"{self.folder.as_posix()}/").removeprefix("./")

    def _add_interfaces(self, words: list[str]) -> None:
        end = next((i for i, word in enumerate(words) if word in AFTER_INTERFACES), len(words))
        self.interfaces += [
            self._below(word.replace(":", "/"))
            for word in self.script.values(words[:end])
            if word.endswith(INTERFACE) and "$" not in word
        ]


def installed(listing: Listing, root: Path) -> dict[str, Path]:
    """Return the files below `root` that a package installs unchanged, by path."""
    found: dict[str, Path] = {}
    for install in listing.installs:
        for path, file in install.files(root):
            if is_file(file) and file.resolve().is_relative_to(root.resolve()):
                found[path] = file
    return found


def outside(listing: Listing, root: Path) -> list[Fault]:
    """Return what is installed from outside of `root`, which a page does not have."""
    return [
        Fault(install.location, "install", f"'{name}' is outside the folder of site.yaml", False)
        for install in listing.installs
        for name in install.names
        if of_interest(install.destination)
        and exists(name)
        and not Path(name).resolve().is_relative_to(root.resolve())
    ]


def read(file: Path, package: str, settings: BuildSettings) -> Listing:
    """Return what the CMakeLists.txt of `package`, and the files that it includes, build."""
    script = Script.of(file, package, settings.definitions)
    listing = Listing(script, script.folder)
    for name, words, _ in script.read(file):
        listing.add(name, words)
    for install in listing.installs:
        listing.absent.check_install(install)
    faults, notes = listing.absent.found(listing.folder)
    listing.faults += faults
    listing.notes += notes
    return listing
