"""Place the boxes of a graph in layers, so that arrows lead from each layer to the next.

This is Sugiyama's method: reverse arrows that close a cycle, put every box as far down as its
arrows require, sort the layers to reduce crossings, then move boxes towards those that they are
connected to.
"""

from __future__ import annotations

import bisect
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

ACROSS, DOWN, BESIDE_ARROW = 36.0, 48.0, 18.0
ROUNDS = 12


@dataclass
class Box:
    """A box: its size, and its middle once it is placed. Arrows pass through boxes of their own."""

    across: float
    down: float
    passed: bool = False
    layer: int = 0
    x: float = 0
    y: float = 0
    above: list[Box] = field(default_factory=list)
    below: list[Box] = field(default_factory=list)


def place(
    boxes: Mapping[str, Box], arrows: Sequence[tuple[str, str, tuple[float, float]]]
) -> list[list[Box]]:
    """Place `boxes` and return, for each arrow, the boxes that it passes through, ends included.

    An arrow is its two ends and the size of its label, (0, 0) without one; the box of the label is
    in the middle of the path.
    """
    turned = _turned([(a, b) for a, b, _ in arrows], boxes)
    ends = [(b, a) if turn else (a, b) for (a, b, _), turn in zip(arrows, turned, strict=True)]
    # Twice as many layers as boxes need, so that every arrow has a layer for its label.
    for name, layer in _depths(ends, boxes).items():
        boxes[name].layer = 2 * layer
    ways = []
    for (upper, lower), (_, _, label) in zip(ends, arrows, strict=True):
        ways.append(_way(boxes[upper], boxes[lower], label))
    every = [*boxes.values()]
    every += [box for way in ways for box in way[1:-1]]
    layers: list[list[Box]] = [[] for _ in range(max((b.layer for b in every), default=0) + 1)]
    for box in every:
        layers[box.layer].append(box)
    _sort(layers)
    _align(layers)
    _stack(layers)
    return [way[::-1] if turn else way for way, turn in zip(ways, turned, strict=True)]


def _turned(arrows: Sequence[tuple[str, str]], names: Iterable[str]) -> list[bool]:
    """Return the arrows that lead back to a box from which they can be reached."""
    below: dict[str, list[str]] = {name: [] for name in names}
    for a, b in arrows:
        below[a].append(b)
    order: dict[str, int] = {}
    for name in below:
        _visit(name, below, order, set())
    return [order[a] < order[b] for a, b in arrows]


def _visit(
    name: str, below: Mapping[str, list[str]], order: dict[str, int], open_: set[str]
) -> None:
    if name in order or name in open_:
        return
    open_.add(name)
    for other in below[name]:
        _visit(other, below, order, open_)
    # A box is visited after all boxes that it leads to, except by reversed arrows.
    order[name] = len(order)


def _depths(arrows: Sequence[tuple[str, str]], names: Iterable[str]) -> dict[str, int]:
    depths = dict.fromkeys(names, 0)
    for _ in depths:
        before = dict(depths)
        for a, b in arrows:
            if a != b:
                depths[b] = max(depths[b], depths[a] + 1)
        if depths == before:
            break
    return depths


def _way(upper: Box, lower: Box, label: tuple[float, float]) -> list[Box]:
    """Connect two boxes through one box in each layer between them."""
    count = lower.layer - upper.layer - 1
    between = [Box(0, 0, passed=True, layer=upper.layer + 1 + i) for i in range(max(count, 0))]
    if between:
        middle = between[len(between) // 2]
        middle.across, middle.down = label
    way = [upper, *between, lower]
    for a, b in pairwise(way):
        a.below.append(b)
        b.above.append(a)
    return way


def _sort(layers: Sequence[list[Box]]) -> None:
    """Sort each layer by the positions of the neighbours, down and up; keep the best order."""
    best, least = [list(layer) for layer in layers], _crossings(layers)
    places = _places(layers)
    for round_ in range(ROUNDS):
        down = round_ % 2 == 0
        for layer in layers[1:] if down else layers[-2::-1]:
            # A box without neighbours stays in place.
            layer.sort(key=lambda box: _mean(box.above if down else box.below, box, places))
            places |= _places([layer])
        crossings = _crossings(layers)
        if crossings < least:
            best, least = [list(layer) for layer in layers], crossings
    for layer, kept in zip(layers, best, strict=True):
        layer[:] = kept


def _places(layers: Sequence[list[Box]]) -> dict[int, float]:
    return {id(box): place for layer in layers for place, box in enumerate(layer)}


def _mean(others: Sequence[Box], box: Box, places: Mapping[int, float]) -> float:
    found = [places[id(other)] for other in others if other is not box]
    return sum(found) / len(found) if found else places[id(box)]


def _crossings(layers: Sequence[list[Box]]) -> int:
    places = _places(layers)
    count = 0
    for layer in layers:
        ends = [places[id(b)] for a in layer for b in sorted(a.below, key=lambda c: places[id(c)])]
        before: list[float] = []
        for place, end in enumerate(ends):
            count += place - bisect.bisect_right(before, end)
            bisect.insort(before, end)
    return count


def _align(layers: Sequence[list[Box]]) -> None:
    """Move the boxes of each layer towards their neighbours as far as there is space."""
    for layer in layers:
        _spread(layer, [0.0] * len(layer))
    for round_ in range(ROUNDS):
        down = round_ % 2 == 0
        for layer in layers if down else reversed(layers):
            wanted = []
            for box in layer:
                others = (box.above if down else box.below) or (box.below if down else box.above)
                xs = [other.x for other in others if other is not box]
                wanted.append(sum(xs) / len(xs) if xs else box.x)
            _spread(layer, wanted)


def _spread(layer: Sequence[Box], wanted: Sequence[float]) -> None:
    """Place boxes as close to `wanted` as their sizes allow: least squares, order preserved."""
    offsets, at = [], 0.0
    for box, following in zip(layer, [*layer[1:], None], strict=True):
        offsets.append(at)
        if following:
            gap = BESIDE_ARROW if box.passed or following.passed else ACROSS
            at += (box.across + following.across) / 2 + gap
    groups: list[tuple[float, int]] = []
    for want, offset in zip(wanted, offsets, strict=True):
        groups.append((want - offset, 1))
        while len(groups) > 1 and groups[-2][0] >= groups[-1][0]:
            (one, many), (two, more) = groups[-2:]
            groups[-2:] = [((one * many + two * more) / (many + more), many + more)]
    shifts = [shift for shift, many in groups for _ in range(many)]
    for box, shift, offset in zip(layer, shifts, offsets, strict=True):
        box.x = shift + offset


def _stack(layers: Sequence[list[Box]]) -> None:
    left = min((box.x - box.across / 2 for layer in layers for box in layer), default=0)
    y = 0.0
    for layer in layers:
        down = max((box.down for box in layer), default=0)
        for box in layer:
            box.x -= left
            box.y = y + down / 2
        # Between two layers of boxes is one of labels, which has half the distance.
        y += down + DOWN / 2
