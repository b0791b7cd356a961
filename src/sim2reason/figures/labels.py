"""Where labels stand: not on each other, and not on lines if it can be helped."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from sim2reason.figures.shapes import Arc, Area, Label, Line, Shape, Wanted, outline
from sim2reason.figures.vectors import Box, Polygon, common, depth, length_inside

CLEAR = 0.06  # kept free around a label
SWEEPS = 4
WHEEL, NEAR, MISTAKEN = 0.3, 0.75, 1.6  # a letter this near to another pulley than its own could be taken for its name
ON_LABEL, ON_LINE, IN_BLOCK, LATER = (
    60.0,
    7.0,
    4.0,
    0.12,
)  # what it costs; the last for each place further down the list


def placed(wanted: Sequence[Wanted], shapes: Sequence[Shape]) -> tuple[Label, ...]:
    """Every label at the best of its places: first those with the least choice, then all again in turn."""
    strokes, blocks = _strokes(shapes), [outline(s) for s in shapes if not isinstance(s, Line) and s.fill == "block"]
    order = sorted(range(len(wanted)), key=lambda n: (len(wanted[n].places), n))
    wheels = [s for s in shapes if isinstance(s, Arc) and s.whole and s.radius > WHEEL]
    alone = {
        n: [
            _alone(label, index, strokes, blocks) + _mistaken(label, wanted[n], wheels)
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
    return tuple(replace(chosen[n], crossed=_under(chosen[n].box, strokes) > 0.0) for n in range(len(wanted)))


def _options(wanted: Wanted) -> list[Label]:
    return [Label(wanted.text, place, wanted.subject, wanted.size, wanted.name) for place in wanted.places]


def _crowded(label: Label, others: Sequence[Box]) -> float:
    mine = _wider(label.box)
    return sum(ON_LABEL * shared + 5.0 for other in others if (shared := common(mine, other)) > 0.0)


def _alone(
    label: Label, index: int, strokes: Sequence[tuple[complex, complex, float]], blocks: Sequence[Polygon]
) -> float:
    """What a place costs whatever the other labels do."""
    mine = _wider(label.box)
    left, low, right, high = mine
    corners = (complex(left, low), complex(right, low), complex(right, high), complex(left, high))
    return (
        LATER * index
        + ON_LINE * _under(mine, strokes)
        + sum(IN_BLOCK for block in blocks if depth(corners, block) > 0.0)
    )


def _under(area: Box, strokes: Sequence[tuple[complex, complex, float]]) -> float:
    """The length of the strokes that run through a box, by their weights."""
    return sum(weight * length_inside(a, b, area) for a, b, weight in strokes)


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


def _strokes(shapes: Sequence[Shape]) -> list[tuple[complex, complex, float]]:
    """Everything as segments, with a weight: hair lines are less of a nuisance."""
    found: list[tuple[complex, complex, float]] = []
    for shape in shapes:
        if isinstance(shape, Line):
            points, weight = shape.points, 0.5 if shape.weight == "hair" else 1.0
        else:
            points, weight = outline(shape), 1.0
            points = (*points, points[0]) if isinstance(shape, Area) or shape.whole else points
        found += [(a, b, weight) for a, b in pairwise(points)]
    return found
