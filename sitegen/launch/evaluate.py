"""Evaluate a launch file as `ros2 launch` does: which nodes it starts, and how."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

from sitegen.errors import Location, Problems, nearest
from sitegen.launch import (
    attributes,
    commandline,
    processes,
    python,
    windows,
    without,
    xacro,
    xml,
    yaml,
)
from sitegen.launch.names import joined, numbered
from sitegen.launch.parameters import Parameters
from sitegen.launch.scope import Scope
from sitegen.launch.shares import by_package, on_page, shares
from sitegen.launch.substitutions import SubstitutionError, expand
from sitegen.launch.tree import Action, UnreadableError
from sitegen.launch.windows import Window
from sitegen.model import Component, Container, Node, Package
from sitegen.rclyaml import Overrides
from sitegen.workspace import containers, parameterfiles

READERS = {".xml": xml.read, ".launch": xml.read, ".yaml": yaml.read, ".yml": yaml.read}
# Files that include themselves would be read for ever.
DEEPEST, MOST_FILES = 20, 500


def launched(
    file: Path,
    arguments: Mapping[str, str],
    packages: Mapping[str, Package],
    problems: Problems,
    notes: Problems | None = None,
    opened: list[Window] | None = None,
) -> list[Node]:
    """Return the nodes that a launch file starts, and report what does not work on a page.

    Windows that have a counterpart among the widgets are added to `opened`; other programs that
    open windows are skipped, with a note in `notes`.
    """
    with shares(packages) as folders:
        launch = _Launch(packages, folders, problems, notes or Problems(problems.root))
        launch.file(Scope(file, dict(arguments)), Location(file, 1))
        (opened if opened is not None else []).extend(launch.windows)
        return launch.finished()


class _Launch:
    def __init__(
        self,
        packages: Mapping[str, Package],
        folders: Mapping[str, Path],
        problems: Problems,
        notes: Problems,
    ) -> None:
        self._packages = packages
        self._folders = folders
        self._problems = problems
        self._notes = notes
        self._roots = (problems.root, *(each.path for each in packages.values()))
        self._read = 0
        self.nodes: list[Node] = []
        self.windows: list[Window] = []
        # By the full name of a container: its node, and the components loaded into it.
        self._components: dict[str, tuple[str, list[Component]]] = {}
        self._actions: dict[str, Callable[[Action, Scope], object]] = {
            "arg": self._argument,
            "let": self._let,
            "group": self._group,
            "include": self._include,
            "executable": self._process,
            "lifecycle_node": self._managed,
            "node": self._node,
            "node_container": self._container,
            "load_composable_node": self._load,
            "push_ros_namespace": self._push,
            "push_namespace": self._push,
            "set_parameter": self._set_parameter,
            "set_parameters_from_file": self._set_parameters_from_file,
            "set_remap": self._set_remap,
            "set_use_sim_time": self._set_parameter,
            "timer": self._timer,
            "ros_timer": self._timer,
            "log": lambda *_: None,
            "function": self._function,
        }

    def file(self, scope: Scope, location: Location) -> None:
        """Evaluate a launch file that is included at `location`."""
        read = READERS.get(scope.file.suffix)
        if scope.file.suffix == ".py":
            read = self._read_python
        self._read += 1
        if not any(scope.file.resolve().is_relative_to(folder) for folder in self._roots):
            self._note(location, "include", f"'{scope.file}' is outside the folder of site.yaml")
        elif read is None:
            kinds = ", ".join([*READERS, ".py"])
            self._note(
                location,
                "include",
                f"'{scope.file.name}' is not a supported launch file; supported: {kinds}",
            )
        elif scope.depth > DEEPEST or self._read > MOST_FILES:
            self._note(location, "include", "launch files include each other in a cycle")
        else:
            try:
                self._all(read(scope.file), scope)
            except UnreadableError as error:
                self._note(error.location, "launch", str(error))
            except OSError as error:
                self._note(location, "include", f"'{scope.file.name}': {error.strerror}")

    def _read_python(self, file: Path, calls: Sequence[python.Call] = ()) -> list[Action]:
        return python.read(file, self._folders, self._roots, calls)

    def _all(self, actions: list[Action], scope: Scope) -> None:
        for action in actions:
            try:
                if scope.file.suffix != ".py":
                    attributes.check(action)
                if self._holds(action, scope):
                    self._do(action, scope)
            except (SubstitutionError, ValueError) as error:
                self._note(action.location, action.kind, str(error))

    def _do(self, action: Action, scope: Scope) -> None:
        if why := without.LEFT_OUT.get(action.kind):
            self._notes.add(action.location, action.kind, why)
            return
        do = self._actions.get(action.kind)
        if do is None:
            known = sorted([*self._actions, *without.LEFT_OUT])
            advice = nearest(action.kind, known)
            raise ValueError(f"this action is not supported in the browser; {advice}")
        do(action, scope)

    def _holds(self, action: Action, scope: Scope) -> bool:
        """Return whether the conditions of an action hold."""
        for name, wanted in (("if", True), ("unless", False)):
            if name in action.attributes:
                text = self._text(action, name, scope).strip().lower()
                if text not in ("true", "1", "false", "0"):
                    raise ValueError(f"'{text}' is not a boolean; write 'true' or 'false'")
                if (text in ("true", "1")) is not wanted:
                    return False
        return True

    def _argument(self, action: Action, scope: Scope) -> None:
        name = self._needed(action, "name", scope)
        if name not in scope.variables:
            if "default" not in action.attributes:
                raise ValueError(
                    f"'{name}' has no value; give one in 'launch_arguments' of the page"
                )
            scope.variables[name] = self._text(action, "default", scope)
        choices = [self._needed(each, "value", scope) for each in action.of_kind("choice")]
        if choices and scope.variables[name] not in choices:
            value, listed = scope.variables[name], ", ".join(choices)
            raise ValueError(f"'{name}' is '{value}', but must be one of: {listed}")

    def _let(self, action: Action, scope: Scope) -> None:
        scope.variables[self._needed(action, "name", scope)] = self._needed(action, "value", scope)

    def _group(self, action: Action, scope: Scope) -> None:
        flags = ("scoped", "forwarding")
        is_so = {key: self._text(action, key, scope).lower() not in ("false", "0") for key in flags}
        kept = {
            self._needed(each, "name", scope): self._needed(each, "value", scope)
            for each in action.of_kind("keep")
        }
        inner = scope.of_group(**is_so)
        inner.variables.update(kept)
        self._all([each for each in action.inside if each.kind != "keep"], inner)

    def _include(self, action: Action, scope: Scope) -> None:
        """Evaluate a file in the scope of this one: only groups have a scope of their own."""
        file = Path(self._needed(action, "file", scope))
        for given in action.of_kind("arg", "let"):
            self._let(given, scope)
        resolved = file.resolve() if file.is_absolute() else file
        inner = replace(scope, file=resolved, depth=scope.depth + 1, calls=())
        self.file(inner, action.location)
        scope.namespace = inner.namespace

    def _push(self, action: Action, scope: Scope) -> None:
        scope.namespace = joined(scope.namespace, self._needed(action, "namespace", scope))

    def _set_parameter(self, action: Action, scope: Scope) -> None:
        is_clock = action.kind == "set_use_sim_time"
        name = "use_sim_time" if is_clock else self._needed(action, "name", scope)
        scope.parameters.append((name, self._parameters(scope).value(action)))

    def _set_parameters_from_file(self, action: Action, scope: Scope) -> None:
        scope.parameters.append(self._file(self._needed(action, "filename", scope)))

    def _set_remap(self, action: Action, scope: Scope) -> None:
        # Of two rules for one name, the first counts.
        old, new = self._needed(action, "from", scope), self._needed(action, "to", scope)
        scope.remaps.setdefault(old, new)

    def _timer(self, action: Action, scope: Scope) -> None:
        start = f"these nodes start at once, not after {self._needed(action, 'period', scope)} s"
        message = f"delays are not supported in the browser: {start}"
        self._notes.add(action.location, action.kind, message)
        self._all(action.inside, scope.inner())

    def _function(self, action: Action, scope: Scope) -> None:
        if scope.file.suffix != ".py":
            raise ValueError("only launch files in Python contain functions")
        outer = scope.calls
        scope.calls = (*outer, (int(action.attributes["number"]), dict(scope.variables)))
        try:
            self._all(self._read_python(scope.file, scope.calls), scope)
        except UnreadableError as error:
            self._note(error.location, "launch", str(error))
        finally:
            scope.calls = outer

    def _node(self, action: Action, scope: Scope) -> None:
        package = self._needed(action, "pkg", scope)
        executable = self._needed(action, "exec", scope)
        if windows.known(package, executable) and package not in self._packages:
            own = self._words(action, "args", scope), self._remaps(action, scope)
            self.windows.append(Window(executable, *own, scope.namespace, action.location))
            return
        if why := without.program(package, executable, self._packages):
            self._notes.add(action.location, action.kind, why)
            return
        for why in without.parts(action):
            self._notes.add(action.location, action.kind, why)
        start = self._container if package == containers.PACKAGE else self._started
        start(action, scope)

    def _managed(self, action: Action, scope: Scope) -> None:
        """Start a lifecycle node."""
        for name in ("name", "namespace"):
            self._needed(action, name, scope)
        if self._text(action, "autostart", scope).lower() in ("true", "1"):
            self._notes.add(action.location, action.kind, without.AUTOSTART)
        self._node(action, scope)

    def _process(self, action: Action, scope: Scope) -> None:
        """Start a program of the workspace that is given as a command line."""
        try:
            found = processes.program(self._words(action, "cmd", scope), self._folders)
        except (SubstitutionError, ValueError):
            found = None
        if found is None:
            self._notes.add(action.location, action.kind, without.OF_SYSTEM)
            return
        words = {"pkg": found.package, "exec": found.executable, "args": shlex.join(found.words)}
        self._node(Action("node", words, action.location), Scope(scope.file, scope.variables))

    def _started(self, action: Action, scope: Scope) -> Node:
        executable = self._needed(action, "exec", scope)
        own = self._text(action, "name", scope)
        words = self._words(action, "args", scope)
        ros = self._words(action, "ros_args", scope)
        words += ["--ros-args", *ros, "--"] if ros else []
        name = own or executable
        taken = {node.name for node in self.nodes}
        number = next(n for n in range(1, len(taken) + 2) if numbered(name, n) not in taken)
        namespace = joined(scope.namespace, self._text(action, "namespace", scope))
        node = Node(
            name=numbered(name, number),
            package=self._needed(action, "pkg", scope),
            executable=executable,
            location=action.location,
            namespace=namespace,
            remap={**({"__node": own} if own else {}), **self._remaps(action, scope)},
            parameters=self._values(action, scope, namespace),
            arguments=tuple(on_page(word, self._folders) for word in words),
        )
        self.nodes.append(node)
        return node

    def _container(self, action: Action, scope: Scope) -> None:
        name = self._needed(action, "exec", scope)
        if name not in containers.EXECUTORS:
            known = nearest(name, containers.EXECUTORS)
            raise ValueError(f"'{name}' is not a supported component container; {known}")
        node = self._started(action, scope)
        self._components[f"{node.namespace}/{node.remap.get('__node', name)}"] = (node.name, [])
        self._load_into(node.name, action, scope)

    def _load(self, action: Action, scope: Scope) -> None:
        target = self._needed(action, "target", scope)
        full = target if target.startswith("/") else f"{scope.namespace}/{target}"
        if full not in self._components:
            known = nearest(full, self._components)
            raise ValueError(f"no component container '{full}' in this launch file; {known}")
        self._load_into(self._components[full][0], action, scope)

    def _load_into(self, name: str, action: Action, scope: Scope) -> None:
        """Load the components inside `action` into a container."""
        [loaded] = (loaded for node, loaded in self._components.values() if node == name)
        for each in action.of_kind("composable_node"):
            if not self._holds(each, scope):
                continue
            own = self._text(each, "name", scope)
            namespace = joined(scope.namespace, self._text(each, "namespace", scope))
            rules = {"__node": own, "__ns": namespace, **self._remaps(each, scope)}
            words = [w for old, new in rules.items() if new for w in ("-r", f"{old}:={new}")]
            for parameter, value in self._values(each, scope, namespace).items():
                words += ["-p", f"{parameter}:={value}"]
            loaded.append(
                Component(
                    package=self._needed(each, "pkg", scope),
                    plugin=self._needed(each, "plugin", scope),
                    arguments=("--ros-args", *words) if words else (),
                    location=each.location,
                )
            )

    def finished(self) -> list[Node]:
        """Return the nodes, with all components loaded into their containers."""
        loaded = dict(self._components.values())
        return [
            replace(
                node,
                executable=containers.executable(node.executable, loaded[node.name]),
                kind=Container(tuple(loaded[node.name])),
            )
            if loaded.get(node.name)
            else node
            for node in self.nodes
        ]

    def _remaps(self, action: Action, scope: Scope) -> dict[str, str]:
        remaps = dict(scope.remaps)
        for remap in action.of_kind("remap"):
            remaps.setdefault(*(self._needed(remap, key, scope) for key in ("from", "to")))
        return remaps

    def _values(self, action: Action, scope: Scope, namespace: str) -> dict[str, str]:
        name = self._text(action, "name", scope)
        full = f"{namespace.removesuffix('/')}/{name}" if namespace and name else ""
        parameters, everyones = self._parameters(scope), scope.parameters
        if action.kind == "composable_node":
            rules = parameters.of_component(action, everyones, f"{namespace}/{name}")
        else:
            rules = parameters.of_node(action, everyones, full)
        return {name: on_page(value, self._folders) for name, value in rules.items()}

    def _parameters(self, scope: Scope) -> Parameters:
        return Parameters(lambda text: self._expanded(text, scope), self._file)

    def _file(self, name: str) -> Path:
        file = Path(name)
        if not file.resolve().is_relative_to(self._problems.root) or not file.is_file():
            raise ValueError(f"no file '{file}' below the folder of site.yaml")
        return file

    def _words(self, action: Action, name: str, scope: Scope) -> list[str]:
        """Return a command line with the contents of parameter files in place of the files."""
        found: list[str] = []
        line = commandline.split(action.attributes.get(name, ""))
        waiting = (self._expanded(word, scope) for word in line)
        for word in waiting:
            if word != parameterfiles.OPTION:
                found.append(word)
                continue
            given = Overrides()
            parameterfiles.add(given, self._file(next(waiting, "")))
            for name, value in parameterfiles.rules(given).items():
                found += ["-p", f"{name}:={value}"]
        return found

    def _needed(self, action: Action, name: str, scope: Scope) -> str:
        if name not in action.attributes:
            raise ValueError(f"'{name}' is missing")
        return self._text(action, name, scope)

    def _text(self, action: Action, name: str, scope: Scope) -> str:
        return self._expanded(action.attributes.get(name, ""), scope)

    def _expanded(self, text: str, scope: Scope) -> str:
        run = partial(xacro.printed, folders=self._folders, roots=self._roots)
        return expand(text, scope.variables, scope.file, self._share, run)

    def _share(self, package: str) -> Path:
        found = self._folders.get(package)
        if found is None:
            advice = nearest(package, self._packages)
            raise SubstitutionError(f"no package '{package}' in the workspace; {advice}")
        return found

    def _note(self, location: Location, key: str, message: str) -> None:
        self._problems.add(location, key, by_package(message))
