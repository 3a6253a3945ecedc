"""Turn source code into HTML with a class for each kind of token; the theme sets the colours."""

from __future__ import annotations

import functools
import re
from collections.abc import Collection, Iterator, Sequence

from markupsafe import escape
from pygments.lexer import Lexer
from pygments.lexers import get_lexer_by_name
from pygments.token import Comment, Generic, Keyword, Name, Number, Operator, String, Token
from pygments.token import _TokenType as TokenType
from pygments.util import ClassNotFound

# Fewer kinds than Pygments has: readers distinguish a dozen colours at most.
CLASSES = {
    Comment: "c",
    Comment.Preproc: "m",
    Comment.PreprocFile: "s",
    Generic.Deleted: "d",
    Generic.Heading: "h",
    Generic.Inserted: "i",
    Generic.Output: "c",
    Generic.Prompt: "m",
    Generic.Subheading: "h",
    Keyword: "k",
    Keyword.Constant: "n",
    Keyword.Type: "t",
    Name.Attribute: "a",
    Name.Builtin: "t",
    Name.Class: "t",
    Name.Constant: "n",
    Name.Decorator: "m",
    Name.Exception: "t",
    Name.Function: "f",
    Name.Label: "m",
    Name.Namespace: "t",
    Name.Tag: "k",
    Number: "n",
    Operator.Word: "k",
    String: "s",
    String.Escape: "n",
    Token: "",
}

# The languages of files in ROS workspaces, by suffix.
LANGUAGES = {
    ".c": "c",
    ".cc": "cpp",
    ".cmake": "cmake",
    ".cpp": "cpp",
    ".css": "css",
    ".cxx": "cpp",
    ".h": "cpp",
    ".hpp": "cpp",
    ".html": "html",
    ".ini": "ini",
    ".js": "js",
    ".json": "json",
    ".launch": "xml",
    ".md": "markdown",
    ".py": "python",
    ".sh": "bash",
    ".toml": "toml",
    ".ts": "ts",
    ".urdf": "xml",
    ".xacro": "xml",
    ".xml": "xml",
    ".yaml": "yaml",
    ".yml": "yaml",
    "CMakeLists.txt": "cmake",
}


def language_of(name: str) -> str:
    """Return the language of a file by its name, or nothing."""
    return next((language for end, language in LANGUAGES.items() if name.endswith(end)), "")


@functools.lru_cache(maxsize=4096)
def code(
    text: str,
    language: str,
    *,
    title: str = "",
    numbers: tuple[int, ...] = (),
    marked: tuple[int, ...] = (),
) -> str:
    """Return a block of code; `numbers` are its line numbers, if shown; `marked` lines stand out.

    Marked lines are counted from 1, whatever their numbers are.
    """
    body = "".join(_words(text.removesuffix("\n") + "\n", language))
    if numbers or marked:
        body = "".join(_lines(body, numbers, marked))
    head = f'<p class="code-title">{escape(title)}</p>' if title else ""
    name = f' class="language-{escape(language)}"' if language else ""
    # It may be wider than the page: with the focus, it can be scrolled by the keyboard.
    return f'<div class="code">{head}<pre tabindex="0"><code{name}>{body}</code></pre></div>'


def commands(text: str, *, title: str = "", console: bool = False) -> str:
    """Return a block of commands for a terminal, each with a button that the page's terminal shows.

    A line that ends with a backslash goes on in the next one; comments and empty lines are none.
    Of a `console`, commands begin with `$ ros2`; what they print, and other programs, have no
    button.
    """
    lines = text.rstrip("\n").split("\n")
    language = "console" if console else "bash"
    shown = "".join(_words("\n".join(lines) + "\n", language)).split("\n")
    body, begun, html = [], "", ""
    for index, (line, words) in enumerate(zip(lines, shown, strict=False)):
        begun += f"{line}\n"
        html += f"{words}\n"
        if line.endswith("\\") and index + 1 < len(lines):
            continue
        command = re.sub(r"\A\s*\$ ", "", begun).strip()
        runs = re.match(r"\s*\$ ros2\b", begun) if console else not command.startswith("#")
        if command and runs:
            run = f'data-ros-run="{escape(command)}" hidden'
            button = f'<button type="button" class="run" {run}></button>'
            html = f'<span class="command">{button}{html}</span>'
        body.append(html)
        begun = html = ""
    head = f'<p class="code-title">{escape(title)}</p>' if title else ""
    name = "console" if console else "ros2"
    inner = f'<code class="language-{name}">{"".join(body)}</code>'
    return f'<div class="code">{head}<pre tabindex="0">{inner}</pre></div>'


def _words(text: str, language: str) -> Iterator[str]:
    """Yield pieces of HTML; no span continues over the end of a line."""
    lexer = _lexer(language)
    if lexer is None:
        yield escape(text)
        return
    for kind, word in lexer.get_tokens(text):
        name = _class(kind)
        if not name or word.isspace():
            yield escape(word)
            continue
        for index, line in enumerate(word.split("\n")):
            yield "\n" * bool(index)
            yield f'<span class="{name}">{escape(line)}</span>' if line else ""


def _lines(body: str, numbers: Sequence[int], marked: Collection[int]) -> Iterator[str]:
    for index, line in enumerate(body.split("\n")[:-1]):
        name = "line marked" if index + 1 in marked else "line"
        data = f' data-line="{numbers[index]}"' if numbers else ""
        yield f'<span class="{name}"{data}>{line}\n</span>'


@functools.cache
def _lexer(language: str) -> Lexer | None:
    try:
        return get_lexer_by_name(language, stripnl=False) if language else None
    except ClassNotFound:
        return None


@functools.cache
def _class(kind: TokenType) -> str:
    return next(CLASSES[each] for each in reversed(kind.split()) if each in CLASSES)
