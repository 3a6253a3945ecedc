"""Evaluate the expressions of a setup.py."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

from sitegen.workspace import setupnames, setupvalues
from sitegen.workspace.setupvalues import CHANGING, PLAIN, Unknown, items, spoil, unknown_in

STEPS, DEEPEST = 200_000, 60
# Attributes of paths.
PATH = {"name", "stem", "suffix", "parent", "parts"}
# The names that a function declares as global, in its scope; no variable is called like this.
GLOBAL = "global"


class StopError(Exception):
    """setup() is not reached because of what the message says; `line` is its location."""

    def __init__(self, line: int, message: str) -> None:
        super().__init__(message)
        self.line = line


class SetupCall(Exception):
    """setup() is called with these arguments."""

    def __init__(self, arguments: Mapping[str, Any]) -> None:
        super().__init__()
        self.arguments = arguments


@dataclass(frozen=True)
class Module:
    """A module of which something is known, by its full name."""

    name: str


class Function:
    """A function of the script, called by the script itself and by functions like sorted().

    `body` returns its result in the scope of the call.
    """

    def __init__(
        self, inside: Evaluator, node: ast.FunctionDef | ast.Lambda, body: Callable[[], Any]
    ) -> None:
        self.node = node
        self._inside, self._scopes, self._body = inside, inside.scopes, body
        # As in Python, defaults are evaluated once.
        self._defaults = [inside.value(each) for each in node.args.defaults]
        self._named = [each and inside.value(each) for each in node.args.kw_defaults]

    def __call__(self, *given: Any, **named: Any) -> Any:
        """Return the result for these arguments.

        Raises: TypeError if an argument is missing.
        """
        arguments = self.node.args
        names = [each.arg for each in (*arguments.posonlyargs, *arguments.args)]
        only = [each.arg for each in arguments.kwonlyargs]
        after = names[len(names) - len(self._defaults) :]
        scope: dict[str, Any] = dict(zip(after, self._defaults, strict=True))
        scope |= {n: v for n, v in zip(only, self._named, strict=True) if v is not None}
        scope |= dict(zip(names, given, strict=False))
        known = {name: value for name, value in named.items() if name in (*names, *only)}
        scope |= known
        if any(name not in scope for name in (*names, *only)):
            raise TypeError
        if arguments.vararg:
            scope[arguments.vararg.arg] = given[len(names) :]
        if arguments.kwarg:
            scope[arguments.kwarg.arg] = {k: v for k, v in named.items() if k not in known}
        with self._inside.within([*self._scopes, scope]):
            return self._body()


class Evaluator:
    """The scopes of a script, the innermost of which is the last one, and what names mean."""

    def __init__(self, folder: Path, limit: Path) -> None:
        self._files = setupnames.Files(folder, limit)
        self._modules = setupnames.modules(self._files)
        self.scopes: list[dict[str, Any]] = [setupnames.builtins(self._files), {}]
        self._steps = self._depth = 0
        # The number of unknown values so far, and the last one.
        self.unknowns = 0
        self.last = Unknown(ast.Constant(None))

    @contextmanager
    def within(self, scopes: list[dict[str, Any]]) -> Iterator[None]:
        """Evaluate in other scopes."""
        before, self.scopes = self.scopes, scopes
        self._depth += 1
        try:
            if self._depth > DEEPEST:
                raise RecursionError
            yield
        finally:
            self._depth -= 1
            self.scopes = before

    def step(self) -> None:
        """Count a step of the evaluation, which must end."""
        self._steps += 1
        if self._steps > STEPS:
            raise StopError(1, "setup.py takes too long to evaluate; simplify it")

    def unknown(self, node: ast.AST) -> Unknown:
        """Return the unknown value of `node`."""
        self.unknowns += 1
        self.last = Unknown(node)
        return self.last

    def lookup(self, name: str) -> Any:
        """Return the value of a name; None if there is none."""
        return next((scope[name] for scope in reversed(self.scopes) if name in scope), None)

    def imported(self, name: str, node: ast.AST) -> Any:
        """Return what the import of a full name brings."""
        if name in self._modules:
            return self._modules[name]
        is_module = any(each.startswith(f"{name}.") for each in self._modules)
        return Module(name) if is_module else self.unknown(node)

    def items(self, node: ast.expr) -> Iterable[Any]:
        """Return what a loop goes through; of an unknown value, one unknown item."""
        value = self.value(node)
        return [value] if isinstance(value, Unknown) else items(value)

    def assign(self, target: ast.AST, value: Any) -> None:
        """Assign to names and items; attributes are ignored."""
        match target:
            case ast.Name():
                scope = self.scopes[-1]
                outer = target.id in scope.get(GLOBAL, ())
                (self.scopes[1] if outer else scope)[target.id] = value
            case ast.Tuple() | ast.List() if isinstance(value, Unknown):
                for each in target.elts:
                    self.assign(each, value)
            case ast.Tuple() | ast.List():
                self._unpack(target.elts, list(items(value)))
            case ast.Starred():
                self.assign(target.value, value)
            case ast.Subscript():
                into, key = self.value(target.value), self._key(target.slice)
                if isinstance(key, Unknown):
                    spoil(into, key)
                elif not isinstance(into, Unknown):
                    into[key] = value

    def _unpack(self, targets: Sequence[ast.expr], values: list[Any]) -> None:
        star = next((n for n, each in enumerate(targets) if isinstance(each, ast.Starred)), None)
        if star is not None:
            end = len(values) - (len(targets) - star - 1)
            values = [*values[:star], values[star:end], *values[end:]]
        for each, value in zip(targets, values, strict=True):
            self.assign(each, value)

    def value(self, node: ast.expr) -> Any:
        """Return the value of an expression, which may be `Unknown` or contain it.

        Raises: TypeError, ValueError and others as Python does.
        """
        self.step()
        match node:
            case ast.Constant():
                return node.value
            case ast.Name():
                found = self.lookup(node.id)
                there = found is not None or any(node.id in scope for scope in self.scopes)
                return found if there else self.unknown(node)
            case ast.List() | ast.Tuple() | ast.Set():
                kind = {ast.List: list, ast.Tuple: tuple, ast.Set: set}[type(node)]
                elements = self._elements(node.elts)
                unknown_in(elements if kind is set else [], self.step)
                return kind(elements)
            case ast.Dict():
                return self._dict(node)
            case ast.BinOp():
                return self.binary(node.op, self.value(node.left), self.value(node.right))
            case ast.BoolOp():
                return self._logical(node)
            case ast.UnaryOp():
                return self._unary(node)
            case ast.Compare():
                return self._compare(node)
            case ast.IfExp():
                test = self.value(node.test)
                if isinstance(test, Unknown):
                    return test
                return self.value(node.body if test else node.orelse)
            case ast.JoinedStr():
                return self._text(self.value(each) for each in node.values)
            case ast.FormattedValue(format_spec=None):
                return self.value(node.value)
            case ast.Subscript():
                return self._item(node)
            case ast.Attribute():
                return self._attribute(node)
            case ast.Call():
                return self._call(node)
            case ast.Lambda():
                return Function(self, node, lambda: self.value(node.body))
            case ast.NamedExpr():
                self.assign(node.target, value := self.value(node.value))
                return value
            case ast.ListComp() | ast.SetComp() | ast.GeneratorExp() | ast.DictComp():
                return self._comprehension(node)
        return self.unknown(node)

    def binary(self, operation: ast.operator, left: Any, right: Any) -> Any:
        """Return the result of a binary operation."""
        found = self._first_unknown(left, right)
        return setupvalues.binary(operation, left, right) if found is None else found

    def _first_unknown(self, *values: Any) -> Unknown | None:
        return next((each for each in values if isinstance(each, Unknown)), None)

    def _elements(self, nodes: Iterable[ast.expr]) -> list[Any]:
        elements: list[Any] = []
        for node in nodes:
            if isinstance(node, ast.Starred):
                elements += self.items(node.value)
            else:
                elements.append(self.value(node))
        return elements

    def _dict(self, node: ast.Dict) -> Any:
        found: dict[Any, Any] = {}
        for key, value in zip(node.keys, node.values, strict=True):
            given = self.value(value)
            if key is not None:
                found[self._key(key)] = given
            elif isinstance(given, Unknown):
                found[given] = given
            else:
                found |= given
        return found

    def _key(self, node: ast.expr) -> Any:
        """Return a key; the steps that are counted limit what it contains."""
        value = self.value(node)
        found = unknown_in(value, self.step)
        return value if found is None else found

    def _logical(self, node: ast.BoolOp) -> Any:
        value = None
        for each in node.values:
            value = self.value(each)
            if isinstance(value, Unknown) or bool(value) is isinstance(node.op, ast.Or):
                break
        return value

    def _unary(self, node: ast.UnaryOp) -> Any:
        value = self.value(node.operand)
        if isinstance(value, Unknown):
            return value
        return not value if isinstance(node.op, ast.Not) else -value

    def _compare(self, node: ast.Compare) -> Any:
        left = self.value(node.left)
        for operation, each in zip(node.ops, node.comparators, strict=True):
            right = self.value(each)
            found = unknown_in([left, right], self.step)
            if found is not None:
                return found
            if not setupvalues.COMPARE[type(operation)](left, right):
                return False
            left = right
        return True

    def _text(self, parts: Iterable[Any]) -> Any:
        values = list(parts)
        found = self._first_unknown(*values)
        if found is None and not all(isinstance(each, PLAIN) for each in values):
            raise TypeError
        return "".join(map(str, values)) if found is None else found

    def _item(self, node: ast.Subscript) -> Any:
        value = self.value(node.value)
        if isinstance(node.slice, ast.Slice):
            parts = (node.slice.lower, node.slice.upper, node.slice.step)
            key: Any = slice(*(each and self.value(each) for each in parts))
        else:
            key = self.value(node.slice)
        found = self._first_unknown(value, key)
        return value[key] if found is None else found

    def _attribute(self, node: ast.Attribute) -> Any:
        value = self.value(node.value)
        if isinstance(value, Module):
            return self.imported(f"{value.name}.{node.attr}", node)
        if value is PurePosixPath and node.attr == "cwd":
            return self._modules["pathlib.Path.cwd"]
        if isinstance(value, PurePosixPath) and node.attr in PATH:
            return getattr(value, node.attr)
        if isinstance(value, tuple) and node.attr in ("major", "minor"):
            return value[node.attr == "minor"]
        return value if isinstance(value, Unknown) else self.unknown(node)

    def _call(self, node: ast.Call) -> Any:
        receiver = self.value(node.func.value) if isinstance(node.func, ast.Attribute) else None
        function = self._function(node.func, receiver)
        given = self._elements(node.args)
        named: dict[Any, Any] = {}
        for keyword in node.keywords:
            value = self.value(keyword.value)
            if keyword.arg is not None:
                named[keyword.arg] = value
            elif isinstance(value, Unknown):
                named["**"] = value
            else:
                named |= value
        if function is setupnames.SETUP:
            raise SetupCall(named)
        changes = isinstance(node.func, ast.Attribute) and node.func.attr in CHANGING
        if isinstance(function, Unknown):
            function = self.unknown(node)
            for each in (receiver, *given, *named.values()):
                spoil(each, function)
            return function
        if isinstance(function, Function) and not isinstance(named.get("**"), Unknown):
            return function(*given, **named)
        found = unknown_in([given, named], self.step)
        if found is None or (changes and self._first_unknown(*given, *named.values()) is None):
            return function(*given, **named)
        if changes and node.func.attr == "append":  # type: ignore[attr-defined]
            return function(*given)
        spoil(receiver, found)
        return found

    def _function(self, node: ast.expr, receiver: Any) -> Any:
        """Return what is called; `receiver` is the object of a method."""
        if not isinstance(node, ast.Attribute) or isinstance(receiver, Module | Unknown):
            found = self._attribute(node) if isinstance(node, ast.Attribute) else self.value(node)
            return found if callable(found) or found is setupnames.SETUP else self.unknown(node)
        if isinstance(receiver, PurePosixPath):
            return self._files.path_method(receiver, node.attr)
        if isinstance(receiver, type) or callable(receiver):
            # Functions of functions and types: chain.from_iterable(), Path.cwd().
            for name, value in self._modules.items():
                if value is receiver and f"{name}.{node.attr}" in self._modules:
                    return self._modules[f"{name}.{node.attr}"]
            return self.unknown(node)
        return setupvalues.method(receiver, node.attr)

    def _comprehension(
        self, node: ast.ListComp | ast.SetComp | ast.GeneratorExp | ast.DictComp
    ) -> Any:
        found: list[Any] = []
        with self.within([*self.scopes, {}]):
            for unknown in self._rounds(node.generators):
                if unknown is not None:
                    found.append((unknown, unknown) if isinstance(node, ast.DictComp) else unknown)
                elif isinstance(node, ast.DictComp):
                    found.append((self.value(node.key), self.value(node.value)))
                else:
                    found.append(self.value(node.elt))
        if isinstance(node, ast.DictComp):
            return dict(found)
        return set(found) if isinstance(node, ast.SetComp) else found

    def _rounds(self, generators: Sequence[ast.comprehension]) -> Iterator[Unknown | None]:
        """Yield for each element of a comprehension; a value if it is not known whether it is."""
        if not generators:
            yield None
            return
        first, *rest = generators
        for item in self.items(first.iter):
            if isinstance(item, Unknown):
                yield item
                continue
            self.assign(first.target, item)
            tests = [self.value(test) for test in first.ifs]
            unknown = self._first_unknown(*tests)
            if unknown is not None:
                yield unknown
            elif all(tests):
                yield from self._rounds(rest)
