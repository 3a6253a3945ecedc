"""Read a Python launch file, which runs in a separate process."""

from __future__ import annotations

import json
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

from sitegen.errors import Location
from sitegen.launch import apart
from sitegen.launch.absent import Absent
from sitegen.launch.substitutions import SubstitutionError
from sitegen.launch.tree import Action, Exact, UnreadableError

DESCRIBE = Path(__file__).with_name("describe.py")
# Describing nodes takes a moment; a launch file that waits for something is not supported (s).
LIMIT = 20


class Call(NamedTuple):
    """A call of a function of a launch file, which is given by its number.

    `reading` is the number of the call, `variables` and `environment` are those at this point,
    `given` are its keyword arguments.
    """

    reading: int
    number: int
    variables: Mapping[str, str]
    environment: Mapping[str, str | None]
    given: Mapping[str, object]


@dataclass(frozen=True)
class Reader:
    """Reads Python launch files.

    `folders` are those of the packages of the workspace; the commands of a file read files in
    `roots`. Temporary files that it leaves for the nodes are in `made`. Packages that the workspace
    lacks become `absent`.
    """

    folders: Mapping[str, Path]
    roots: Collection[Path]
    made: Path
    absent: Absent

    def read(
        self,
        file: Path,
        calls: Sequence[Call] = (),
        reading: int = 0,
        environment: Mapping[str, str | None] = MappingProxyType({}),
    ) -> list[Action]:
        """Return the actions of a launch file, or those of the last function of `calls`.

        Their ids begin with the number `reading`, or that of the call. Each of `calls` is a
        function that the previous one created. The file sees the changes in `environment`.

        Raises: UnreadableError if the file fails.
        """
        return _action(file, self._run(file, calls, reading, environment)).inside

    def performed(
        self,
        file: Path,
        calls: Sequence[Call],
        number: int,
        variables: Mapping[str, str],
        environment: Mapping[str, str | None],
    ) -> str:
        """Return the value of a substitution that the file defines itself, by its number.

        Raises: UnreadableError if the file fails, SubstitutionError if the substitution does.
        """
        answer = self._run(file, calls, 0, environment, (number, variables, environment))
        if "substitution" in answer:
            raise SubstitutionError(answer["substitution"].replace("\n", " "))
        return str(answer["text"])

    def _run(
        self,
        file: Path,
        calls: Sequence[Call],
        reading: int,
        environment: Mapping[str, str | None],
        performed: Sequence[object] | None = None,
    ) -> dict[str, Any]:
        given = {
            "folders": {name: str(path) for name, path in self.folders.items()},
            "absent": {name: str(path) for name, path in self.absent.folders.items()},
            "roots": [*map(str, self.roots)],
            "made": str(self.made),
            "calls": calls,
            "reading": reading,
            "environment": dict(environment),
            "performed": performed,
        }
        answer = self._answer(file, given)
        first = answer
        # A file that handles the exception needs no folder, so that one is given only now.
        while answer.get("absent", "") not in {"", *self.absent.folders}:
            if not self.absent.folder(answer["absent"]):
                break
            absent = {name: str(path) for name, path in self.absent.folders.items()}
            answer = self._answer(file, {**given, "absent": absent})
        if "error" in answer:
            if why := self.absent.named(answer["error"]):
                answer = {**first, "error": why}
            elif answer["module"] and (why := self.absent.note(answer["module"])):
                answer["error"] = why
            said = answer["error"].replace("\n", " ")
            raise UnreadableError(Location(file, answer["line"]), said)
        return answer

    def _answer(self, file: Path, given: Mapping[str, Any]) -> dict[str, Any]:
        try:
            done = apart.run(DESCRIBE, [str(file)], json.dumps(given, default=str), LIMIT)
        except TimeoutError:
            raise UnreadableError(
                Location(file, 1), f"the launch file took longer than {LIMIT} s"
            ) from None
        try:
            answer: dict[str, Any] = json.loads(done.stdout)
        except ValueError:
            raise UnreadableError(
                Location(file, 1), "the launch file exited before it described anything"
            ) from None
        return answer


def _action(file: Path, given: Mapping[str, Any]) -> Action:
    inside = [_action(file, each) for each in given["inside"]]
    attributes, location = dict(given["attributes"]), Location(file, given["line"])
    return Action(given["kind"], attributes, location, inside, _value(given["value"]), given["id"])


def _value(given: Any) -> Any:
    if isinstance(given, list):
        return [_value(item) for item in given]
    return Exact(given["string"]) if isinstance(given, dict) else given
