"""Placement of labels in a figure, and replacement of unknown lengths and angles by other values."""

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import combinations, pairwise, product
from math import copysign
from typing import NamedTuple

from sim2reason.errors import SceneError
from sim2reason.figures.plane import (
    Box,
    Polygon,
    crosses,
    depth,
    hull,
    inside,
    length_inside,
    overlap_area,
    unit_vector,
)
from sim2reason.figures.shapes import Arc, Area, Drawing, Label, LabelRequest, LineShape, Shape, outline
from sim2reason.questions.unknown import find_limits
from sim2reason.scenes.dsl.model import Parameter
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.units import parse_unit
from sim2reason.text.prose.description import Description

DISGUISE_FACTORS = (1.3, 0.75, 1.2, 0.85, 1.5, 0.6, 0.5, 1.8, 2.4, 0.88, 1.12)
"""Factors by which the value of an unknown, with two digits, is multiplied, in the order of trial."""
MIN_DISGUISE = 0.1  # relative difference between the drawn and the true value, at least
QUADRANT, RIGHT_ANGLE_MARGIN = 90.0, 5.0  # degrees; margin of a drawn angle from multiples of a right angle
SCALES = (parse_unit("m").dimension, parse_unit("deg").dimension)
MINOR = ("hair", "dots")  # strokes whose number depends on sizes
CONTACT_OVERLAP = 0.02  # units; smaller overlaps of outlines count as contact

Draw = Callable[[Scene], Drawing]


def unknowns(scene: Scene, description: Description) -> tuple[str, ...]:
    """Return the addresses of the lengths and angles that the text leaves unknown, if it states some number.

    A text with only symbols asks for a formula, so no figure hides anything.
    """
    stated, symbolic = frozenset(description.told), frozenset(description.symbolic)
    own = {p.path: p for p in scene.parameters if p.value and not p.hidden}
    if len(symbolic) > 1 and not any(path in stated and path not in symbolic for path in own):
        return ()
    return tuple(path for path, parameter in own.items() if path in symbolic and _is_drawn_to_scale(parameter))


def _is_drawn_to_scale(parameter: Parameter) -> bool:
    unit_vector = parameter.measure.unit
    return bool(unit_vector) and parse_unit(unit_vector).dimension in SCALES


def disguise_unknowns(scene: Scene, description: Description, draw: Draw) -> tuple[Scene, Drawing]:
    """Return a scene in which unknown lengths and angles have other values, and its drawing.

    Each unknown gets the first value for which the drawing has the same parts and labels, or else the same parts;
    without such a value it is unchanged.
    """
    drawing = draw(scene)
    for path in unknowns(scene, description):
        scene, drawing = _other(scene, drawing, path, draw)
    return scene, drawing


def _other(scene: Scene, drawing: Drawing, path: str, draw: Draw) -> tuple[Scene, Drawing]:
    """Return the scene and its drawing with another value for one number, or both unchanged if none is found."""
    parts, texts = _parts(drawing), _texts(drawing)
    second: tuple[Scene, Drawing] | None = None
    for other in _others(scene, path):
        drawn = draw(other)
        if _parts(drawn) == parts:
            if _texts(drawn) == texts:
                return other, drawn
            second = second or (other, drawn)
    return second or (scene, drawing)


def _others(scene: Scene, path: str) -> Iterator[Scene]:
    """Yield valid scenes with other values of a number and the same connections."""
    parameter = next(p for p in scene.parameters if p.path == path)
    value, (lower, most) = parameter.value or 0.0, find_limits(scene, path)
    rounded = float(f"{value:.2g}")  # an item's answer may differ a little from the value that was drawn
    for drawn in (float(f"{factor * rounded:.3g}") for factor in DISGUISE_FACTORS):
        if not lower <= drawn <= most or abs(drawn - value) < MIN_DISGUISE * abs(value):
            continue
        if parameter.measure.unit == "deg" and not _is_alike(value, drawn):
            continue
        try:
            other = scene.having(path, drawn)
            if other.mechanism.routes == scene.mechanism.routes:
                yield other
        except (SceneError, ValueError):
            continue


def _is_alike(angle: float, other: float) -> bool:
    """Return whether two angles (degrees) are in the same quadrant, the second one not close to its limits."""
    beyond = other % QUADRANT
    clear = RIGHT_ANGLE_MARGIN <= beyond <= QUADRANT - RIGHT_ANGLE_MARGIN or abs(angle) < 2.0 * RIGHT_ANGLE_MARGIN
    return clear and angle // QUADRANT == other // QUADRANT and copysign(1.0, angle) == copysign(1.0, other)


def _parts(drawing: Drawing) -> Counter[str]:
    """Return the numbers of shapes by kind, and the number of pairs of bodies whose outlines overlap."""
    counts = Counter(_kind(shape) for shape in drawing.shapes if shape.weight not in MINOR)
    bodies = [_body(shape) for shape in drawing.shapes if not isinstance(shape, LineShape) and shape.fill]
    counts["overlap"] = sum(depth(one, other) > CONTACT_OVERLAP for one, other in combinations(bodies, 2))
    return counts


def _body(shape: Area | Arc) -> Polygon:
    """Return the vertices of a filled shape's outline; for a circle, points on it rather than a polygon around it."""
    if isinstance(shape, Area):
        return hull(shape.points)
    return tuple(shape.center + shape.radius * 1j ** (n / 6.0) for n in range(24))


def _kind(shape: Shape) -> str:
    look = f"{shape.dashed} {shape.arrow}" if isinstance(shape, LineShape) else shape.fill
    return f"{type(shape).__name__} {shape.weight} {look} {isinstance(shape, Area) and shape.dashed}"


def _texts(drawing: Drawing) -> Counter[tuple[str, str]]:
    """Return the counts of the labels of bodies and numbers, except labels of scales, which depend on sizes."""
    return Counter((label.subject, label.text) for label in drawing.labels if label.subject)


LABEL_MARGIN = 0.06  # kept free around a label
MAX_SWEEPS = 4
WHEEL, AMBIGUOUS_DISTANCE, MISTAKEN = (
    0.3,
    0.75,
    1.6,
)  # a letter this near to another pulley than its own could be taken for its name
ON_LABEL, ON_LINE, IN_BLOCK, LATER = (
    60.0,
    7.0,
    4.0,
    0.12,
)  # what it costs; the last for each place further down the list

HEAD, HEADED = 0.22, 6.0  # of an arrow: how long it is, and how much worse than a line to stand on; it tells the way
LIGHT = {"hair": 0.5, "dots": 0.15}  # how much less of a nuisance under a label
BODY, OPEN = 4.0, ("", "field", "table")  # how much worse it is to hide an outline of a body, and what is none
REACHES, FARTHER, LED_OVER = (0.3, 0.45, 0.7, 1.0, 1.4, 1.9), 0.6, 9.0  # lengths of lines to anchors, what they cost


class Stroke(NamedTuple):
    """A straight segment of an outline; `order` is the index of its shape from back to front."""

    a: complex
    b: complex
    weight: float
    order: int


class Option(NamedTuple):
    """A candidate position of a label, its cost apart from other labels, and its leader line, if any."""

    label: Label
    later: float
    first: complex  # the best of its places, which may lie in the body that it names
    leader: tuple[complex, complex] | None = None


def place_labels(
    wanted: Sequence[LabelRequest], shapes: Sequence[Shape]
) -> tuple[tuple[Label, ...], tuple[LineShape, ...]]:
    """Place all labels with minimal total cost; return them with their leader lines.

    The labels with the fewest candidates are placed first, then all labels again in turn.
    """
    strokes, blocks = (
        _strokes(shapes),
        [outline(s) for s in shapes if not isinstance(s, LineShape) and s.fill == "block"],
    )
    grounds = [(n, outline(s)) for n, s in enumerate(shapes) if not isinstance(s, LineShape) and s.fill]
    order = sorted(range(len(wanted)), key=lambda n: (len(wanted[n].places), n))
    wheels = [s for s in shapes if isinstance(s, Arc) and s.whole and s.radius > WHEEL]
    options = {n: list(_options(wanted[n])) for n in order}
    alone = {
        n: [
            _own_cost(option, _visible_strokes(option.label, strokes, grounds), blocks)
            + _ambiguity_cost(option.label, wanted[n], wheels)
            + _leader_cost(option, strokes)
            for option in options[n]
        ]
        for n in order
    }
    chosen: dict[int, Option] = {}
    for _ in range(MAX_SWEEPS):
        for n in order:
            others = [option for m, option in chosen.items() if m != n]
            costs = [alone[n][i] + _overlap_cost(option, others) for i, option in enumerate(options[n])]
            chosen[n] = options[n][costs.index(min(costs))]
    final = [chosen[n] for n in range(len(wanted))]
    labels = (
        replace(each.label, crossed=_under(each.label.box, _visible_strokes(each.label, strokes, grounds)) > 0.0)
        for each in final
    )
    return tuple(labels), tuple(LineShape(each.leader, "hair") for each in final if each.leader is not None)


def _visible_strokes(label: Label, strokes: Sequence[Stroke], grounds: Sequence[tuple[int, Polygon]]) -> list[Stroke]:
    """Return the outline segments at a label's position that no filled shape in front of them hides."""
    above = max((n for n, polygon in grounds if inside(label.at, polygon)), default=-1)
    return [stroke for stroke in strokes if stroke.order >= above]


def _options(wanted: LabelRequest) -> Iterator[Option]:
    """Yield the candidate positions of a label: the wanted ones, then those with a leader line, nearest first."""
    made = partial(Label, wanted.text, subject=wanted.subject, size=wanted.size, name=wanted.name)
    for number, position in enumerate(wanted.places):
        yield Option(made(at=position), LATER * number, wanted.places[0])
    _, _, wide, tall = made(at=0j).box
    for anchor, far, turn in product(wanted.anchors, REACHES, range(16)):
        direction = 1j ** (turn / 4.0)
        label = made(at=anchor + complex(direction.real * (far + wide), direction.imag * (far + tall)))
        left, low, right, high = label.box
        near = complex(min(max(anchor.real, left), right), min(max(anchor.imag, low), high))
        later = LATER * len(wanted.places) + FARTHER * far
        yield Option(label, later, wanted.places[0] if wanted.places else anchor, (near, anchor))


def _overlap_cost(option: Option, others: Sequence[Option]) -> float:
    """Return the cost of a label's overlaps with other labels, also of crossings with their leader lines."""
    mine, cost = _wider(option.label.box), 0.0
    for label, _, _, leader in others:
        shared = overlap_area(mine, label.box)
        cost += ON_LABEL * shared + 5.0 if shared > 0.0 else 0.0
        cost += LED_OVER if leader and length_inside(*leader, mine) > 0.0 else 0.0
        cost += LED_OVER if option.leader and length_inside(*option.leader, _wider(label.box)) > 0.0 else 0.0
        cost += LED_OVER if option.leader and leader and crosses(*option.leader, *leader) else 0.0
    return cost


def _leader_cost(option: Option, strokes: Sequence[Stroke]) -> float:
    """Return the cost of the outlines that a leader line crosses, except the outline of its own body."""
    if option.leader is None:
        return 0.0
    crossed = sum(stroke.weight >= 1.0 and crosses(*option.leader, stroke.a, stroke.b) for stroke in strokes)
    return LED_OVER * max(0, crossed - 1)


def _own_cost(option: Option, strokes: Sequence[Stroke], blocks: Sequence[Polygon]) -> float:
    """Return the cost of a label's position on its own: its rank, outlines under it, and blocks it does not name."""
    mine = _wider(option.label.box)
    left, low, right, high = mine
    corners = (complex(left, low), complex(right, low), complex(right, high), complex(left, high))
    return (
        option.later
        + ON_LINE * _under(mine, strokes)
        + sum(
            IN_BLOCK
            for block in blocks
            if depth(corners, block) > 0.0 and not (inside(option.label.at, block) and inside(option.first, block))
        )
    )


def _under(area: Box, strokes: Sequence[Stroke]) -> float:
    """Return the weighted length of the strokes inside a box."""
    return sum(stroke.weight * length_inside(stroke.a, stroke.b, area) for stroke in strokes)


def _ambiguity_cost(label: Label, wanted: LabelRequest, wheels: Sequence[Arc]) -> float:
    """Return the cost of a label's position beside a pulley that it does not name."""
    if len(wanted.places) < 2 or not wanted.name or not wheels:
        return 0.0
    middle = sum(wanted.places) / len(wanted.places)
    own = min(wheels, key=lambda wheel: abs(wheel.center - middle))
    others = [wheel for wheel in wheels if wheel is not own]
    return MISTAKEN * sum(abs(wheel.center - label.at) < wheel.radius + AMBIGUOUS_DISTANCE for wheel in others)


def _wider(box: Box) -> Box:
    return box[0] - LABEL_MARGIN, box[1] - LABEL_MARGIN, box[2] + LABEL_MARGIN, box[3] + LABEL_MARGIN


def _strokes(shapes: Sequence[Shape]) -> list[Stroke]:
    """Return all shapes as segments with weights; thin lines have smaller weights."""
    strokes: list[Stroke] = []
    for order, shape in enumerate(shapes):
        if isinstance(shape, LineShape):
            points, weight = shape.points, LIGHT.get(shape.weight, 1.0)
        else:
            points, weight = outline(shape), 1.0 if shape.fill in OPEN else BODY
            points = (*points, points[0]) if isinstance(shape, Area) or shape.whole else points
        strokes += [Stroke(a, b, weight, order) for a, b in pairwise(points)]
        if isinstance(shape, LineShape) and shape.arrow:
            tip, direction = points[-1], unit_vector(points[-1] - points[-2])
            strokes.append(Stroke(tip - HEAD * direction, tip, HEADED, order))
    return strokes
