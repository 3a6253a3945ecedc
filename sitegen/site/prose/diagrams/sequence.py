"""Draw a sequence diagram: participants, and the messages between them in order."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from sitegen.site.prose.diagrams import svg
from sitegen.site.prose.diagrams.fault import DiagramError, check_size

MARGIN, HEAD, APART, STEP = 12.0, 44.0, 150.0, 46.0
NAME = r"[\w/.~ -]*?[\w/~]"
PARTICIPANT = re.compile(rf"(?:participant|actor)\s+({NAME})(?:\s+as\s+(.+))?$")
MESSAGE = re.compile(rf"({NAME})\s*(--?)(>>|>|x|\))\s*[+-]?\s*({NAME})\s*[+-]?\s*(?::\s*(.*))?$")
NOTE = re.compile(
    rf"(?i:note)\s+(over|left of|right of)\s+({NAME})(?:\s*,\s*({NAME}))?\s*:\s*(.+)$"
)
FRAMES = ("loop", "alt", "opt", "par", "critical", "break")
BETWEEN = ("else", "and", "option")
# Statements that are ignored: activation is visible from the messages.
PASSED = ("activate", "deactivate", "autonumber")


@dataclass
class _Frame:
    kind: str
    text: str
    top: float
    depth: int
    names: list[str] = field(default_factory=list)
    cuts: list[tuple[float, str]] = field(default_factory=list)


@dataclass
class _Message:
    start: str
    end: str
    text: str
    dashed: bool
    head: str
    y: float = 0


@dataclass
class _Note:
    names: tuple[str, ...]
    side: str
    text: str
    y: float = 0


@dataclass
class _Sequence:
    """The result of parsing so far, and the current height of the drawing."""

    names: dict[str, str] = field(default_factory=dict)
    messages: list[_Message] = field(default_factory=list)
    notes: list[_Note] = field(default_factory=list)
    frames: list[tuple[_Frame, float]] = field(default_factory=list)
    open: list[_Frame] = field(default_factory=list)
    y: float = MARGIN + HEAD

    def know(self, *names: str) -> None:
        """Add participants that are not known yet."""
        for name in names:
            self.names.setdefault(name, name)
            for frame in self.open:
                frame.names.append(name)


def sequence(lines: Sequence[str]) -> str:
    """Return the drawing of a sequence diagram."""
    read = _Sequence()
    for line in lines[1:]:
        _read(line, read)
        check_size(line, len(read.names), len(read.messages), ("participants", "messages"))
    if read.open:
        frame = read.open[-1]
        raise DiagramError(frame.kind, f"'{frame.kind}' is not closed; close it with 'end'")
    if not read.names:
        raise DiagramError(
            lines[0], "this diagram has no messages; write 'client->>server: request'"
        )
    return _draw(read)


def _read(line: str, read: _Sequence) -> None:
    word, _, rest = line.partition(" ")
    if found := PARTICIPANT.match(line):
        read.know(found[1])
        read.names[found[1]] = (found[2] or found[1]).strip()
    elif word in FRAMES:
        read.y += 14
        read.open.append(_Frame(word, rest.strip(), read.y, len(read.open)))
        read.y += 26
    elif word in BETWEEN and read.open:
        read.y += 20
        read.open[-1].cuts.append((read.y, rest.strip()))
        read.y += 16
    elif word == "end" and read.open:
        read.y += 18
        read.frames.append((read.open.pop(), read.y))
    elif word in PASSED:
        return
    elif found := NOTE.match(line):
        names = tuple(filter(None, (found[2], found[3])))
        read.know(*names)
        rows = svg.height(found[4])
        read.notes.append(_Note(names, found[1], found[4], read.y + 14))
        read.y += rows + 26
    elif found := MESSAGE.match(line):
        start, dash, head, end, text = found.groups()
        read.know(start, end)
        read.y += STEP + svg.LINE * (len(svg.lines(text or "")) - 1)
        read.messages.append(_Message(start, end, text or "", dash == "--", head, read.y))
        read.y += 18 if start == end else 0
    else:
        fault = f"'{line}' is not a valid statement; write it like 'client->>server: request'"
        raise DiagramError(line, fault)


def _draw(read: _Sequence) -> str:
    at = _columns(read)
    bottom = read.y + 26
    parts = [svg.path([(x, MARGIN + HEAD), (x, bottom)], "life") for x in at.values()]
    for frame, end in read.frames:
        parts += _frame(frame, end, at)
    for message in read.messages:
        parts += _message(message, at)
    notes = [_note(note, at) for note in read.notes]
    for name, text in read.names.items():
        w = svg.width(text) + 28
        parts.append(svg.rectangle(at[name] - w / 2, MARGIN, w, HEAD - 4, "box", 5))
        parts.append(svg.label(text, at[name], MARGIN + (HEAD - 4) / 2))
    right = max(x + svg.width(read.names[name]) / 2 + 14 for name, x in at.items())
    frames = [_sides(frame, at)[1] for frame, _ in read.frames]
    right = max([right, *frames, *(edge for _, edge in notes), *_own_ends(read, at)])
    said = "; ".join(
        f"{read.names[m.start]} → {read.names[m.end]}: {' '.join(svg.lines(m.text))}"
        for m in read.messages
    )
    drawn = parts + [part for part, _ in notes]
    return svg.drawing(drawn, right + MARGIN, bottom + MARGIN, said or ", ".join(read.names))


def _columns(read: _Sequence) -> dict[str, float]:
    """Return the position of each lifeline: as far apart as the text between them needs."""
    names = list(read.names)
    column = {name: number for number, name in enumerate(names)}
    gaps: list[float] = [
        max(APART, (svg.width(read.names[a]) + svg.width(read.names[b])) / 2 + 48)
        for a, b in pairwise(names)
    ]
    for message in read.messages:
        first, last = sorted((column[message.start], column[message.end]))
        if first == last and first < len(gaps):
            gaps[first] = max(gaps[first], svg.width(message.text) + 60)
        if first < last:
            needed = svg.width(message.text) + 36 - sum(gaps[first:last])
            for gap in range(first, last):
                gaps[gap] += max(needed, 0) / (last - first)
    left = svg.width(read.names[names[0]]) / 2 + 14
    for note in read.notes:
        if note.side == "left of" and column[note.names[0]] == 0:
            left = max(left, svg.width(note.text) + 40)
        if note.side == "over" and column[note.names[0]] == 0:
            left = max(left, svg.width(note.text) / 2 + 20)
    at = [MARGIN + left + 10 * bool(read.frames)]
    for apart in gaps:
        at.append(at[-1] + apart)
    return dict(zip(names, at, strict=True))


def _own_ends(read: _Sequence, at: dict[str, float]) -> list[float]:
    return [at[m.start] + svg.width(m.text) + 60 for m in read.messages if m.start == m.end]


def _message(message: _Message, at: dict[str, float]) -> list[str]:
    a, b, y = at[message.start], at[message.end], message.y
    name = "arrow dashed" if message.dashed else "arrow"
    if message.start == message.end:
        points = [(a, y), (a + 40, y), (a + 40, y + 20), (a + 2, y + 20)]
        text = svg.label(message.text, a + 48, y + 10, "quiet", "start")
    else:
        points = [(a, y), (b - 2 if b > a else b + 2, y)]
        rows = svg.height(message.text)
        text = svg.label(message.text, (a + b) / 2, y - 6 - rows / 2, "quiet")
    end, before = points[-1], points[-2]
    parts = [svg.path(points, name), text]
    if message.head == "x":
        parts.append(svg.path([(end[0] - 5, end[1] - 5), (end[0] + 5, end[1] + 5)], "arrow"))
        parts.append(svg.path([(end[0] - 5, end[1] + 5), (end[0] + 5, end[1] - 5)], "arrow"))
    elif message.head != ">":
        parts.append(svg.arrow(end, before))
    return parts


def _note(note: _Note, at: dict[str, float]) -> tuple[str, float]:
    """Return a note, and its right edge."""
    w, h = svg.width(note.text) + 24, svg.height(note.text) + 12
    xs = [at[name] for name in note.names]
    if note.side == "over":
        w = max(w, max(xs) - min(xs) + 40)
        left = (min(xs) + max(xs) - w) / 2
    else:
        left = xs[0] + 12 if note.side == "right of" else xs[0] - 12 - w
    text = svg.label(note.text, left + w / 2, note.y + h / 2)
    return svg.rectangle(left, note.y, w, h, "note") + text, left + w


def _frame(frame: _Frame, end: float, at: dict[str, float]) -> list[str]:
    left, right = _sides(frame, at)
    title = f"{frame.kind} [{frame.text}]" if frame.text else frame.kind
    parts = [
        svg.rectangle(left, frame.top, right - left, end - frame.top, "frame", 4),
        svg.label(title, left + 8, frame.top + 13, "quiet", "start"),
    ]
    for y, text in frame.cuts:
        parts.append(svg.path([(left, y - 4), (right, y - 4)], "cut"))
        if text:
            parts.append(svg.label(f"[{text}]", left + 8, y + 9, "quiet", "start"))
    return parts


def _sides(frame: _Frame, at: dict[str, float]) -> tuple[float, float]:
    xs = [at[name] for name in frame.names] or list(at.values())
    inset = 10 * frame.depth
    title = svg.width(f"{frame.kind} [{frame.text}]") + 16
    left = max(min(xs) - 56, 4) + inset
    return left, max(max(xs) + 56 - inset, left + title)
