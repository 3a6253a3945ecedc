"""The texts of actions: attributes, command lines and parameters, with substitutions expanded."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path

from sitegen.errors import nearest
from sitegen.launch import commandline, xacro
from sitegen.launch.parameters import Parameters
from sitegen.launch.python import Reader
from sitegen.launch.scope import Scope
from sitegen.launch.shares import on_page
from sitegen.launch.substitutions import Known, SubstitutionError, expand
from sitegen.launch.tree import Action, UnreadableError
from sitegen.launch.types import typed
from sitegen.model import Argument
from sitegen.rclyaml import Overrides, written
from sitegen.workspace import parameterfiles

# The parameter of robot_state_publisher, which needs it.
DESCRIPTION = "robot_description"


class Texts:
    """Reads the attributes and parts of actions.

    `reader` knows the folders of the packages and those that may be read; parameter files are below
    `root`, or made by the launch file.
    """

    def __init__(self, reader: Reader, root: Path) -> None:
        self._reader = reader
        self._folders, self._roots = reader.folders, reader.roots
        self._root = root
        # The values of substitutions that a file defines itself, by what they depend on.
        self._performed: dict[str, str] = {}
        # The arguments that were declared, by name.
        self.declared: dict[str, Argument] = {}

    def text(self, action: Action, name: str, scope: Scope) -> str:
        """Return the value of an attribute, "" if it is missing.

        Raises: SubstitutionError or ValueError, as do the other methods.
        """
        return self.expanded(action.attributes.get(name, ""), scope)

    def needed(self, action: Action, name: str, scope: Scope) -> str:
        """Return the value of an attribute that must not be missing."""
        if name not in action.attributes:
            raise ValueError(f"'{name}' is missing")
        return self.text(action, name, scope)

    def is_true(self, action: Action, name: str, scope: Scope, *, default: bool = False) -> bool:
        """Return the value of an attribute that is a boolean."""
        text = self.text(action, name, scope)
        return bool(typed(text, "bool")) if text else default

    def pairs(self, action: Action, kind: str, scope: Scope) -> dict[str, str]:
        """Return the names and values of the parts of a kind."""
        return {
            self.needed(each, "name", scope): self.needed(each, "value", scope)
            for each in action.of_kind(kind)
        }

    def remaps(self, action: Action, scope: Scope) -> dict[str, str]:
        """Return the remapping rules of a node; of two for one name, the first counts."""
        remaps = dict(scope.remaps)
        for remap in action.of_kind("remap"):
            remaps.setdefault(*(self.needed(remap, key, scope) for key in ("from", "to")))
        return remaps

    def rules(self, action: Action, scope: Scope, namespace: str) -> dict[str, str]:
        """Return the parameter rules of a node or a component."""
        name = self.text(action, "name", scope)
        full = f"{namespace.removesuffix('/')}/{name}" if namespace and name else ""
        parameters, everyones = self.parameters(scope), scope.parameters
        if action.kind == "composable_node":
            rules = parameters.of_component(action, everyones, f"{namespace}/{name}")
        else:
            rules = parameters.of_node(action, everyones, full)
        return {name: self.on_page(value) for name, value in rules.items()}

    def parameters(self, scope: Scope) -> Parameters:
        """Return the reader of the parameters of actions."""
        return Parameters(
            lambda text: self.expanded(text, scope),
            lambda text: self._expanded(text, scope, escapes=True),
            self.file,
        )

    def words(self, action: Action, name: str, scope: Scope) -> list[str]:
        """Return a command line with the contents of parameter files in place of the files."""
        found: list[str] = []
        line = action.attributes.get(name, "")
        expand = partial(self.expanded, scope=scope)
        waiting = iter(commandline.split(line, expand, escapes=not scope.is_python))
        for word in waiting:
            if word != parameterfiles.OPTION:
                found.append(word)
                continue
            given = Overrides()
            parameterfiles.add(given, self.file(next(waiting, "")))
            for name, value in parameterfiles.rules(given).items():
                found += ["-p", f"{name}:={value}"]
        return found

    def file(self, name: str) -> Path:
        """Return a parameter file."""
        file = Path(name)
        if why := self._reader.absent.of(file):
            raise ValueError(why)
        folders = (self._root, self._reader.made)
        if not any(map(file.resolve().is_relative_to, folders)) or not file.is_file():
            raise ValueError(f"no file '{file}' below the folder of site.yaml")
        return file

    def description(self, words: Sequence[str], rules: Mapping[str, str]) -> dict[str, str]:
        """Return the parameter of a robot_state_publisher whose description is a file.

        It is the first argument, which counts only if the parameter is missing.
        """
        file = Path(words[0]) if words else Path()
        if DESCRIPTION in rules or not file.is_file():
            return {}
        if not any(file.resolve().is_relative_to(root.resolve()) for root in self._roots):
            raise ValueError(f"'{file}' is outside the workspace")
        text = self.on_page(xacro.description(file, self._folders))
        return {DESCRIPTION: written(text)}

    def on_page(self, text: str) -> str:
        """Return a text with the paths that the page has."""
        if str(self._reader.made) in text:
            raise ValueError("the page has a file that a launch file writes only as parameters")
        return on_page(text, self._folders)

    def expanded(self, text: str, scope: Scope) -> str:
        """Return a text with its substitutions expanded."""
        return self._expanded(text, scope, escapes=not scope.is_python)

    def _expanded(self, text: str, scope: Scope, *, escapes: bool) -> str:
        known = Known(
            file=scope.file,
            variables=scope.variables,
            environment=scope.environment,
            loop=scope.loop,
            parameters=scope.parameters,
        )
        run = partial(xacro.printed, folders=self._folders, roots=self._roots)
        performed = partial(self._perform, scope) if scope.is_python else None
        return expand(text, known, self._share, run, performed, escapes=escapes)

    def _perform(self, scope: Scope, number: int) -> str:
        """Return the value of a substitution that a Python file defines itself."""
        changes = dict(scope.environment.changes)
        given = (scope.file, scope.calls, number, dict(scope.variables), changes)
        key = repr(given)
        if key not in self._performed:
            try:
                self._performed[key] = self._reader.performed(*given)
            except UnreadableError as error:
                raise SubstitutionError(str(error)) from None
        return self._performed[key]

    def _share(self, package: str) -> Path:
        found = self._folders.get(package) or self._reader.absent.folder(package)
        if found is None:
            advice = nearest(package, self._folders)
            raise SubstitutionError(f"no package '{package}' in the workspace; {advice}")
        return found
