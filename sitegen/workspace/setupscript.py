"""Evaluate a setup.py without running it, statement by statement, up to its call of setup()."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterable, Sequence
from pathlib import Path
from typing import Any

from sitegen.workspace import setupnames, setupvalues
from sitegen.workspace.setupexpressions import GLOBAL, Evaluator, Function, SetupCall, StopError
from sitegen.workspace.setupvalues import Unknown, items, spoil, unknown_in

# What an operation raises that a value does not have, or that is not allowed here.
FAILURES = (
    *(TypeError, ValueError, LookupError, AttributeError, ArithmeticError, OSError),
    *(NotImplementedError, RuntimeError, StopIteration),
)


ADVICE = "write the values out, or move them to setup.cfg"


class _BreakError(Exception):
    pass


class _ContinueError(Exception):
    pass


class _LeftError(Exception):
    """A statement that is not run could end the loop, its round, or the function around it."""

    def __init__(self, unknown: Unknown) -> None:
        super().__init__()
        self.unknown = unknown


class _ReturnError(Exception):
    def __init__(self, value: Any) -> None:
        super().__init__()
        self.value = value


def arguments(
    tree: ast.Module, folder: Path, limit: Path, wanted: Collection[str]
) -> dict[str, Any]:
    """Return those `wanted` of the arguments of setup() in the setup.py of `folder`.

    It reads below `limit`.

    Raises: StopError if the call is not reached, or an argument cannot be evaluated.
    """
    script = _Script(Evaluator(folder, limit))
    try:
        script.run(tree.body)
    except SetupCall as call:
        given = {name: call.arguments[name] for name in wanted if name in call.arguments}
        for name, value in given.items():
            unknown = unknown_in(value, script.evaluator.step)
            if unknown is not None:
                what = f"{name}: sitegen does not evaluate '{unknown.text}'"
                raise StopError(unknown.line, f"{what}; {ADVICE}") from None
        return given
    except (_BreakError, _ContinueError, _ReturnError, _LeftError):
        pass
    if script.evaluator.unknowns:
        raise script.stopped(script.evaluator.last)
    raise StopError(1, "no call of setup() found")


class _Script:
    """Runs statements.

    A statement that cannot be evaluated makes the names and values unknown that it could change.
    """

    def __init__(self, evaluator: Evaluator) -> None:
        self.evaluator = evaluator
        self._yielded: list[list[Any]] = []

    def stopped(self, unknown: Unknown) -> StopError:
        """Return the error about a call of setup() that is not reached."""
        what = f"sitegen does not evaluate '{unknown.text}', which setup() depends on"
        return StopError(unknown.line, f"{what}; {ADVICE}")

    def run(self, statements: Iterable[ast.stmt]) -> None:
        """Run statements in order."""
        for statement in statements:
            self.evaluator.step()
            try:
                self._statement(statement)
            except FAILURES:
                self._skip([statement], self.evaluator.unknown(statement))

    def _statement(self, node: ast.stmt) -> None:
        value = self.evaluator.value
        match node:
            case ast.Expr(value=ast.Yield(value=given)):
                self._yielded[-1].append(value(given) if given else None)
            case ast.Expr(value=ast.YieldFrom(value=given)):
                self._yielded[-1].extend(self.evaluator.items(given))
            case ast.Expr():
                value(node.value)
            case ast.Assign():
                given = value(node.value)
                for target in node.targets:
                    self.evaluator.assign(target, given)
            case ast.AnnAssign(value=ast.expr() as given):
                self.evaluator.assign(node.target, value(given))
            case ast.AugAssign():
                self._augment(node)
            case ast.Import() | ast.ImportFrom():
                self._import(node)
            case ast.FunctionDef(decorator_list=[]):
                function = Function(self.evaluator, node, lambda: self._result(node))
                self.evaluator.assign(ast.Name(node.name, ast.Store()), function)
            case ast.If():
                test = value(node.test)
                if isinstance(test, Unknown):
                    self._skip([*node.body, *node.orelse], test)
                else:
                    self.run(node.body if test else node.orelse)
            case ast.For() | ast.While():
                self._loop(node)
            case ast.With():
                for item in node.items:
                    given = value(item.context_expr)
                    if item.optional_vars:
                        self.evaluator.assign(item.optional_vars, given)
                self.run(node.body)
            case ast.Try():
                self._try(node)
            case ast.Return():
                raise _ReturnError(value(node.value) if node.value else None)
            case ast.Break():
                raise _BreakError
            case ast.Continue():
                raise _ContinueError
            case ast.Raise():
                raise self.stopped(Unknown(node))
            case ast.Global():
                self.evaluator.scopes[-1].setdefault(GLOBAL, set()).update(node.names)
            case ast.Pass() | ast.Assert() | ast.AnnAssign():
                pass
            case _:
                raise TypeError

    def _import(self, node: ast.Import | ast.ImportFrom) -> None:
        for alias in node.names:
            short = alias.asname or alias.name.partition(".")[0]
            full = alias.name if alias.asname else short
            if isinstance(node, ast.ImportFrom):
                full = f"{'.' * node.level}{node.module or ''}.{alias.name}"
            imported = self.evaluator.imported(full, node)
            self.evaluator.assign(ast.Name(short, ast.Store()), imported)

    def _result(self, function: ast.FunctionDef) -> Any:
        """Run the body of a function; of a generator, return all that it yields."""
        parts = (each for top in function.body for each in ast.walk(top))
        generator = any(isinstance(each, ast.Yield | ast.YieldFrom) for each in parts)
        value = None
        self._yielded.append([])
        try:
            self.run(function.body)
        except _ReturnError as returned:
            value = returned.value
        except _LeftError as left:
            self._spoil(function.body, left.unknown)
            return left.unknown
        finally:
            yielded = self._yielded.pop()
        return yielded if generator else value

    def _loop(self, node: ast.For | ast.While) -> None:
        for item in self._rounds(node):
            if isinstance(item, Unknown):
                self._skip([node], item)
                return
            try:
                if isinstance(node, ast.For):
                    self.evaluator.assign(node.target, item)
                self.run(node.body)
            except _LeftError as left:
                self._skip([node], left.unknown)
                return
            except _BreakError:
                return
            except _ContinueError:
                continue
        self.run(node.orelse)

    def _rounds(self, node: ast.For | ast.While) -> Iterable[Any]:
        if isinstance(node, ast.For):
            yield from self.evaluator.items(node.iter)
            return
        while isinstance(test := self.evaluator.value(node.test), Unknown) or test:
            yield test

    def _try(self, node: ast.Try) -> None:
        before = self.evaluator.unknowns
        self.run(node.body)
        if self.evaluator.unknowns > before:
            # It may have failed, and then one of these was run.
            self._skip(node.handlers, self.evaluator.last)
        self.run([*node.orelse, *node.finalbody])

    def _augment(self, node: ast.AugAssign) -> None:
        target = ast.copy_location(ast.parse(ast.unparse(node.target), mode="eval").body, node)
        left, right = self.evaluator.value(target), self.evaluator.value(node.value)
        if isinstance(left, list) and isinstance(right, Unknown):
            spoil(left, right)
        elif isinstance(left, list) and isinstance(node.op, ast.Add):
            # It changes the list itself, which may have other names.
            setupvalues.method(left, "extend")(items(right))
        else:
            self.evaluator.assign(node.target, self.evaluator.binary(node.op, left, right))

    def _skip(self, nodes: Sequence[ast.AST], unknown: Unknown) -> None:
        """Go on after `nodes`, which are not run.

        Raises: _LeftError if they could leave the statements around them.
        """
        self._spoil(nodes, unknown)
        if any(_leaves(node) for node in nodes):
            raise _LeftError(unknown)

    def _spoil(self, nodes: Iterable[ast.AST], unknown: Unknown) -> None:
        """Make everything unknown that `nodes` could change."""
        waiting, seen = list(nodes), set[ast.AST]()
        while waiting:
            node = waiting.pop()
            if node in seen:
                continue
            seen.add(node)
            for name, assigned in setupvalues.names_in([node]):
                value = self.evaluator.lookup(name)
                if value is setupnames.SETUP and not assigned:
                    raise self.stopped(unknown)
                spoil(value, unknown)
                if isinstance(value, Function):
                    waiting.append(value.node)
                if assigned:
                    self.evaluator.assign(ast.Name(name, ast.Store()), unknown)


def _leaves(node: ast.AST, *, in_loop: bool = False) -> bool:
    """Return whether a statement may leave the loop or the function around it."""
    if isinstance(node, ast.Return) or (isinstance(node, ast.Break | ast.Continue) and not in_loop):
        return True
    if isinstance(node, ast.FunctionDef | ast.Lambda | ast.ClassDef):
        return False
    in_loop = in_loop or isinstance(node, ast.For | ast.While)
    return any(_leaves(each, in_loop=in_loop) for each in ast.iter_child_nodes(node))
