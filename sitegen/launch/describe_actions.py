"""Actions and substitutions of Python launch files, which record themselves."""

from __future__ import annotations

import traceback
from collections.abc import Iterable, Mapping
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from sitegen.launch import commandline, without
from sitegen.launch.environment import Environment
from sitegen.launch.substitutions import Known, SubstitutionError, expand
from sitegen.launch.tree import REFERENCE
from sitegen.launch.xacro import printed

# The launch file that runs, the line of the action whose function runs, the folders of the
# packages and of absent ones, the folders that may be read, the number of this reading with that
# of its actions, and the substitutions that it defines itself.
RUN = SimpleNamespace(
    file="",
    line=1,
    folders={},
    absent={},
    roots=[],
    reading=0,
    made=0,
    substitutions=[],
)


# The names of types in launch files, by those of Python.
TYPES = {
    "None": "yaml",
    **{str(kind): kind.__name__ for kind in (bool, int, float, str)},
    **{
        f"{form}[{kind.__name__}]": f"list_of_{kind.__name__}"
        for kind in (bool, int, float, str)
        for form in ("list", "typing.List")
    },
}


# The options of processes that make no difference on a page.
OF_PROCESSES = {
    *("cached_output", "emulate_tty", "exec_name", "log_cmd", "output", "output_format"),
    *("shell", "sigkill_timeout", "sigterm_timeout"),
}


class Text:
    """A substitution, written as in an XML launch file."""

    def __init__(self, text: str) -> None:
        self.text = text

    def __truediv__(self, part: Any) -> Text:
        return Text(f"{self.written()}/{text(part)}")

    def written(self) -> str:
        """Return the substitution as a text that is expanded later."""
        return self.text

    def perform(self, context: Context) -> str:
        """Return the value of the substitution."""
        return context.perform_substitution(self)


class Folder(Text):
    """The folder of a package; launch files may need its path while they run."""

    def find(self, package: str) -> str:
        """Return the share folder of a package of the workspace."""
        return share(package)


class Valued:
    """The value of a parameter with the name of its type in launch files."""

    def __init__(self, value: Any, *, value_type: Any = None) -> None:
        self.value = value
        self.type = TYPES.get(str(value_type), f"{value_type}")


class Described:
    """An action in the form of sitegen/launch/tree.py."""

    def __init__(
        self, kind: str, inside: Iterable[Any] = (), *, given: Any = None, **attributes: Any
    ) -> None:
        self.kind = kind
        self.given = given
        RUN.made += 1
        self.id = f"{REFERENCE}{RUN.reading}.{RUN.made}"
        self.inside = list(inside)
        condition = attributes.pop("condition", None)
        given = {name: value for name, value in attributes.items() if value is not None}
        self.attributes = {name: text(value) for name, value in given.items()}
        if isinstance(condition, Condition):
            self.attributes[condition.name] = text(condition.value)
        elif condition is not None:
            self.kind = f"condition {type(condition).__name__}"
        frames = traceback.extract_stack()
        lines = (frame.lineno for frame in reversed(frames) if frame.filename == RUN.file)
        self.line: int = next(lines, None) or 1

    def add_action(self, action: Any) -> None:
        """Add an action to the description."""
        self.inside.append(action)

    add_entity = add_action

    def plain(self) -> dict[str, Any]:
        """Return it as a value for JSON."""
        inside = [
            each.plain() if isinstance(each, Described) else unknown(each) for each in self.inside
        ]
        return {
            "kind": self.kind,
            "attributes": self.attributes,
            "line": self.line,
            "inside": inside,
            "value": self.given,
            "id": self.id,
        }


class Condition:
    """A condition: a text that must be true, or false."""

    def __init__(self, name: str, value: Any) -> None:
        self.name, self.value = name, value

    def evaluate(self, context: Context) -> bool:
        """Return whether the condition holds."""
        value = context.perform_substitution(Text(text(self.value))).strip().lower()
        return (value in ("true", "1")) == (self.name == "if")


class Context:
    """The launch arguments, as functions of launch files read them."""

    def __init__(
        self,
        variables: Mapping[str, str] | None = None,
        environment: Mapping[str, str | None] | None = None,
    ) -> None:
        self.launch_configurations = dict(variables or {})
        self._given = dict(environment or {})
        self.environment = {name: value for name, value in self._given.items() if value is not None}

    def perform_substitution(self, given: Any) -> str:
        """Return the text with its substitutions expanded."""

        def folder(package: str) -> Path:
            try:
                return Path(share(package))
            except LookupError as error:
                raise SubstitutionError(str(error)) from None

        def output(line: str) -> str:
            folders = {name: Path(path) for name, path in RUN.folders.items()}
            return printed(line, folders, [*map(Path, RUN.roots)])

        environment = Environment({**self._given, **self.environment})
        known = Known(Path(RUN.file), self.launch_configurations, environment)
        return expand(text(given), known, folder, output, self.performed)

    def performed(self, number: int) -> str:
        """Return the value of a substitution that the file defines itself.

        Raises: SubstitutionError if that fails.
        """
        made = RUN.substitutions[number]
        try:
            value = made.perform(self)
        except SubstitutionError as error:
            raise SubstitutionError(f"{type(made).__name__}: {error}") from None
        except Exception as error:
            name = type(error).__name__
            raise SubstitutionError(f"{type(made).__name__}: {name}: {error}") from error
        if not isinstance(value, str):
            kind = type(value).__name__
            raise SubstitutionError(f"{type(made).__name__}: perform() returned {kind}, not str")
        return value


def unknown(action: Any) -> Described:
    """Return a stand-in for an unsupported feature, which keeps its name for the message."""
    return Described(type(action).__name__)


def text(value: Any) -> str:
    """Return the text of a string, a substitution, or a list of both."""
    if isinstance(value, Text):
        return value.written()
    if isinstance(value, (list, tuple)):
        return "".join(text(part) for part in value)
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (str, int, float, Path)):
        return str(value)
    raise TypeError(f"{type(value).__name__} is not supported in the browser")


def exact(value: Any) -> Any:
    """Return one value of ParameterValue for JSON: a substitution is a text."""
    if isinstance(value, (bool, int, float)):
        return value
    return {"string": value} if isinstance(value, str) else text(value)


def valued(value: Any) -> Any:
    """Return the value of ParameterValue for JSON."""
    if not isinstance(value, (list, tuple)) or _is_one_text(value):
        return exact(value)
    if any(isinstance(part, float) for part in value):
        value = [float(part) if type(part) is int else part for part in value]
    for part in value:
        if isinstance(part, (list, tuple)) and not _is_one_text(part):
            raise TypeError(f"{part} is neither a scalar nor a substitution")
    return [exact(part) for part in value]


def mapped(value: Any) -> Any:
    """Return a value of a mapping of parameters for JSON."""
    if not isinstance(value, (list, tuple)) or _is_one_text(value):
        return exact(value)
    kinds = {type(part) for part in value}
    if kinds == {int, float}:
        return [float(part) for part in value]
    # In a list of mixed types, launch_ros makes strings of the values and reads them again.
    return [exact(part) for part in value]


def _is_one_text(value: Iterable[Any]) -> bool:
    """Return whether a list of substitutions and strings is one text, as in launch."""
    parts = list(value)
    return any(isinstance(part, Text) for part in parts) and all(
        isinstance(part, (Text, str)) for part in parts
    )


class PackageNotFoundError(KeyError):
    """The workspace has no such package."""

    @property
    def package(self) -> str:
        """The name of the package."""
        return str(self.args[0])

    def __str__(self) -> str:
        return f"no package '{self.package}' in the workspace"


def share(package: str, *_: Any) -> str:
    """Return the share folder of a package of the workspace."""
    folder = RUN.folders.get(package) or RUN.absent.get(package)
    if folder is None:
        raise PackageNotFoundError(package)
    return str(folder)


def parameters(given: Iterable[Any]) -> list[Described]:
    """Return the parameters of a node: values by name, or files."""
    found: list[Described] = []
    for each in given:
        if isinstance(each, Mapping):
            found += values("", each)
        elif isinstance(each, Described):
            found.append(each)
        else:
            found.append(Described("param", **{"from": each}))
    return found


def values(above: str, given: Mapping[Any, Any]) -> Iterable[Described]:
    """Yield a parameter for each value; names in nested mappings are joined with dots."""
    for name, value in given.items():
        if isinstance(value, Mapping):
            yield from values(f"{above}{text(name)}.", value)
        elif isinstance(value, Valued):
            yield parameter(f"{above}{text(name)}", value.value, value_type=value.type)
        else:
            yield Described("parameter", name=f"{above}{text(name)}", given=mapped(value))


def parameter(name: Any, value: Any, *, value_type: Any = None) -> Described:
    """Stand in for Parameter, a parameter whose value has a type."""
    kind = TYPES.get(str(value_type), str(value_type))
    given = valued(value)
    found = {type(item).__name__ for item in given} if isinstance(given, list) else set()
    if kind.startswith("list_of_") and found & {"bool", "int", "float"} - {kind[8:]}:
        raise TypeError(f"expected a list of '{kind[8:]}', found {' and '.join(sorted(found))}")
    return Described("param", name=name, type=kind, given=given)


def node(
    *_: Any,
    package: Any = None,
    executable: Any = None,
    node_executable: Any = None,
    name: Any = None,
    node_name: Any = None,
    namespace: Any = None,
    node_namespace: Any = None,
    parameters: Iterable[Any] | None = None,
    remappings: Iterable[tuple[Any, Any]] | None = None,
    arguments: Iterable[Any] | None = None,
    ros_arguments: Iterable[Any] | None = None,
    on_exit: Any = None,
    condition: Any = None,
    additional_env: Mapping[Any, Any] | None = None,
    env: Mapping[Any, Any] | None = None,
    respawn: Any = None,
    respawn_delay: Any = None,
    respawn_max_retries: Any = None,
    prefix: Any = None,
    cwd: Any = None,
    **others: Any,
) -> Described:
    """Describe a node; options that affect only its process or its output are ignored."""
    for option in others.keys() - OF_PROCESSES:
        raise TypeError(f"Node() got an unexpected keyword argument '{option}'")
    inside = _parameters(parameters or ())
    inside += [*variables(env, additional_env), *ending(on_exit)]
    for old, new in remappings or ():
        inside.append(Described("remap", **{"from": old, "to": new}))
    words = {"args": arguments, "ros_args": ros_arguments}
    lines = {
        key: commandline.join(text(word) for word in given) for key, given in words.items() if given
    }
    return Described(
        "node",
        inside,
        pkg=package,
        exec=executable if executable is not None else node_executable,
        name=name if name is not None else node_name,
        namespace=namespace if namespace is not None else node_namespace,
        respawn=respawn,
        respawn_delay=respawn_delay,
        respawn_max_retries=respawn_max_retries,
        launch_prefix=prefix,
        cwd=cwd,
        condition=condition,
        clean_env=None if env is None else True,
        **lines,
    )


_parameters = parameters


def ending(on_exit: Any) -> list[Described]:
    """Describe what is done when a process ends."""
    if on_exit is None:
        return []
    why = without.FUNCTION if is_function(on_exit) else None
    return [Described("on_exit", [] if why else inside_of(on_exit), why=why)]


def is_function(given: Any) -> bool:
    """Return whether an event calls a function, which is gone when the page is open."""
    return callable(given) and not isinstance(given, Described)


def inside_of(actions: Any) -> list[Any]:
    """Return one action, or several, as a list."""
    return list(actions) if isinstance(actions, (list, tuple)) else [actions]


def variables(*given: Mapping[Any, Any] | None) -> list[Described]:
    """Describe environment variables of a process; later ones replace earlier ones."""
    merged = {text(name): value for each in given for name, value in (each or {}).items()}
    return pairs("env", merged.items())


def pairs(kind: str, given: Iterable[tuple[Any, Any]]) -> list[Described]:
    """Describe parts of an action, or actions, that have a name and a value."""
    return [Described(kind, name=name, value=value) for name, value in given]


def managed(*, name: Any, namespace: Any, autostart: Any = False, **of: Any) -> Described:
    """Describe a lifecycle node, whose name and namespace are required."""
    described = node(name=name, namespace=namespace, **of)
    described.kind = "lifecycle_node"
    described.attributes["autostart"] = text(autostart)
    return described


def describe(initial_entities: Iterable[Any] | None = None, *_: Any, **__: Any) -> Described:
    """Stand in for LaunchDescription."""
    return Described("launch", initial_entities or ())
