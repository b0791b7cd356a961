"""Where labels stand: not on each other, and not on lines if it can be helped."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple

from sim2reason.figures.shapes import Arc, Area, Label, LineShape, Shape, Wanted, outline
from sim2reason.figures.vectors import Box, Polygon, common, depth, inside, length_inside, unit

CLEAR = 0.06  # kept free around a label
SWEEPS = 4
WHEEL, NEAR, MISTAKEN = 0.3, 0.75, 1.6  # a letter this near to another pulley than its own could be taken for its name
ON_LABEL, ON_LINE, IN_BLOCK, LATER = (
    60.0,
    7.0,
    4.0,
    0.12,
)  # what it costs; the last for each place further down the list

HEAD, HEADED = 0.22, 6.0  # of an arrow: how long it is, and how much worse than a line to stand on; it tells the way
LIGHT = {"hair": 0.5, "dots": 0.15}  # how much less of a nuisance under a label


class Stroke(NamedTuple):
    """A straight part of an outline; `order` counts the shapes from back to front."""

    a: complex
    b: complex
    weight: float
    order: int


def placed(wanted: Sequence[Wanted], shapes: Sequence[Shape]) -> tuple[Label, ...]:
    """Every label at the best of its places: first those with the least choice, then all again in turn."""
    strokes, blocks = (
        _strokes(shapes),
        [outline(s) for s in shapes if not isinstance(s, LineShape) and s.fill == "block"],
    )
    grounds = [(n, outline(s)) for n, s in enumerate(shapes) if not isinstance(s, LineShape) and s.fill]
    order = sorted(range(len(wanted)), key=lambda n: (len(wanted[n].places), n))
    wheels = [s for s in shapes if isinstance(s, Arc) and s.whole and s.radius > WHEEL]
    alone = {
        n: [
            _alone(label, index, _seen(label, strokes, grounds), blocks) + _mistaken(label, wanted[n], wheels)
            for index, label in enumerate(_options(wanted[n]))
        ]
        for n in order
    }
    chosen: dict[int, Label] = {}
    for _ in range(SWEEPS):
        for n in order:
            others = [label.box for m, label in chosen.items() if m != n]
            options = _options(wanted[n])
            costs = [alone[n][i] + _crowded(label, others) for i, label in enumerate(options)]
            chosen[n] = options[costs.index(min(costs))]
    final = (chosen[n] for n in range(len(wanted)))
    return tuple(replace(each, crossed=_under(each.box, _seen(each, strokes, grounds)) > 0.0) for each in final)


def _seen(label: Label, strokes: Sequence[Stroke], grounds: Sequence[tuple[int, Polygon]]) -> list[Stroke]:
    """The strokes that no filled shape hides where the label stands; the outline of that shape is one of them."""
    above = max((n for n, polygon in grounds if inside(label.at, polygon)), default=-1)
    return [stroke for stroke in strokes if stroke.order >= above]


def _options(wanted: Wanted) -> list[Label]:
    return [Label(wanted.text, place, wanted.subject, wanted.size, wanted.name) for place in wanted.places]


def _crowded(label: Label, others: Sequence[Box]) -> float:
    mine = _wider(label.box)
    return sum(ON_LABEL * shared + 5.0 for other in others if (shared := common(mine, other)) > 0.0)


def _alone(label: Label, index: int, strokes: Sequence[Stroke], blocks: Sequence[Polygon]) -> float:
    """What a place costs whatever the other labels do; the first may well be within a block, which is its own."""
    mine = _wider(label.box)
    left, low, right, high = mine
    corners = (complex(left, low), complex(right, low), complex(right, high), complex(left, high))
    return (
        LATER * index
        + ON_LINE * _under(mine, strokes)
        + sum(IN_BLOCK for block in blocks if depth(corners, block) > 0.0 and (index or not inside(label.at, block)))
    )


def _under(area: Box, strokes: Sequence[Stroke]) -> float:
    """The length of the strokes that run through a box, by their weights."""
    return sum(stroke.weight * length_inside(stroke.a, stroke.b, area) for stroke in strokes)


def _mistaken(label: Label, wanted: Wanted, wheels: Sequence[Arc]) -> float:
    """What it costs to stand beside a pulley that has another name."""
    if len(wanted.places) < 2 or not wanted.name or not wheels:
        return 0.0
    middle = sum(wanted.places) / len(wanted.places)
    own = min(wheels, key=lambda wheel: abs(wheel.center - middle))
    others = [wheel for wheel in wheels if wheel is not own]
    return MISTAKEN * sum(abs(wheel.center - label.at) < wheel.radius + NEAR for wheel in others)


def _wider(held: Box) -> Box:
    return held[0] - CLEAR, held[1] - CLEAR, held[2] + CLEAR, held[3] + CLEAR


def _strokes(shapes: Sequence[Shape]) -> list[Stroke]:
    """Everything as segments, with a weight: hair lines are less of a nuisance."""
    found: list[Stroke] = []
    for order, shape in enumerate(shapes):
        if isinstance(shape, LineShape):
            points, weight = shape.points, LIGHT.get(shape.weight, 1.0)
        else:
            points, weight = outline(shape), 1.0
            points = (*points, points[0]) if isinstance(shape, Area) or shape.whole else points
        found += [Stroke(a, b, weight, order) for a, b in pairwise(points)]
        if isinstance(shape, LineShape) and shape.arrow:
            tip, way = points[-1], unit(points[-1] - points[-2])
            found.append(Stroke(tip - HEAD * way, tip, HEADED, order))
    return found
