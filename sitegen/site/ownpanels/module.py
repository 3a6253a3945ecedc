"""Parse an ES module: its references to other files, its exports, and its syntax errors."""

from __future__ import annotations

import functools
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

from tree_sitter import Language, Node, Parser
from tree_sitter_javascript import language

SHORT = 30


class Reference(NamedTuple):
    """A string that names another file, with its position in bytes, quotes included.

    `kind` is `import`, `effect` for an import without names, `dynamic` for `import()`, or `url` for
    `new URL(name, import.meta.url)`. `end` includes the attributes of an import.
    """

    kind: str
    name: str
    line: int
    start: int
    end: int


@dataclass(frozen=True)
class Module:
    """A parsed module; `fault` is its first syntax error with its line, if there is one.

    `exports` are the exported names; `*` stands for all those of another module.
    """

    references: tuple[Reference, ...]
    exports: frozenset[str]
    fault: tuple[int, str] | None


@functools.lru_cache(maxsize=64)
def parsed(source: bytes) -> Module:
    """Return what the text of a module consists of."""
    root = Parser(Language(language())).parse(source).root_node
    nodes = list(_all(root))
    references = tuple(found for node in nodes if (found := _reference(node)))
    exports = (name for node in root.named_children for name in _exports(node))
    fault = next(filter(None, map(_fault, nodes)), None) if root.has_error else None
    return Module(references, frozenset(exports), fault)


def _all(root: Node) -> Iterator[Node]:
    """Yield all nodes in the order of the text; a recursion could be too deep."""
    left = [root]
    while left:
        node = left.pop()
        yield node
        left += reversed(node.children)


def _fault(node: Node) -> tuple[int, str] | None:
    line = node.start_point.row + 1
    if node.is_missing:
        return line, f"missing '{node.type}'"
    if node.is_error:
        text = " ".join(_text(node).split())
        near = text if len(text) <= SHORT else f"{text[: SHORT - 1]}…"
        return line, f"near '{near}'" if near else "at the end of the file"
    return None


def _reference(node: Node) -> Reference | None:
    if node.type in ("import_statement", "export_statement"):
        source = node.child_by_field_name("source")
        if not source:
            return None
        bare = node.type == "import_statement" and not any(
            child.type == "import_clause" for child in node.children
        )
        attributes = [child for child in node.children if child.type == "import_attribute"]
        end = attributes[-1].end_byte if attributes else source.end_byte
        return _named("effect" if bare else "import", source, end)
    arguments = node.child_by_field_name("arguments")
    given = arguments.named_children if arguments else []
    if not given or given[0].type != "string":
        return None
    if node.type == "call_expression":
        called = node.child_by_field_name("function")
        if called and called.type == "import":
            return _named("dynamic", given[0], given[-1].end_byte)
    if node.type == "new_expression" and len(given) == 2:
        made = node.child_by_field_name("constructor")
        if made and _text(made) == "URL" and _text(given[1]) == "import.meta.url":
            return _named("url", given[0], given[0].end_byte)
    return None


def _named(kind: str, source: Node, end: int) -> Reference:
    name = _text(source)[1:-1]
    return Reference(kind, name, source.start_point.row + 1, source.start_byte, end)


def _exports(node: Node) -> Iterator[str]:
    if node.type != "export_statement":
        return
    if any(child.type == "*" for child in node.children):
        yield "*"
    if any(child.type == "default" for child in node.children):
        yield "default"
        return
    declared = node.child_by_field_name("declaration")
    for one in (declared, *(declared.named_children if declared else ())):
        name = one.child_by_field_name("name") if one else None
        if name:
            yield _text(name)
    for clause in node.named_children:
        for one in clause.named_children if clause.type == "export_clause" else ():
            name = one.child_by_field_name("alias") or one.child_by_field_name("name")
            if name:
                yield _text(name)


def _text(node: Node) -> str:
    return (node.text or b"").decode("utf-8", "replace")
