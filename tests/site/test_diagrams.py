"""Diagrams are drawn at build, and what cannot be drawn is told."""

from __future__ import annotations

import re
from itertools import combinations

import pytest
from paths import ROOT

from sitegen.site.prose.diagrams import DiagramError, drawn


def boxes(svg: str) -> list[tuple[float, float, float, float]]:
    found = re.findall(r'<rect class="box" x="(.*?)" y="(.*?)" width="(.*?)" height="(.*?)"', svg)
    return [tuple(map(float, box)) for box in found]  # type: ignore[misc]


def texts(svg: str) -> list[str]:
    return re.findall(r"<tspan.*?>(.*?)</tspan>", svg)


def said(svg: str) -> str:
    return svg.split('aria-label="')[1].split('"')[0]


def test_a_flowchart_says_what_leads_where() -> None:
    svg = drawn("flowchart LR\n  talker([/talker]) -->|String| topic[/chatter]\n topic --> a & b")
    assert said(svg) == "/talker → /chatter (String); /chatter → a; /chatter → b"
    assert sorted(texts(svg)) == ["/chatter", "/talker", "String", "a", "b"]
    assert svg.count('class="head"') == 3


@pytest.mark.parametrize("direction", ["LR", "RL", "TB", "BT"])
def test_boxes_follow_the_direction(direction: str) -> None:
    first, second, third = boxes(drawn(f"graph {direction}\n a --> b --> c"))
    place = 0 if direction in ("LR", "RL") else 1
    along = [first[place], second[place], third[place]]
    assert along == sorted(along, reverse=direction in ("RL", "BT"))


def test_boxes_never_overlap() -> None:
    edges = [(a, b) for a, b in combinations("abcdefgh", 2) if (ord(a) + ord(b)) % 3]
    svg = drawn("graph TB\n" + "\n".join(f"{a}[Box {a}] --> {b}" for a, b in edges))
    placed = boxes(svg)
    assert len(placed) == 8
    for (x, y, w, h), (u, v, p, q) in combinations(placed, 2):
        assert x + w <= u or u + p <= x or y + h <= v or v + q <= y


def test_circles_of_arrows_and_own_arrows_are_drawn() -> None:
    svg = drawn("graph TD\n a --> b --> c --> a\n b --> b")
    assert said(svg) == "a → b; b → c; c → a; b → b"
    assert svg.count('class="head"') == 4


def test_all_arrows_and_shapes() -> None:
    svg = drawn(
        "graph LR\n a((a)) --- b{b}\n b -.-> c[(c)]\n c ==> d{{d}}\n d <--> e(e)\n e -- text --> f"
    )
    assert 'class="arrow dotted"' in svg
    assert 'class="arrow thick"' in svg
    assert svg.count('class="head"') == 5
    assert "text" in texts(svg)


def test_a_sequence_says_who_says_what() -> None:
    svg = drawn(
        "sequenceDiagram\n  participant c as client\n c->>s: add\n Note over c,s: waits\n"
        " s-->>c: sum\n loop twice\n c->>c: count\n end"
    )
    assert said(svg) == "client → s: add; s → client: sum; client → client: count"
    assert texts(svg).count("client") == 1
    assert "loop [twice]" in texts(svg)
    assert "waits" in texts(svg)


def test_everything_is_inside_of_the_drawing() -> None:
    svg = drawn("sequenceDiagram\n a->>b: a rather long request\n Note right of b: and a long note")
    width = float(svg.split('viewBox="0 0 ')[1].split()[0])
    ends = [float(x) + float(w) for x, w in re.findall(r'<rect .*?x="(.*?)".*?width="(.*?)"', svg)]
    assert max(ends) <= width


def test_texts_are_escaped() -> None:
    svg = drawn('graph LR\n a["<b>&"] --> b')
    assert "<b>" not in svg
    assert "&lt;b&gt;&amp;" in svg


@pytest.mark.parametrize(
    ("source", "line", "fault"),
    [
        ("pie\n a", "pie", "'pie' is not a supported diagram; start with 'flowchart LR' or"),
        ("graph XY\n a", "graph XY", "'XY' is not a valid direction; write 'flowchart LR'"),
        ("graph LR\n a => b", "a => b", "'=> b' is not a valid arrow; write it like 'a --> b'"),
        ("graph LR\n a --> ", "a -->", "expected a box before ''"),
        ("graph LR\n a[b", "a[b", "'[' is not closed; close it with ']'"),
        ("graph LR\n subgraph x", "subgraph x", "'subgraph' is not supported"),
        ("graph LR", "graph LR", "this flowchart has no boxes"),
        ("sequenceDiagram\n hello", "hello", "'hello' is not a valid statement"),
        (
            "sequenceDiagram\n loop x\n a->>b: c",
            "loop",
            "'loop' is not closed; close it with 'end'",
        ),
        ("", "", "'' is not a supported diagram"),
    ],
)
def test_what_cannot_be_drawn_is_told(source: str, line: str, fault: str) -> None:
    with pytest.raises(DiagramError) as wrong:
        drawn(source)
    assert wrong.value.line == line
    assert fault in str(wrong.value)


def test_classes_are_those_of_diagrams_alone() -> None:
    """A rule of the page for a class of the drawing would bend it."""
    theme = ROOT / "themes/default"
    rules = "\n".join(file.read_text() for file in theme.glob("*.css"))
    drawings = drawn("graph LR\n a ==>|x| b -.-> c") + drawn(
        "sequenceDiagram\n a-->>b: x\n loop y\n Note over a: z\n end"
    )
    names = {name for names in re.findall(r'class="(.*?)"', drawings) for name in names.split()}
    names.discard("diagram")
    assert {"arrow", "box", "frame", "head", "label", "life", "note", "paper"} <= names
    assert [n for n in sorted(names) if re.search(rf"^ *\.{n}\b[^\n]*{{", rules, re.M)] == []
