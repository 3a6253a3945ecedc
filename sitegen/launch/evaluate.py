"""Evaluate a launch file as `ros2 launch` does: which nodes it starts, and how."""

from __future__ import annotations

import shlex
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from sitegen.errors import Location, Problems, nearest
from sitegen.launch import (
    absent,
    attributes,
    loops,
    processes,
    python,
    windows,
    without,
    xml,
    yaml,
)
from sitegen.launch.components import Components
from sitegen.launch.environment import Environment
from sitegen.launch.events import Events
from sitegen.launch.names import free, joined
from sitegen.launch.scope import Scope
from sitegen.launch.settings import SETTINGS, let
from sitegen.launch.shares import MADE, by_package, shares
from sitegen.launch.substitutions import SubstitutionError
from sitegen.launch.texts import Texts
from sitegen.launch.tree import Action, UnreadableError
from sitegen.launch.windows import Window
from sitegen.model import Argument, Handler, Node, Package
from sitegen.workspace import containers

READERS = {".xml": xml.read, ".launch": xml.read, ".yaml": yaml.read, ".yml": yaml.read}
# It also takes the file of a description as its argument.
STATE_PUBLISHER = "robot_state_publisher"
# The attributes of processes that nodes have, too.
OF_PROCESSES = ("clean_env", "on_exit", "respawn", "respawn_delay", "respawn_max_retries")
# Files that include themselves would be read for ever.
DEEPEST, MOST_FILES = 20, 500


@dataclass(frozen=True)
class LaunchDescription:
    """What a launch file describes: the nodes that it starts, and what it does while they run.

    `windows` are those that have a counterpart among the widgets; `arguments` are those that the
    file and the files that it includes declare.
    """

    nodes: Sequence[Node] = ()
    windows: Sequence[Window] = ()
    handlers: Sequence[Handler] = ()
    arguments: Sequence[Argument] = ()


def launched(
    file: Path,
    arguments: Mapping[str, str],
    packages: Mapping[str, Package],
    problems: Problems,
    notes: Problems | None = None,
    environment: Mapping[str, str] | None = None,
    missing: Callable[[str], str] = absent.published,
) -> LaunchDescription:
    """Return what a launch file describes, and report what does not work on a page.

    It can read the variables in `environment`, and its nodes have them. Programs that open a window
    without a counterpart are skipped, with a note in `notes`, as is what needs a package that
    `packages` lack, if `missing` returns a note about it.
    """
    with shares(packages) as folders, tempfile.TemporaryDirectory(prefix=MADE) as made:
        roots = [problems.root, *(package.path for package in packages.values())]
        lacking = absent.Absent(missing)
        reader = python.Reader(folders, roots, Path(made).resolve(), lacking)
        launch = _Launch(packages, reader, problems, notes or Problems(problems.root))
        scope = Scope(file, dict(arguments), environment=Environment(environment))
        launch.run(scope, Location(file, 1))
        handlers = launch.events.handlers.finished()
        nodes = launch.finished()
        return LaunchDescription(nodes, launch.windows, handlers, launch.declared)


class _Launch:
    def __init__(
        self,
        packages: Mapping[str, Package],
        reader: python.Reader,
        problems: Problems,
        notes: Problems,
    ) -> None:
        self._packages = packages
        self._reader = reader
        self._problems = problems
        self._notes = notes
        self._texts = Texts(reader, problems.root)
        self._read = self._readings = 0
        self.nodes: list[Node] = []
        self.windows: list[Window] = []
        self._components = Components(self._texts, self._holds, self._lacks)
        self.events = Events(self._texts, notes)
        self._actions: dict[str, Callable[[Action, Scope], object]] = {
            "executable": self._process,
            "for": self._loop,
            "for_each": self._loop,
            "function": self._function,
            "group": self._group,
            "include": self._include,
            "lifecycle_node": self._managed,
            "load_composable_node": self._load,
            "node": self._node,
            "node_container": self._container,
            **self.events.actions,
        }

    @property
    def declared(self) -> list[Argument]:
        return [*self._texts.declared.values()]

    def run(self, scope: Scope, location: Location) -> None:
        """Evaluate a launch file, and then what it does at events."""
        self.file(scope, location)
        self.events.handlers.evaluate(self._all, scope)

    def file(self, scope: Scope, location: Location) -> None:
        """Evaluate a launch file that is included at `location`."""
        read: Callable[[Path], list[Action]] | None = READERS.get(scope.file.suffix)
        if scope.is_python:
            read = partial(self._read_python, scope)
        self._read += 1
        if not any(scope.file.resolve().is_relative_to(root) for root in self._reader.roots):
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
                scope.reading = self._reading()
                self._all(read(scope.file), scope)
            except UnreadableError as error:
                self._note(error.location, "launch", str(error))
            except OSError as error:
                self._note(location, "include", f"'{scope.file.name}': {error.strerror}")

    def _read_python(self, scope: Scope, file: Path) -> list[Action]:
        variables = scope.environment.changes
        return self._reader.read(file, scope.calls, scope.reading, variables)

    def _reading(self) -> int:
        """Return a number for the next reading of a file, or call of a function."""
        self._readings += 1
        return self._readings

    def _all(self, actions: list[Action], scope: Scope) -> None:
        for action in actions:
            try:
                if not scope.is_python:
                    attributes.check(action)
                if self._holds(action, scope):
                    self._do(action, scope)
            except (SubstitutionError, ValueError) as error:
                self._note(action.location, action.kind, str(error))

    def _do(self, action: Action, scope: Scope) -> None:
        if why := without.LEFT_OUT.get(action.kind):
            self._notes.add(action.location, action.kind, why)
            return
        if set_for_later := SETTINGS.get(action.kind):
            set_for_later(action, scope, self._texts)
            return
        do = self._actions.get(action.kind)
        if do is None:
            known = sorted([*self._actions, *SETTINGS, *without.LEFT_OUT])
            advice = nearest(action.kind, known)
            raise ValueError(f"this action is not supported in the browser; {advice}")
        do(action, scope)

    def _holds(self, action: Action, scope: Scope) -> bool:
        """Return whether the conditions of an action hold."""
        for name, wanted in (("if", True), ("unless", False)):
            if name in action.attributes:
                text = self._texts.text(action, name, scope).strip().lower()
                if text not in ("true", "1", "false", "0"):
                    raise ValueError(f"'{text}' is not a boolean; write 'true' or 'false'")
                if (text in ("true", "1")) is not wanted:
                    return False
        return True

    def _group(self, action: Action, scope: Scope) -> None:
        texts = self._texts
        flags = ("scoped", "forwarding")
        is_so = {key: texts.is_true(action, key, scope, default=True) for key in flags}
        kept = texts.pairs(action, "keep", scope)
        inner = scope.of_group(**is_so)
        inner.variables.update(kept)
        self._all([each for each in action.inside if each.kind != "keep"], inner)

    def _loop(self, action: Action, scope: Scope) -> None:
        """Evaluate the actions inside once for each value, or call the function with it."""
        for values in loops.rounds(action, scope, self._texts):
            if "number" in action.attributes:
                self._call(int(action.attributes["number"]), scope, values)
            else:
                given = {name: str(value) for name, value in values.items()}
                outer, scope.loop = scope.loop, {**scope.loop, **given}
                self._all(action.inside, scope)
                scope.loop = outer

    def _include(self, action: Action, scope: Scope) -> None:
        """Evaluate a file in the scope of this one: only groups have a scope of their own."""
        file = Path(self._texts.needed(action, "file", scope))
        for given in action.of_kind("arg", "let"):
            let(given, scope, self._texts)
        resolved = file.resolve() if file.is_absolute() else file
        if why := self._reader.absent.of(file):
            self._notes.add(action.location, action.kind, f"{why} {absent.LEFT_OUT}")
            return
        inner = replace(scope, file=resolved, depth=scope.depth + 1, calls=())
        self.file(inner, action.location)
        scope.restore(inner)

    def _function(self, action: Action, scope: Scope) -> None:
        self._call(int(action.attributes["number"]), scope, {})

    def _call(self, number: int, scope: Scope, given: Mapping[str, object]) -> None:
        """Evaluate what a function of a Python launch file describes."""
        outer = scope.calls
        state = dict(scope.variables), dict(scope.environment.changes)
        scope.calls = (*outer, python.Call(self._reading(), number, *state, given))
        try:
            self._all(self._read_python(scope, scope.file), scope)
        except UnreadableError as error:
            self._note(error.location, "launch", str(error))
        finally:
            scope.calls = outer

    def _node(self, action: Action, scope: Scope) -> None:
        package = self._texts.needed(action, "pkg", scope)
        executable = self._texts.needed(action, "exec", scope)
        if windows.known(package, executable) and package not in self._packages:
            self.events.handlers.skipped(action)
            texts, space = self._texts, scope.namespace
            words, remaps = texts.words(action, "args", scope), texts.remaps(action, scope)
            rules = texts.rules(action, scope, space)
            self.windows.append(Window(executable, words, remaps, rules, space, action.location))
            return
        if why := without.program(package, executable, self._packages):
            self.events.handlers.skipped(action)
            self._notes.add(action.location, action.kind, why)
            return
        if self._lacks(action, package):
            self.events.handlers.skipped(action)
            return
        for why in without.parts(action):
            self._notes.add(action.location, action.kind, why)
        start = self._container if package == containers.PACKAGE else self._started
        start(action, scope)

    def _lacks(self, action: Action, package: str) -> bool:
        """Return whether `action` needs a package that is published, but not here, and note it."""
        there = package in self._packages or package == containers.PACKAGE
        why = "" if there else self._reader.absent.note(package)
        if why:
            self._notes.add(action.location, action.kind, f"{why} {absent.LEFT_OUT}")
        return bool(why)

    def _managed(self, action: Action, scope: Scope) -> None:
        """Start a lifecycle node."""
        for name in ("name", "namespace"):
            self._texts.needed(action, name, scope)
        self._node(action, scope)

    def _load(self, action: Action, scope: Scope) -> None:
        if self.events.handlers.inside:
            self._notes.add(action.location, action.kind, without.LOADED)
        self._components.load(action, scope)

    def _process(self, action: Action, scope: Scope) -> None:
        """Start a program of the workspace that is given as a command line."""
        try:
            found = processes.program(self._texts.words(action, "cmd", scope), self._reader.folders)
        except (SubstitutionError, ValueError):
            found = None
        if found is None:
            self.events.handlers.skipped(action)
            self._notes.add(action.location, action.kind, without.OF_SYSTEM)
            return
        kept = {name: text for name, text in action.attributes.items() if name in OF_PROCESSES}
        words = {"pkg": found.package, "exec": found.executable, "args": shlex.join(found.words)}
        plain = replace(scope, namespace="", remaps={}, parameters=[])
        self._node(replace(action, kind="node", attributes={**kept, **words}), plain)

    def _started(self, action: Action, scope: Scope) -> Node:
        texts = self._texts
        executable = texts.needed(action, "exec", scope)
        own = texts.text(action, "name", scope)
        words = texts.words(action, "args", scope)
        ros = texts.words(action, "ros_args", scope)
        words += ["--ros-args", *ros, "--"] if ros else []
        if any(without.FACT.search(word) for word in words):
            self._notes.add(action.location, "args", without.NOT_YET)
            words = [without.FACT.sub("", word) for word in words]
        namespace = joined(scope.namespace, texts.text(action, "namespace", scope))
        package, rules = texts.needed(action, "pkg", scope), texts.rules(action, scope, namespace)
        if package == STATE_PUBLISHER and (found := texts.description(words, rules)):
            words, rules = words[1:], {**rules, **found}
        node = Node(
            name=free(own or executable, {node.name for node in self.nodes}),
            package=package,
            executable=executable,
            location=action.location,
            namespace=namespace,
            remap={**({"__node": own} if own else {}), **texts.remaps(action, scope)},
            parameters=rules,
            arguments=tuple(map(texts.on_page, words)),
            environment=self._environment(action, scope),
        )
        self.nodes.append(node)
        self.events.of_node(node, action, scope)
        return node

    def _environment(self, action: Action, scope: Scope) -> dict[str, str]:
        """Return the variables that the launch file sets for a node."""
        alone = "clean_env" in action.attributes
        own = self._texts.pairs(action, "env", scope)
        found = scope.environment.of_node(own, alone=alone)
        if without.DOMAIN in found:
            self._notes.add(action.location, action.kind, without.ONE_DOMAIN)
        return {name: self._texts.on_page(value) for name, value in found.items()}

    def _container(self, action: Action, scope: Scope) -> None:
        name = self._texts.needed(action, "exec", scope)
        if name not in containers.EXECUTORS:
            known = nearest(name, containers.EXECUTORS)
            raise ValueError(f"'{name}' is not a supported component container; {known}")
        self._components.contain(self._started(action, scope), action, scope)

    def finished(self) -> list[Node]:
        """Return the nodes, with all components loaded into their containers."""
        return self._components.finished(self.nodes)

    def _note(self, location: Location, key: str, message: str) -> None:
        self._problems.add(location, key, by_package(message))
