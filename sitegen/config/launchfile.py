"""Read the launch file of a page."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from itertools import islice
from pathlib import Path

from sitegen import workspace
from sitegen.config.commandlines import KIND as TERMINAL
from sitegen.config.document import Value
from sitegen.config.files import locate
from sitegen.config.nodes import Declared, check_package
from sitegen.config.section import Section
from sitegen.errors import Problems
from sitegen.launch import LaunchDescription, launched, share_path
from sitegen.launch.names import free
from sitegen.model import Argument, Launch, Node, Package, Part, Widget, leaves

BOOLEANS = {"true": "false", "false": "true"}
# It is read for each value of each argument, up to this number.
MOST_READINGS = 20


class LaunchFile:
    """The launch file that a section names, if it does, and what it describes."""

    def __init__(
        self,
        section: Section,
        environment: Value | None,
        folder: Path,
        packages: Callable[[], Mapping[str, Package]],
        problems: Problems,
        notes: Problems,
    ) -> None:
        self._given = section.get("launch")
        self._file = locate(self._given, problems, page=folder) if self._given else None
        self._workspace = packages
        self._problems = problems
        arguments = section.get("launch_arguments")
        self._arguments = arguments.texts(problems) if arguments else {}
        self._environment = environment.texts(problems) if environment else {}
        self.described = LaunchDescription()
        if self._file:
            self.described = self._read(self._arguments, problems, notes)
        elif environment and not self._given:
            message = "needs 'launch'; a node has an 'environment' of its own"
            problems.add(environment.location, environment.key, message)

    def started(self, taken: Mapping[str, Declared]) -> dict[str, Declared]:
        """Return the nodes that it starts, whose names must not be `taken`."""
        for node in self.described.nodes:
            if node.name in taken and self._given:
                what = f"'{node.name}', which '{self._given.text}' starts,"
                message = f"{what} is also a node in site.yaml; rename one of them"
                self._problems.add(self._given.location, self._given.key, message)
        return {node.name: Declared(node, None) for node in self.described.nodes}

    def others(self, parts: Iterable[Part], taken: Mapping[str, Node]) -> dict[str, Declared]:
        """Return a node for each program that it starts only if an argument is another one.

        Visitors of a page with a terminal can launch it with such arguments. What is wrong with it
        then is told to who tries it, as is a program that a page cannot have.
        """
        kinds = {part.kind for part in leaves(parts) if isinstance(part, Widget)}
        if not self._file or TERMINAL not in kinds:
            return {}
        found: dict[str, Declared] = {}
        known = {node.program for node in self.described.nodes}
        packages = self._packages()
        for name, value in islice(self._values(), MOST_READINGS):
            quiet = Problems(self._problems.root)
            for node in self._read({**self._arguments, name: value}, quiet, quiet).nodes:
                if node.program not in known and _runs(node, packages):
                    known.add(node.program)
                    own = free(node.name, {*taken, *found})
                    found[own] = Declared(replace(node, name=own), None)
        return found

    def launch(self, others: Iterable[str]) -> Launch | None:
        """Return it by its package; `others` are the names of the nodes that `others()` returns."""
        file = self._file
        if not file:
            return None
        owners = (each for each in self._workspace().values() if file.is_relative_to(each.path))
        owner = next(owners, None)
        return Launch(
            package=owner.name if owner else "",
            file=file.name,
            nodes=tuple(node.name for node in self.described.nodes),
            handlers=tuple(self.described.handlers),
            arguments=tuple(self.described.arguments),
            given=self._arguments,
            environment=self._environment,
            path=share_path(file, owner) if owner else "",
            others=tuple(others),
        )

    def _read(
        self, arguments: Mapping[str, str], problems: Problems, notes: Problems
    ) -> LaunchDescription:
        assert self._file
        packages, environment = self._packages(), self._environment
        return launched(self._file, arguments, packages, problems, notes, environment)

    def _values(self) -> Iterable[tuple[str, str]]:
        for argument in self.described.arguments:
            value = self._arguments.get(argument.name, argument.default or "")
            yield from ((argument.name, other) for other in _other_values(argument, value))

    def _packages(self) -> Mapping[str, Package]:
        return {**workspace.shipped_packages(), **workspace.with_replaced(self._workspace())}


def _other_values(argument: Argument, value: str) -> Sequence[str]:
    """Return the values of an argument that may change which nodes start, without `value`."""
    opposite = BOOLEANS.get(value.lower())
    choices = argument.choices or ((opposite,) if opposite else ())
    return [choice for choice in choices if choice != value]


def _runs(node: Node, packages: Mapping[str, Package]) -> bool:
    problems = Problems(Path())
    check_package(Declared(node, None), workspace.with_shipped(packages, [node.package]), problems)
    return not problems.found
