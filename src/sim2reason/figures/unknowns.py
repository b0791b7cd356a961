"""Replacement of unknown lengths and angles in figures, so that the answer can't be measured in a figure to scale."""

from collections import Counter
from collections.abc import Callable, Iterator
from itertools import combinations
from math import copysign

from sim2reason.errors import SceneError
from sim2reason.figures.shapes import Arc, Area, Drawing, LineShape, Shape
from sim2reason.figures.vectors import Polygon, depth, hull
from sim2reason.questions.unknown import limits_of
from sim2reason.scenes.dsl.model import Parameter
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.units import parse_unit
from sim2reason.text.prose.description import Description

FACTORS = (1.3, 0.75, 1.2, 0.85, 1.5, 0.6, 0.5, 1.8, 2.4, 0.88, 1.12)
"""Factors by which the value of an unknown, with two digits, is multiplied, in the order of trial."""
LEAST = 0.1  # of the value, by which the drawn one differs from it
QUADRANT, CLEAR = 90.0, 5.0  # degrees; how far a drawn angle keeps from a multiple of a right angle
SCALES = (parse_unit("m").dimension, parse_unit("deg").dimension)
MINOR = ("hair", "dots")  # strokes whose number depends on sizes
TOUCHING = 0.02  # units by which outlines overlap that do no more than touch

Draw = Callable[[Scene], Drawing]


def unknowns(scene: Scene, description: Description) -> tuple[str, ...]:
    """Return the addresses of the lengths and angles that a text leaves open while it states other numbers.

    A text in which all numbers are symbols asks for a formula, which no figure shows.
    """
    told, symbolic = frozenset(description.told), frozenset(description.symbolic)
    own = {p.path: p for p in scene.parameters if p.value and not p.hidden}
    if len(symbolic) > 1 and not any(path in told and path not in symbolic for path in own):
        return ()
    return tuple(path for path, parameter in own.items() if path in symbolic and _is_drawn_to_scale(parameter))


def _is_drawn_to_scale(parameter: Parameter) -> bool:
    unit = parameter.measure.unit
    return bool(unit) and parse_unit(unit).dimension in SCALES


def disguised(scene: Scene, description: Description, draw: Draw) -> tuple[Scene, Drawing]:
    """Return a scene in which unknown lengths and angles have other values, and its drawing.

    For each unknown it takes the first value with which the drawing has the same parts and labels, else the same parts;
    the unknown keeps its value where there is none.
    """
    found = draw(scene)
    for path in unknowns(scene, description):
        scene, found = _other(scene, found, path, draw)
    return scene, found


def _other(scene: Scene, drawing: Drawing, path: str, draw: Draw) -> tuple[Scene, Drawing]:
    """Return the scene and its drawing with another value of one number, or the same ones."""
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
    """Yield the scenes with other values of a number that fit together in the same way."""
    parameter = next(p for p in scene.parameters if p.path == path)
    value, (least, most) = parameter.value or 0.0, limits_of(scene, path)
    told = float(f"{value:.2g}")  # an item's answer may differ a little from the value that was drawn
    for drawn in (float(f"{factor * told:.3g}") for factor in FACTORS):
        if not least <= drawn <= most or abs(drawn - value) < LEAST * abs(value):
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
    """Return whether two angles, in degrees, are in the same quadrant and the second is not close to its limits."""
    beyond = other % QUADRANT
    clear = CLEAR <= beyond <= QUADRANT - CLEAR or abs(angle) < 2.0 * CLEAR
    return clear and angle // QUADRANT == other // QUADRANT and copysign(1.0, angle) == copysign(1.0, other)


def _parts(drawing: Drawing) -> Counter[str]:
    """Count the shapes of each kind, and the pairs of bodies whose outlines overlap."""
    found = Counter(_kind(shape) for shape in drawing.shapes if shape.weight not in MINOR)
    bodies = [_body(shape) for shape in drawing.shapes if not isinstance(shape, LineShape) and shape.fill]
    found["overlap"] = sum(depth(one, other) > TOUCHING for one, other in combinations(bodies, 2))
    return found


def _body(shape: Area | Arc) -> Polygon:
    """Return the vertices of a filled shape's outline; for a circle, points on it rather than a polygon around it."""
    if isinstance(shape, Area):
        return hull(shape.points)
    return tuple(shape.center + shape.radius * 1j ** (n / 6.0) for n in range(24))


def _kind(shape: Shape) -> str:
    look = f"{shape.dashed} {shape.arrow}" if isinstance(shape, LineShape) else shape.fill
    return f"{type(shape).__name__} {shape.weight} {look} {isinstance(shape, Area) and shape.dashed}"


def _texts(drawing: Drawing) -> Counter[tuple[str, str]]:
    """Count the labels of bodies and of their numbers, but for those of scales, which depend on sizes."""
    return Counter((label.subject, label.text) for label in drawing.labels if label.subject)
