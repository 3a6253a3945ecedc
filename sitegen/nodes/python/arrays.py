"""Decide whether a program can do with the part of numpy that comes with sitegen."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from pathlib import Path

from sitegen.errors import Location
from sitegen.nodes.python import imports
from sitegen.shipped import CLIENTS

PATH = "nodes/numpy.zip"
CONSTANTS = {"e", "inf", "nan", "pi"}
# Types of elements. numpy's can be called, too.
TYPES = {
    *("float32", "float64", "int8", "int16", "int32", "int64"),
    *("uint8", "uint16", "uint32", "uint64"),
}
ARRAYS = {"array", "empty", "ndarray", "number", "zeros"} | TYPES | CONSTANTS
# With these, a program has only single numbers.
NUMBERS = CONSTANTS | {
    *("arccos", "arcsin", "arctan", "arctan2", "clip", "cos", "deg2rad", "degrees", "exp"),
    *("hypot", "isfinite", "isinf", "isnan", "log", "log10", "rad2deg", "radians", "sign"),
    *("sin", "sqrt", "tan"),
}
# With these, the arrays of a program are matrices.
MATRICES = NUMBERS | {"dot", "eye", "identity", "matmul"}
# The attributes of numpy's numbers that Python's lack, and of its arrays that matrices lack.
OF_NUMBERS = {
    *("astype", "clip", "dtype", "flatten", "item", "mean", "ndim", "nbytes", "reshape", "round"),
    *("shape", "sum", "tobytes", "tolist", "transpose"),
}
OF_ARRAYS = {
    *("all", "any", "argmax", "argmin", "astype", "clip", "dtype", "flatten", "item", "max"),
    *("mean", "min", "nbytes", "ravel", "reshape", "round", "squeeze", "sum", "tobytes", "trace"),
}
# Functions of tf_transformations that return matrices or take them.
TRANSFORMS = "tf_transformations"
OF_TRANSFORMS = {
    *("concatenate_matrices", "euler_from_matrix", "euler_matrix", "identity_matrix"),
    *("inverse_matrix", "is_same_transform", "quaternion_from_matrix", "quaternion_matrix"),
    *("rotation_matrix", "translation_from_matrix", "translation_matrix"),
}
SEQUENCES = (
    *(ast.List, ast.Tuple, ast.Set, ast.Dict, ast.ListComp, ast.GeneratorExp, ast.SetComp),
    *(ast.Starred, ast.Slice),
)


def module() -> dict[str, bytes]:
    """Return the files of the module that stands in for numpy, by path."""
    files = sorted((CLIENTS / "numpy").glob("*.py"))
    return {f"python/numpy/{file.name}": file.read_bytes() for file in files}


def enough(files: Mapping[str, Path], program: str) -> bool:
    """Return whether a program uses no more of numpy than sitegen has.

    `files` and `program` are those of `imports.outside()`.
    """
    names = imports.names_of("numpy", files, program)
    kinds = ((ARRAYS, set[str]()), (NUMBERS, OF_NUMBERS), (MATRICES, OF_ARRAYS))
    lacking = next((lacking for kind, lacking in kinds if names <= kind), None)
    if lacking is None:
        return False
    trees = list(_trees(imports.own(files, program)))
    if not all(_fits(*call) for tree in trees for call in _calls(tree)):
        return False
    return not any(_attributes(tree) & lacking for tree in trees)


def of_transforms(files: Mapping[str, Path], program: str) -> imports.Import | None:
    """Return where a program imports tf_transformations, if it uses its matrices.

    `files` and `program` are those of `imports.outside()`.
    """
    if imports.names_of(TRANSFORMS, files, program) & OF_TRANSFORMS:
        for file in imports.own(files, program):
            for name, line, _ in imports.imported(file):
                if name == TRANSFORMS:
                    return imports.Import(Location(file, line), True)
    return None


def _trees(files: list[Path]) -> Iterator[ast.AST]:
    for file in files:
        try:
            yield ast.parse(file.read_bytes())
        except (SyntaxError, ValueError):
            continue  # reported by syntax.check()


def _attributes(tree: ast.AST) -> set[str]:
    """Return the attributes that a module uses, without the names of numpy."""
    modules, _ = _imported(tree)
    found = (node for node in ast.walk(tree) if isinstance(node, ast.Attribute))
    return {node.attr for node in found if ast.unparse(node.value) not in modules}


def _imported(tree: ast.AST) -> tuple[set[str], dict[str, str]]:
    """Return what a module calls numpy, and the names from it by what the module calls these."""
    modules: set[str] = set()
    names: dict[str, str] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            modules |= {one.asname or one.name for one in node.names if one.name == "numpy"}
        elif isinstance(node, ast.ImportFrom) and node.module == "numpy" and not node.level:
            names |= {one.asname or one.name: one.name for one in node.names}
    return modules, names


def _calls(tree: ast.AST) -> Iterator[tuple[str, ast.Call]]:
    """Yield the calls of functions of numpy, by the names of these."""
    modules, names = _imported(tree)
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call):
            continue
        called = node.func
        if isinstance(called, ast.Name) and called.id in names:
            yield names[called.id], node
        elif isinstance(called, ast.Attribute) and ast.unparse(called.value) in modules:
            yield called.attr, node


def _fits(name: str, call: ast.Call) -> bool:
    """Return whether sitegen's function takes the arguments of a call, as far as can be seen."""
    if name in MATRICES:
        return not call.keywords and not any(isinstance(one, SEQUENCES) for one in call.args)
    if name not in ("array", "empty", "zeros") or not call.args:
        return False
    first, *others = call.args
    others += [word.value for word in call.keywords]
    elements = first.elts if isinstance(first, ast.List | ast.Tuple) else []
    if any(isinstance(element, SEQUENCES) for element in elements):
        return False
    if name != "array" and len(elements) > 1:
        return False
    return len(others) <= 1 and all(
        isinstance(one, ast.Attribute) and one.attr in {*TYPES, "dtype"} for one in others
    )
