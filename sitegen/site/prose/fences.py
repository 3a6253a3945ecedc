"""Handle fenced blocks: highlight code and commands, and draw diagrams."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

from markupsafe import escape

from sitegen.site.prose.highlight import code, commands

# The options after the language: ```cpp title="talker.cpp" linenums="1" hl_lines="2 4-6"
OPTIONS = {
    "title": re.compile(r"[^\n]*"),
    "linenums": re.compile(r"[1-9]\d*"),
    "hl_lines": re.compile(r"\d+(-\d+)?([ ,]+\d+(-\d+)?)*"),
}
DIAGRAM = re.compile(r'<div class="mermaid">(.*?)</div>', re.DOTALL)


def _options(
    language: str,
    inputs: Mapping[str, str],
    options: dict[str, str],
    attributes: dict[str, str],
    converter: object,
) -> bool:
    """Accept the known options; a fence with any other is shown as text."""
    fits = {name: value for name, value in inputs.items() if name in OPTIONS}
    options.update(fits)
    return all(OPTIONS[name].fullmatch(value) for name, value in fits.items())


def _code(
    source: str, language: str, name: str, options: Mapping[str, str], *_: object, **__: object
) -> str:
    marked = tuple(sorted(_numbers(options.get("hl_lines", ""))))
    first = int(options.get("linenums", 0))
    numbers = range(first, first + source.count("\n") + 1) if first else ()
    title = options.get("title", "")
    return code(source, language, title=title, numbers=tuple(numbers), marked=marked)


def _commands(
    source: str, language: str, name: str, options: Mapping[str, str], *_: object, **__: object
) -> str:
    return commands(source, title=options.get("title", ""))


def _console(
    source: str, language: str, name: str, options: Mapping[str, str], *_: object, **__: object
) -> str:
    # Numbers and marks are those of code.
    if set(options) & {"linenums", "hl_lines"} or "$ ros2" not in source:
        return _code(source, language, name, options)
    return commands(source, title=options.get("title", ""), console=True)


def _diagram(source: str, *_: object, **__: object) -> str:
    return f'<div class="mermaid">{escape(source)}</div>'


def _numbers(text: str) -> set[int]:
    found: set[int] = set()
    for part in re.split(r"[ ,]+", text.strip()) if text else ():
        first, _, last = part.partition("-")
        found |= set(range(int(first), int(last or first) + 1))
    return found


def _fence(name: str, form: Callable[..., str]) -> dict[str, Any]:
    return {"name": name, "class": name, "format": form, "validator": _options}


# The last format that matches is used.
FENCES = [
    *(_fence("*", _code), _fence("mermaid", _diagram)),
    *(_fence("ros2", _commands), _fence("console", _console)),
]
