"""Split Markdown text into prose and `ros` blocks."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass

ROS = re.compile(r"(```|~~~)[`~ \t{.]*((ya?ml|python|js|javascript)[ \t]+)?ros", re.I)
FENCE = re.compile(r" {0,3}(?P<fence>`{3,}|~{3,})[ \t]*(?P<info>.*?)[ \t]*$")
# A fence at any depth: also in a list, a tab or a quotation.
INNER_FENCE = re.compile(
    r"[ \t>]*(?:(?:[-*+]|\d+[.)])[ \t]+)?(?P<fence>`{3,}|~{3,})[ \t]*(?P<info>.*?)[ \t]*$"
)
# `ros2` is a language: that of commands, which a terminal runs.
NEARLY_ROS = re.compile(r"[{.]*\s*ros1?[\s}]*(?!\S)", re.I)
# An example: YAML that the page shows, and the widgets that it describes. Options may follow.
EXAMPLE = re.compile(r"yaml[ \t]+ros(?!\S)")
NEARLY_EXAMPLE = re.compile(r"ya?ml\s+ros(?!\S)", re.I)
# Code that visitors run.
CELL = re.compile(r"(?P<language>python|js|javascript)[ \t]+ros(?!\S)")
HEADING = re.compile(r" {0,3}#[ \t]+(?P<title>.*?)[ \t]*#*[ \t]*$")
LINK = re.compile(r"!?\[([^]]*)\]\([^)]*\)")


@dataclass(frozen=True)
class Block:
    """Lines of Markdown from `line` (from 0) on: prose, or the content of a fence with `info`."""

    text: str
    line: int
    info: str | None = None
    closed: bool = True


@dataclass(frozen=True)
class _Line:
    text: str
    info: str | None
    edge: bool = False


def split(text: str, wanted: Callable[[str], bool] | None = None) -> Iterator[Block]:
    """Yield the prose and the `ros` blocks of `text` in order; other fences belong to the prose.

    With `wanted`, the blocks are the fences whose info string it accepts.
    """
    if not wanted and not ROS.search(text):
        # Most pages of a large site contain only text, and reading them line by line takes time.
        yield from _prose([text], 1)
        return
    prose: list[str] = []
    body: list[str] = []
    inside = False
    number = -1
    for number, line in enumerate(_lines(text)):
        if line.info is None or not (wanted or _is_ros)(line.info):
            prose.append(line.text)
        elif not line.edge:
            body.append(line.text)
        elif not inside:
            yield from _prose(prose, number)
            prose, inside = [], True
        else:
            yield Block("\n".join(body), number - len(body), line.info)
            body, inside = [], False
    if inside:
        yield Block("\n".join(body), number + 1 - len(body), "ros", closed=False)
    yield from _prose(prose, number + 1)


def misplaced(text: str) -> Iterator[int]:
    """Yield the lines (from 0) where a `ros` block begins in a list, a tab or a quotation."""
    if not ROS.search(text):
        return
    fence = ""
    for number, line in enumerate(text.split("\n")):
        match = INNER_FENCE.match(line)
        if not match:
            continue
        if not fence:
            fence = match["fence"]
            if match["info"] == "ros" or EXAMPLE.match(match["info"]) or CELL.match(match["info"]):
                yield number
        elif match["fence"].startswith(fence) and not match["info"]:
            fence = ""


def front_matter(text: str) -> tuple[Block, Block]:
    """Return the YAML between `---` at the top and the next `---`, and the text that follows."""
    if not re.match(r"---[ \t]*(\n|$)", text):
        return Block("", 0), Block(text, 0)
    lines = text.split("\n")
    end = next((i for i, line in enumerate(lines) if i and line.rstrip() == "---"), None)
    if end is None:
        return Block("", 0, closed=False), Block("", 0)
    return Block("\n".join(lines[1:end]), 1), Block("\n".join(lines[end + 1 :]), end + 1)


def heading(text: str) -> str:
    """Return the first heading of the first level as plain text, or nothing."""
    for line in _lines(text):
        match = HEADING.match(line.text) if line.info is None else None
        if match and match["title"]:
            return re.sub(r"[`*]", "", LINK.sub(r"\1", match["title"]))
    return ""


def _prose(lines: list[str], end: int) -> Iterator[Block]:
    if any(line.strip() for line in lines):
        yield Block("\n".join(lines), end - len(lines))


def _is_ros(info: str) -> bool:
    """Return whether a fence is a `ros` block, or meant to be one: its reader reports the error."""
    return any(form.match(info) for form in (NEARLY_ROS, NEARLY_EXAMPLE, CELL))


def _lines(text: str) -> Iterator[_Line]:
    """Yield each line with the info string of the fence that contains it."""
    fence = info = ""
    for line in text.split("\n"):
        match = FENCE.match(line) if "```" in line or "~~~" in line else None
        if not fence:
            # A backtick in the info string makes it inline code.
            if match and not (match["fence"][0] == "`" and "`" in match["info"]):
                fence, info = match["fence"], match["info"]
                yield _Line(line, info, edge=True)
            else:
                yield _Line(line, None)
        elif match and match["fence"].startswith(fence) and not match["info"]:
            yield _Line(line, info, edge=True)
            fence = ""
        else:
            yield _Line(line, info)
