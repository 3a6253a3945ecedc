"""Evaluate Python source without running it: literals, and the expressions of setup.py files."""

from __future__ import annotations

import ast
import os
from collections.abc import Callable, Sequence
from fnmatch import fnmatch
from pathlib import Path
from typing import Any


class NotLiteralError(Exception):
    """The value of an expression is known only by running it."""

    def __init__(self, node: ast.AST) -> None:
        text = " ".join(ast.unparse(node).split())
        super().__init__(text if len(text) < 60 else f"{text[:60]}…")
        self.line = getattr(node, "lineno", 1)


class Reader:
    """The values of a module's names; expressions that list files look in `folder`."""

    def __init__(self, tree: ast.Module, folder: Path) -> None:
        self._folder = folder
        self._names = {
            target.id: node.value
            for node in tree.body
            if isinstance(node, ast.Assign)
            for target in node.targets
            if isinstance(target, ast.Name)
        }
        self._depth = 0

    def value(self, node: ast.expr) -> Any:
        """Return the value of an expression.

        Raises: NotLiteralError if it is known only by running it.
        """
        self._depth += 1
        try:
            if self._depth > 100:
                raise NotLiteralError(node)
            return self._value(node)
        finally:
            self._depth -= 1

    def _value(self, node: ast.expr) -> Any:
        match node:
            case ast.Constant():
                return node.value
            case ast.Name() if node.id in self._names:
                return self.value(self._names[node.id])
            case ast.List() | ast.Tuple() | ast.Set():
                return self._elements(node.elts)
            case ast.Dict():
                if None in node.keys:
                    raise NotLiteralError(node)
                keys = [self.value(key) for key in node.keys if key]
                return dict(zip(keys, map(self.value, node.values), strict=True))
            case ast.BinOp(op=ast.Add()):
                left, right = self.value(node.left), self.value(node.right)
                if type(left) is type(right) and isinstance(left, str | list):
                    return left + right
            case ast.BinOp(op=ast.Mod()):
                left, right = self.value(node.left), self.value(node.right)
                if isinstance(left, str):
                    return left % (tuple(right) if isinstance(right, list) else right)
            case ast.JoinedStr():
                return "".join(str(self.value(part)) for part in node.values)
            case ast.FormattedValue(conversion=-1, format_spec=None):
                return self.value(node.value)
            case ast.Call():
                return self._call(node)
        raise NotLiteralError(node)

    def _elements(self, nodes: Sequence[ast.expr]) -> list[Any]:
        elements: list[Any] = []
        for node in nodes:
            if isinstance(node, ast.Starred):
                elements += self.value(node.value)
            else:
                elements.append(self.value(node))
        return elements

    def _call(self, node: ast.Call) -> Any:
        known: dict[str, Callable[..., Any]] = {
            "os.path.join": os.path.join,
            "join": os.path.join,
            "glob": self._glob,
            "glob.glob": self._glob,
            "find_packages": self._find_packages,
            "setuptools.find_packages": self._find_packages,
            "str": str,
            "sorted": sorted,
            "list": list,
        }
        function = known.get(ast.unparse(node.func))
        if function is None or any(keyword.arg is None for keyword in node.keywords):
            raise NotLiteralError(node)
        arguments = self._elements(node.args)
        try:
            return function(*arguments, **{k.arg or "": self.value(k.value) for k in node.keywords})
        except (TypeError, ValueError, NotImplementedError):
            raise NotLiteralError(node) from None

    def _glob(self, pattern: str, *, recursive: bool = False) -> list[str]:
        found = sorted(self._folder.glob(pattern))
        return [file.relative_to(self._folder).as_posix() for file in found if file.is_file()]

    def _find_packages(
        self, where: str = ".", exclude: Sequence[str] = (), include: Sequence[str] = ("*",)
    ) -> list[str]:
        top = self._folder / where
        inits = sorted(top.rglob("__init__.py"))
        names = [".".join(file.relative_to(top).parts[:-1]) for file in inits]
        return [
            name
            for name in names
            if name
            and any(fnmatch(name, pattern) for pattern in include)
            and not any(fnmatch(name, pattern) for pattern in exclude)
        ]
