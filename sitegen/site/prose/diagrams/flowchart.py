"""Draw a flowchart: boxes, and arrows between them."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from sitegen.site.prose.diagrams import svg
from sitegen.site.prose.diagrams.fault import DiagramError, check_size
from sitegen.site.prose.diagrams.layers import Box, place
from sitegen.site.prose.diagrams.svg import Point

DIRECTIONS = {"TB", "TD", "BT", "LR", "RL"}
MARGIN, LOOP = 12.0, 36.0

# The delimiters of the text of a box, longer ones first.
SHAPES = {
    ("([", "])"): "stadium",
    ("((", "))"): "circle",
    ("{{", "}}"): "hexagon",
    ("[(", ")]"): "store",
    ("[", "]"): "box",
    ("(", ")"): "round",
    ("{", "}"): "diamond",
}
NAME = re.compile(r"[\w/.~-]*?[\w/~](?=\s|$|[(\[{&]|-{2}|-\.|==|<)")
ARROW = re.compile(
    r"(?P<back><)?(?P<line>-{2,3}|-\.+-?|={2,3})"
    r"(?:(?P<head>>)|(?P<text>\s*[^-=.>|\s][^>|]*?\s*)(?:-{2,3}|\.+-|={2,3})(?P<end>>)?)?"
    r"(?:\|(?P<bar>[^|]*)\|)?"
)
PARTS = ("boxes", "arrows")
REFUSED = {"subgraph", "end", "classDef", "class", "style", "linkStyle", "click", "direction"}


@dataclass
class _Chart:
    """The result of parsing: the text and the shape of each box, and the arrows."""

    boxes: dict[str, tuple[str, str]] = field(default_factory=dict)
    arrows: list[_Arrow] = field(default_factory=list)


@dataclass(frozen=True)
class _Arrow:
    start: str
    end: str
    text: str
    line: str
    head: bool
    back: bool


def flowchart(lines: Sequence[str]) -> str:
    """Return the drawing of a flowchart, whose first line has its direction."""
    _, _, direction = lines[0].partition(" ")
    direction = direction.strip() or "TB"
    if direction not in DIRECTIONS:
        raise DiagramError(
            lines[0], f"'{direction}' is not a valid direction; write 'flowchart LR'"
        )
    chart = _Chart()
    for line in lines[1:]:
        for statement in filter(None, map(str.strip, line.split(";"))):
            _read(statement, chart)
            check_size(line, len(chart.boxes), len(chart.arrows), PARTS)
    if not chart.boxes:
        raise DiagramError(lines[0], "this flowchart has no boxes; write 'talker --> listener'")
    return _draw(chart, direction)


def _read(line: str, chart: _Chart) -> None:
    if line.split()[0] in REFUSED:
        fault = f"'{line.split()[0]}' is not supported; use boxes and arrows"
        raise DiagramError(line, fault)
    rest, starts = line, list[str]()
    arrow: re.Match[str] | None = None
    while True:
        names, rest = _names(rest, line, chart)
        if arrow:
            check_size(line, len(chart.boxes), len(starts) * len(names), PARTS)
            chart.arrows += [_arrow(a, b, arrow) for a in starts for b in names]
        if not rest:
            return
        arrow = ARROW.match(rest)
        if not arrow:
            raise DiagramError(line, f"'{rest}' is not a valid arrow; write it like 'a --> b'")
        rest, starts = rest[arrow.end() :].lstrip(), names


def _arrow(start: str, end: str, found: re.Match[str]) -> _Arrow:
    text = (found["bar"] or found["text"] or "").strip().strip('"')
    line = {"-.": "dotted", "==": "thick"}.get(found["line"][:2], "")
    head = bool(found["head"] or found["end"])
    return _Arrow(start, end, text, line, head, bool(found["back"]))


def _names(rest: str, line: str, chart: _Chart) -> tuple[list[str], str]:
    """Return the boxes at the start of `rest`, as in `a & b[Text]`, and the text after them."""
    names = []
    while True:
        found = NAME.match(rest)
        if not found:
            raise DiagramError(line, f"expected a box before '{rest}'; write it like 'a[Text]'")
        name, rest = found[0], rest[found.end() :]
        text, shape = name, ""
        for (opening, closing), kind in SHAPES.items():
            if rest.startswith(opening):
                inner, end, after = rest[len(opening) :].partition(closing)
                if not end:
                    raise DiagramError(
                        line, f"'{opening}' is not closed; close it with '{closing}'"
                    )
                text, shape, rest = inner.strip().strip('"'), kind, after
                break
        if shape or name not in chart.boxes:
            chart.boxes[name] = (text, shape or "box")
        names.append(name)
        rest = rest.lstrip()
        if not rest.startswith("&"):
            return names, rest
        rest = rest[1:].lstrip()


def _draw(chart: _Chart, direction: str) -> str:
    sideways = direction in ("LR", "RL")
    own = {arrow.start: arrow for arrow in chart.arrows if arrow.start == arrow.end}
    arrows = [arrow for arrow in chart.arrows if arrow.start != arrow.end]
    boxes = {}
    for name, (text, shape) in chart.boxes.items():
        w, h = _size(text, shape)
        # An arrow to itself is at the right of its box, which stays in the middle of its space.
        w += 2 * (LOOP + svg.width(own[name].text)) if name in own else 0
        boxes[name] = Box(h, w) if sideways else Box(w, h)
    ways = place(boxes, [(a.start, a.end, _label_size(a.text, sideways)) for a in arrows])
    total = (
        max(box.x + box.across / 2 for box in [*boxes.values(), *(b for way in ways for b in way)]),
        max(box.y + box.down / 2 for box in boxes.values()),
    )

    def at(box: Box) -> Point:
        x, y = box.x, total[1] - box.y if direction in ("BT", "RL") else box.y
        return (y + MARGIN, x + MARGIN) if sideways else (x + MARGIN, y + MARGIN)

    parts, labels = [], []
    for arrow, way in zip(arrows, ways, strict=True):
        points = [at(box) for box in way]
        points[0] = _edge(points[0], points[1], *chart.boxes[arrow.start])
        points[-1] = _edge(points[-1], points[-2], *chart.boxes[arrow.end])
        parts.append(_line(arrow, points))
        labels.append(_label(arrow.text, *points[len(points) // 2]))
    for name, arrow in own.items():
        (x, y), (w, _) = at(boxes[name]), _size(*chart.boxes[name])
        right = x + w / 2
        points = [
            (right, y - 8),
            (right + LOOP - 8, y - 9),
            (right + LOOP - 8, y + 9),
            (right, y + 8),
        ]
        parts.append(_line(arrow, points))
        labels.append(_label(arrow.text, right + LOOP + svg.width(arrow.text) / 2, y))
    for name, (text, shape) in chart.boxes.items():
        x, y = at(boxes[name])
        w, h = _size(text, shape)
        parts.append(_OUTLINES.get(shape, _rounded)(x, y, w, h) + svg.label(text, x, y))
    size = (total[1], total[0]) if sideways else total
    return svg.drawing(parts + labels, size[0] + 2 * MARGIN, size[1] + 2 * MARGIN, _said(chart))


def _line(arrow: _Arrow, points: Sequence[Point]) -> str:
    line = svg.path(points, f"arrow {arrow.line}".strip(), smooth=True)
    head = svg.arrow(points[-1], points[-2]) if arrow.head else ""
    return line + head + (svg.arrow(points[0], points[1]) if arrow.back else "")


def _label(text: str, x: float, y: float) -> str:
    if not text:
        return ""
    w, h = svg.width(text) + 8, svg.height(text)
    paper = svg.rectangle(x - w / 2, y - h / 2, w, h, "paper")
    return paper + svg.label(text, x, y, "quiet")


def _said(chart: _Chart) -> str:
    """Return a description of the chart in words."""
    names = {name: " ".join(svg.lines(text)) for name, (text, _) in chart.boxes.items()}
    said = [
        f"{names[a.start]} → {names[a.end]}{f' ({a.text})' if a.text else ''}" for a in chart.arrows
    ]
    joined = {name for arrow in chart.arrows for name in (arrow.start, arrow.end)}
    return "; ".join(said + [text for name, text in names.items() if name not in joined])


def _size(text: str, shape: str) -> Point:
    w, h = svg.width(text) + 32, svg.height(text) + 20
    if shape == "circle":
        return max(w, h), max(w, h)
    if shape == "diamond":
        return 1.5 * w, 1.9 * h
    return (w + 20, h + 12 * (shape == "store")) if shape not in ("box", "round") else (w, h)


def _label_size(text: str, sideways: bool) -> Point:
    if not text:
        return 0, 0
    w, h = svg.width(text) + 16, svg.height(text) + 8
    return (h, w) if sideways else (w, h)


def _edge(middle: Point, towards: Point, text: str, shape: str) -> Point:
    """Return the point where the line from the middle of a box towards a point leaves the box."""
    x, y = towards[0] - middle[0], towards[1] - middle[1]
    if not x and not y:
        return middle
    w, h = _size(text, shape)
    across, down = 2 * abs(x) / w, 2 * abs(y) / h
    factor = 1 / (across + down if shape == "diamond" else max(across, down))
    return middle[0] + x * min(factor, 1), middle[1] + y * min(factor, 1)


def _rounded(x: float, y: float, w: float, h: float) -> str:
    return svg.rectangle(x - w / 2, y - h / 2, w, h, "box", 5)


def _stadium(x: float, y: float, w: float, h: float) -> str:
    return svg.rectangle(x - w / 2, y - h / 2, w, h, "box", h / 2)


def _store(x: float, y: float, w: float, h: float) -> str:
    left, top, bottom = x - w / 2, y - h / 2 + 6, y + h / 2 - 6
    n = svg.number
    arc = f"a{n(w / 2)} 6 0 0 1 {n(w)} 0"
    side = f"V{n(bottom)}a{n(w / 2)} 6 0 0 1 {n(-w)} 0V{n(top)}a{n(w / 2)} 6 0 0 0 {n(w)} 0"
    return f'<path class="box" d="M{n(left)} {n(top)}{arc}{side}"/>'


def _shape(*corners: Point) -> Callable[[float, float, float, float], str]:
    """Return the path of a box whose corners are given in units of half its size."""

    def outline(x: float, y: float, w: float, h: float) -> str:
        return svg.polygon([(x + a * w / 2, y + b * h / 2) for a, b in corners], "box")

    return outline


_OUTLINES: dict[str, Callable[[float, float, float, float], str]] = {
    "round": lambda x, y, w, h: svg.rectangle(x - w / 2, y - h / 2, w, h, "box", 14),
    "stadium": _stadium,
    "circle": _stadium,
    "store": _store,
    "diamond": _shape((0, -1), (1, 0), (0, 1), (-1, 0)),
    "hexagon": _shape((-0.85, -1), (0.85, -1), (1, 0), (0.85, 1), (-0.85, 1), (-1, 0)),
}
