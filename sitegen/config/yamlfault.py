"""Explain the errors of the YAML parser: the line, what is wrong, and how to fix it."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from dataclasses import dataclass

import yaml

CLOSERS = {"{": "}", "[": "]"}
BRACKETS = re.compile(r'"(?:\\.|[^"\\\n])*"|[][{}]|#.*')
# A line with a key or a list item: its indentation and dashes, its key, and the rest.
ENTRY = re.compile(r"(?P<before>\s*(?:-\s+)*)(?P<key>[^\s:#][^:]*?):\s+(?P<rest>\S.*)")
# Quoted lines are cut after this many characters.
SHOWN = 60

Found = tuple[int, str]


@dataclass(frozen=True)
class Fault:
    """An error of the parser, and the lines of the text; lines are counted from 0."""

    error: yaml.MarkedYAMLError
    text: str

    @property
    def lines(self) -> list[str]:
        """The lines of the text, followed by an empty line."""
        return [*self.text.split("\n"), ""]

    @property
    def mark(self) -> tuple[int, int]:
        """The line and the column of the problem."""
        mark = self.error.problem_mark or self.error.context_mark
        return (mark.line, mark.column) if mark else (0, 0)

    @property
    def begun(self) -> tuple[int, int]:
        """The line and the column of the construct that was being read, or of the problem."""
        mark = self.error.context_mark
        return (mark.line, mark.column) if mark else self.mark

    @property
    def line(self) -> str:
        """The line of the problem."""
        return self.lines[self.mark[0]]

    @property
    def found(self) -> str:
        """The token that the parser did not expect, without quotes."""
        match = re.search(r"(?:found|got) '(.*)'$", self.error.problem or "")
        return match[1] if match else ""

    def shown(self, number: int) -> str:
        """Return a line for use in a message."""
        line = " ".join(self.lines[number].split())
        return f"'{line}'" if len(line) <= SHOWN else f"'{line[: SHOWN - 1]}…'"

    def above(self, number: int) -> int:
        """Return the number of the nearest line above that is neither empty nor a comment."""
        for other in reversed(range(number)):
            if self.lines[other].strip() and not self.lines[other].lstrip().startswith("#"):
                return other
        return number

    def last_token(self) -> yaml.Token | None:
        """Return the token before the problem."""
        last = None
        try:
            for token in yaml.scan(self.text, Loader=yaml.SafeLoader):
                mark = token.start_mark
                if (mark.line, mark.column) >= self.mark:
                    break
                if token.end_mark.index > mark.index:
                    last = token
        except yaml.YAMLError:
            pass
        return last


def explain(error: yaml.YAMLError, text: str) -> Found:
    """Return the line of an error, counted from 0, and the message: what is wrong, and the fix."""
    if isinstance(error, yaml.MarkedYAMLError):
        fault = Fault(error, text)
        said = f"{error.context or ''} {error.problem or ''}"
        for pattern, rule in RULES:
            if re.search(pattern, said) and (found := rule(fault)):
                return found
        said = " ".join((said if fault.error.problem else "not valid").split())
        number = fault.mark[0]
        shown = fault.shown(number)
        return number, f"{said} in {shown}; check indentation and quotes here and above"
    position = getattr(error, "position", 0)
    code = ord(text[position : position + 1] or "\0")
    line = text.count("\n", 0, position)
    return line, f"the character 0x{code:02x} is not allowed in YAML; remove it"


def _tab(fault: Fault) -> Found:
    number, column = fault.mark
    if fault.line[:column].strip():
        return number, f"a tab in {fault.shown(number)}; use spaces"
    return number, f"a tab before {fault.shown(number)}; indent with spaces"


def _key(fault: Fault) -> Found | None:
    """Explain a ':' at a position where no key can be."""
    number, column = fault.mark
    before = fault.line[:column]
    if re.search(r":\s", before):
        return number, f"': ' in the text of {fault.shown(number)}; {_in_quotes(fault)}"
    above = fault.above(number)
    if not ENTRY.match(fault.lines[above]) and not fault.lines[above].rstrip().endswith(":"):
        return _without_colon(fault, above)
    depth, deeper = _depth(fault.lines[above]), _depth(fault.line)
    if deeper <= depth:
        return None
    shown = f"{fault.shown(number)} is indented further than {fault.shown(above)}"
    return number, f"{shown} above; indent it with {_spaces(fault, number, above)}"


def _without_colon(fault: Fault, number: int) -> Found:
    line = fault.lines[number].strip().removeprefix("- ")
    key, colon, rest = line.partition(":")
    if colon:
        return number, f"no space after ':' in {fault.shown(number)}; write '{key}: {rest}'"
    return number, f"no ':' after {fault.shown(number)}; write it like '{line}: …'"


def _spaces(fault: Fault, number: int, above: int) -> str:
    """Return the indentation that the line `number` should have, which is that of line `above`."""
    item, list_above = (fault.lines[each].lstrip().startswith("-") for each in (number, above))
    while item and not list_above and above != fault.above(above):
        above = fault.above(above)
        list_above = fault.lines[above].lstrip().startswith("-")
    wanted = _depth(fault.lines[above]) + (2 if list_above and not item else 0)
    return f"{wanted} space{'s'[: wanted != 1]}"


def _depth(line: str) -> int:
    return len(line) - len(line.lstrip())


def _flow(fault: Fault) -> Found:
    """Explain an invalid mapping in braces or list in brackets."""
    number, column = fault.begun
    opener = fault.lines[number][column]
    closer = CLOSERS[opener]
    if fault.found in CLOSERS.values():
        line = fault.mark[0]
        shown = fault.shown(line)
        return line, f"'{opener}' is closed with '{fault.found}' in {shown}; write '{closer}'"
    rest = "\n".join([fault.lines[number][column:], *fault.lines[number + 1 :]])
    if not _closed(rest):
        shown = fault.shown(number)
        return number, f"'{opener}' is not closed in {shown}; close it with '{closer}'"
    line, column = fault.mark
    word = fault.lines[line][:column].split(" ")[-1] if fault.found == ":" else ""
    before = f" before '{word}:'" if word else ""
    message = f"no comma{before} in {fault.shown(line)}"
    return line, f"{message}; add it, or put text that contains ': ' in quotes"


def _missing(fault: Fault) -> Found | None:
    """Explain that a value is missing in braces or brackets."""
    line, column = fault.mark
    opener = _unclosed([*fault.lines[:line], fault.line[:column]])
    if not opener:
        return None
    number, bracket = opener
    closer, shown = CLOSERS[bracket], fault.shown(line)
    if fault.found == ",":
        return line, f"nothing stands before ',' in {shown}; remove the comma, or write a value"
    if fault.found == "-":
        return line, f"'-' between '{bracket}' and '{closer}' in {shown}; write only the comma"
    if fault.found in CLOSERS.values() and fault.found != closer:
        return line, f"'{bracket}' is closed with '{fault.found}' in {shown}; write '{closer}'"
    shown = fault.shown(number)
    return number, f"'{bracket}' is not closed in {shown}; close it with '{closer}'"


def _unclosed(lines: list[str]) -> tuple[int, str] | None:
    """Return the line and the last bracket that is open at the end of `lines`."""
    found: list[tuple[int, str]] = []
    for number, line in enumerate(lines):
        for part in BRACKETS.findall(line):
            if part in CLOSERS:
                found.append((number, part))
            elif part in CLOSERS.values() and found:
                found.pop()
    return found[-1] if found else None


def _closed(text: str) -> bool:
    """Return whether the bracket at the start of `text` is closed."""
    depth = 0
    for part in BRACKETS.findall(text):
        depth += (part in CLOSERS) - (part in CLOSERS.values())
        if depth <= 0:
            return True
    return False


def _open_quote(fault: Fault) -> Found:
    number, column = fault.begun
    return _not_closed(fault, number, fault.lines[number][column])


def _not_closed(fault: Fault, number: int, quote: str) -> Found:
    return number, f"a quote is not closed in {fault.shown(number)}; end the text with {quote}"


def _rest(fault: Fault) -> Found | None:
    """Explain text that follows after the end of a mapping or a list."""
    number = fault.mark[0]
    if fault.found in CLOSERS.values():
        return number, f"'{fault.found}' closes nothing in {fault.shown(number)}; remove it"
    last = fault.last_token()
    style = last.style if isinstance(last, yaml.ScalarToken) else None
    if last and style in ("'", '"'):
        first, end = last.start_mark.line, last.end_mark.line
        if first != end and end == number:
            return _not_closed(fault, first, style)
        if first == number:
            shown = fault.shown(number)
            return number, f"the text goes on after its second {style} in {shown}; " + (
                "use double quotes" if style == "'" else _in_quotes(fault)
            )
    if style in ("|", ">"):
        message = "is indented less than the text above"
        return number, f"{fault.shown(number)} {message}; indent it like that text, or like a key"
    if isinstance(last, yaml.FlowMappingEndToken | yaml.FlowSequenceEndToken):
        bracket = "{" if isinstance(last, yaml.FlowMappingEndToken) else "["
        shown = fault.shown(number)
        return number, f"'{bracket}' begins the text of {shown}; {_in_quotes(fault)}"
    return _out_of_line(fault)


def _out_of_line(fault: Fault) -> Found | None:
    """Explain a key or an item whose indentation differs from that of its siblings."""
    number = fault.mark[0]
    shown = fault.shown(number)
    item = fault.line.lstrip().startswith("-")
    if fault.found == "-":
        return number, f"{shown} is a list item among keys; remove the '-', or give it a key"
    if fault.found == "?":
        return number, f"{shown} is in line with a '-' above; indent it with 2 spaces more"
    for other in reversed(range(number)):
        line = fault.lines[other]
        if line.lstrip().startswith("-") == item and (item or ENTRY.match(line)):
            message = f"is not in line with {fault.shown(other)} on line {other + 1}"
            many = f"{_depth(line)} space{'s'[: _depth(line) != 1]}"
            return number, f"{shown} {message}; indent it with {many}"
    return None


def _sign(fault: Fault) -> Found:
    """Explain text that starts with a character that has another meaning in YAML."""
    number, column = fault.begun if fault.error.context_mark else fault.mark
    line = fault.lines[number]
    if line.lstrip().startswith("* "):
        return number, f"'*' at the beginning of {fault.shown(number)}; begin list items with '-'"
    sign = line[column : column + 1]
    advice = _in_quotes(fault, number) if line[:column].strip(" -") else "put it in quotes"
    return number, f"'{sign}' begins the text of {fault.shown(number)}; {advice}"


def _block(fault: Fault) -> Found:
    number, column = fault.begun
    sign = fault.lines[number][column]
    message = f"text after '{sign}' in {fault.shown(number)}"
    return number, f"{message}; begin it on the next line, or {_in_quotes(fault, number)}"


def _dash(fault: Fault) -> Found:
    number = fault.mark[0]
    message = f"a list item after a key in {fault.shown(number)}"
    return number, f"{message}; begin the list on the next line, or {_in_quotes(fault)}"


def _escape(fault: Fault) -> Found:
    number, column = fault.mark
    sign = fault.line[column - 1 : column + 1]
    message = f"'{sign}' means nothing in double quotes in {fault.shown(number)}"
    return number, f"{message}; write '\\{sign}', or use single quotes"


def _no_colon(fault: Fault) -> Found:
    return _without_colon(fault, fault.begun[0])


def _document(fault: Fault) -> Found | None:
    number = fault.mark[0]
    while number and not re.match(r"---|\.\.\.|%", fault.lines[number]):
        number -= 1
    sign = fault.lines[number][:3]
    if sign.startswith("%"):
        return number, f"'%' begins the line {fault.shown(number)}; put it in quotes"
    return (number, f"a line '{sign}' inside the file; remove it") if sign else None


def _in_quotes(fault: Fault, number: int | None = None) -> str:
    """Return the advice to quote the text of a line, with the corrected line."""
    line = fault.line if number is None else fault.lines[number]
    match = ENTRY.fullmatch(re.sub(r"\s+#.*", "", line.rstrip()))
    if not match or len(line) > SHOWN or match["rest"][0] in "\"'":
        return "put the whole text in quotes"
    return f"put it in quotes: {match['key']}: {json.dumps(match['rest'], ensure_ascii=False)}"


# The messages of the parser and their explanations; the first rule that matches is used.
RULES: list[tuple[str, Callable[[Fault], Found | None]]] = [
    (r"found character '\\t'", _tab),
    (r"mapping values are not allowed", _key),
    ("while parsing a flow node", _missing),
    (r"while parsing a flow", _flow),
    (r"quoted scalar found unexpected end", _open_quote),
    (r"found unknown escape", _escape),
    (r"expected <block end>", _rest),
    (r"cannot start any token|scanning an (alias|anchor)|undefined alias", _sign),
    (r"scanning a block scalar", _block),
    (r"sequence entries are not allowed", _dash),
    (r"could not find expected ':'", _no_colon),
    (r"another document|<document start>", _document),
]
