"""Stand-ins for names of launch that sitegen does not have: each costs its use, not the file."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Any

from sitegen.launch.describe_actions import Described, Text


class _Class(type):
    def __getattr__(cls, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return cls()


class Missing(Described, Text, metaclass=_Class):
    """An action, a substitution or a condition that is not supported; the name says which."""

    def __init__(self, *_: Any, **__: Any) -> None:
        Described.__init__(self, type(self).__name__)
        self.text = f"$({type(self).__name__})"

    def __call__(self, *_: Any, **__: Any) -> Missing:
        """Stand in for what its methods and functions return."""
        return self

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return self


def stand_in(name: str) -> Any:
    """Return a class in place of a name that a module does not have."""
    if name.startswith("__"):
        raise AttributeError(name)
    if name.endswith(("Error", "Failure")):
        return type(name, (Exception,), {})
    return _Class(name, (Missing,), {})


class Finder(MetaPathFinder, Loader):
    """Finds the modules below those of launch that sitegen does not have."""

    def __init__(self, tops: Sequence[str]) -> None:
        self._tops = tops

    def find_spec(self, name: str, *_: Any) -> ModuleSpec | None:
        """Return how a module is loaded."""
        is_ours = name.startswith(tuple(f"{top}." for top in self._tops))
        return ModuleSpec(name, self, is_package=True) if is_ours else None

    def create_module(self, _: ModuleSpec) -> None:
        """Leave it to Python to create the module."""

    def exec_module(self, module: ModuleType) -> None:
        """Give a module all names: those of the module above it, which has the same in upstream."""
        above = vars(sys.modules[module.__name__.rpartition(".")[0]])
        names = {name: value for name, value in above.items() if not name.startswith("__")}
        vars(module).update(names, __getattr__=stand_in)


def install(modules: Sequence[str]) -> None:
    """Give these modules, and modules below them, stand-ins for what they do not have."""
    for name in modules:
        sys.modules[name].__getattr__ = stand_in  # type: ignore[method-assign]
    sys.meta_path.append(Finder([name for name in modules if "." not in name]))
