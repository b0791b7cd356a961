"""Shapes of a drawing as frozen values, labels with candidate positions, and angles at corners."""

import re
from cmath import rect
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from math import radians, tan
from typing import Literal

from sim2reason.figures.plane import Box, Polygon, box, rectangle, ring

Weight = Literal["hair", "thin", "edge", "string", "rod", "dots"]
Fill = Literal["", "block", "wedge", "fixed", "disc", "ink", "table", "ball", "star", "field"]
HATCH, STEP = 0.2, 0.22  # units: length and distance of the strokes that mark fixed surfaces
SLANT = complex(-0.7071, -0.7071)
SIZE, SMALL, TINY = 0.42, 0.34, 0.28  # heights of names, of numbers, and of numbers inside blocks
MAX_LETTER_LENGTH = 2  # characters of a letter with index; longer names are nouns
NAMED, LATEX = (
    re.compile(r"\\[a-zA-Z]+"),
    re.compile(r"[${}_^\\]"),
)  # what stands in a formula for one letter, or for none
WIDE = {"m": 0.98, "w": 0.82, "M": 0.87, "W": 0.99, "i": 0.3, "l": 0.3, ".": 0.34, " ": 0.34, "j": 0.3, "°": 0.5}


@dataclass(frozen=True, slots=True)
class LineShape:
    """A line of straight strokes through given points."""

    points: Polygon
    weight: Weight = "edge"
    dashed: bool = False
    arrow: bool = False  # a head at the last point


@dataclass(frozen=True, slots=True)
class Area:
    """A closed, filled outline."""

    points: Polygon
    fill: Fill = ""
    weight: Weight = "edge"
    dashed: bool = False


@dataclass(frozen=True, slots=True)
class Arc:
    """A circular arc from `start` to `stop`, in degrees; a full circle can be filled."""

    center: complex
    radius: float
    start: float = 0.0
    stop: float = 360.0
    weight: Weight = "edge"
    fill: Fill = ""

    @property
    def whole(self) -> bool:
        """Return whether the arc is a full circle."""
        return self.stop - self.start >= 360.0


@dataclass(frozen=True, slots=True)
class Label:
    """A text at its position; `subject` is the address of the labelled object."""

    text: str
    at: complex
    subject: str
    size: float = SIZE
    name: bool = True  # the name of a body, not a number
    crossed: bool = False  # a line runs under it, so that it needs a ground of its own

    @property
    def box(self) -> Box:
        """Return the rectangle covered by the label."""
        return box(rectangle(self.at, width(self.text, self.size), self.size))


@dataclass(frozen=True, slots=True)
class LabelRequest:
    """A label with candidate positions, the best first; beside one of its `anchors` it gets a leader line."""

    text: str
    places: tuple[complex, ...]
    subject: str
    size: float = SIZE
    name: bool = True
    anchors: tuple[complex, ...] = ()  # points of what it belongs to


Shape = LineShape | Area | Arc


@dataclass(frozen=True)
class Drawing:
    """A finished drawing: shapes from back to front, and labels."""

    shapes: tuple[Shape, ...]
    labels: tuple[Label, ...] = ()

    def box(self) -> Box:
        """Return the smallest rectangle around all shapes and labels."""
        points = [point for shape in self.shapes for point in outline(shape)]
        corners = [complex(*corner) for label in self.labels for corner in (label.box[:2], label.box[2:])]
        return box([*points, *corners])


@dataclass
class Sketch:
    """Mutable lists of shapes and wanted labels, relative to one origin."""

    shapes: list[Shape] = field(default_factory=list[Shape])
    labels: list[LabelRequest] = field(default_factory=list[LabelRequest])

    def extend(self, other: "Sketch") -> None:
        """Add the shapes and labels of another sketch on top."""
        self.shapes += other.shapes
        self.labels += other.labels

    def moved(self, by: complex) -> "Sketch":
        """Return the sketch shifted by a vector."""
        return Sketch([moved(shape, by) for shape in self.shapes], [_label_moved(label, by) for label in self.labels])


def _label_moved(wanted: LabelRequest, by: complex) -> LabelRequest:
    places, anchors = (tuple(point + by for point in points) for points in (wanted.places, wanted.anchors))
    return replace(wanted, places=places, anchors=anchors)


def width(text: str, size: float) -> float:
    """Return the approximate width of a text, in units, rounded up; text between dollars is LaTeX."""
    return size * sum(WIDE.get(letter, 0.66) for letter in LATEX.sub("", NAMED.sub("x", text)))


def outline(shape: Shape) -> Polygon:
    """Return points along a shape; circles are approximated by polygons."""
    if not isinstance(shape, Arc):
        return shape.points
    if shape.whole:
        return ring(shape.center, shape.radius)
    turns = (1j ** ((shape.start + (shape.stop - shape.start) * step / 6.0) / 90.0) for step in range(7))
    return tuple(shape.center + shape.radius * turn for turn in turns)


def moved(shape: Shape, by: complex) -> Shape:
    """Return a shape shifted by a vector."""
    if isinstance(shape, Arc):
        return replace(shape, center=shape.center + by)
    return replace(shape, points=tuple(point + by for point in shape.points))


def hatched_line(a: complex, b: complex) -> Iterable[Shape]:
    """Return the shapes of a fixed surface: a line with slanting strokes to the right of the way from `a` to `b`."""
    direction = (b - a) / abs(b - a)
    slant = direction * SLANT
    yield LineShape((a, b), "edge")
    count = max(2, round(abs(b - a) / STEP))
    for number in range(1, count + 1):
        start = a + direction * abs(b - a) * (number - 0.35) / count
        yield LineShape((start, start + HATCH * slant), "hair")


def rough(a: complex, b: complex, normal: complex) -> Shape:
    """Return dots along a face from `a` to `b` that mark friction, on the side opposite to `normal`."""
    direction = (b - a) / abs(b - a)
    return LineShape((a + 0.1 * direction - 0.1 * normal, b - 0.1 * direction - 0.1 * normal), "dots")


def axle_dot(center: complex, radius: float = 0.06) -> Shape:
    """Return a small filled circle, which marks an axle."""
    return Arc(center, radius, fill="ink", weight="hair")


ANGLE_ARC = 0.75  # units, the least radius of an arc


def corner_angle(at: complex, turn: tuple[float, float], text: str, subject: str) -> Sketch:
    """Draw an arc between two directions, given in degrees, with a label; small angles get larger arcs."""
    middle, half = rect(1.0, radians(0.5 * sum(turn))), radians(0.5 * abs(turn[1] - turn[0]))
    wide = 0.5 * width(text, SMALL)
    room = (0.5 * SMALL + 0.09) / tan(half) - 0.1  # where a text of this height fits in
    near = max(ANGLE_ARC, room)
    beyond = wide * abs(middle.real) + 0.5 * SMALL * abs(middle.imag) + 0.1
    places = tuple(at + middle * (near + beyond + 0.1 * n) for n in range(8))
    return Sketch(
        [Arc(at, near, *sorted(turn), weight="thin")], [LabelRequest(text, places, subject, SMALL, name=False)]
    )
