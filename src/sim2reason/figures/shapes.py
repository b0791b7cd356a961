"""What a drawing is made of: a few frozen shapes, and labels that still look for their place."""

import re
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from typing import Literal

from sim2reason.figures.vectors import Box, Polygon, box, rectangle, ring

Weight = Literal["hair", "thin", "edge", "string", "rod", "dots"]
Fill = Literal["", "block", "wedge", "fixed", "disc", "ink", "table", "ball", "star", "field"]
HATCH, STEP = 0.2, 0.22  # length and distance of the strokes that mark what is fixed
SLANT = complex(-0.7071, -0.7071)
SIZE, SMALL, TINY = 0.42, 0.34, 0.28  # heights of names, of numbers, and of numbers inside blocks
LETTER = 2  # characters; longer names are nouns
NAMED, LATEX = (
    re.compile(r"\\[a-zA-Z]+"),
    re.compile(r"[${}_^\\]"),
)  # what stands in a formula for one letter, or for none
WIDE = {"m": 0.98, "w": 0.82, "M": 0.87, "W": 0.99, "i": 0.3, "l": 0.3, ".": 0.34, " ": 0.34, "j": 0.3, "°": 0.5}


@dataclass(frozen=True, slots=True)
class LineShape:
    """Straight strokes from point to point."""

    points: Polygon
    weight: Weight = "edge"
    dashed: bool = False
    arrow: bool = False  # a head at the last point


@dataclass(frozen=True, slots=True)
class Area:
    """A closed outline, filled."""

    points: Polygon
    fill: Fill = ""
    weight: Weight = "edge"
    dashed: bool = False


@dataclass(frozen=True, slots=True)
class Arc:
    """A part of a circle, from `start` to `stop` degrees; a whole one can be filled."""

    center: complex
    radius: float
    start: float = 0.0
    stop: float = 360.0
    weight: Weight = "edge"
    fill: Fill = ""

    @property
    def whole(self) -> bool:
        """Return whether it is a full circle."""
        return self.stop - self.start >= 360.0


@dataclass(frozen=True, slots=True)
class Label:
    """A text at its place; `subject` is what it names or belongs to, an address."""

    text: str
    at: complex
    subject: str
    size: float = SIZE
    name: bool = True  # the name of a body, not a number
    crossed: bool = False  # a line runs under it, so that it needs a ground of its own

    @property
    def box(self) -> Box:
        """The rectangle that it covers."""
        return box(rectangle(self.at, width(self.text, self.size), self.size))


@dataclass(frozen=True, slots=True)
class Wanted:
    """A label with alternative places, the best first; beside one of its `anchors` it has a leader line to it."""

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
        """Return the smallest rectangle around everything."""
        points = [point for shape in self.shapes for point in outline(shape)]
        corners = [complex(*corner) for label in self.labels for corner in (label.box[:2], label.box[2:])]
        return box([*points, *corners])


@dataclass
class Sketch:
    """Shapes and wanted labels of one piece, in its own place."""

    shapes: list[Shape] = field(default_factory=list[Shape])
    labels: list[Wanted] = field(default_factory=list[Wanted])

    def extend(self, other: "Sketch") -> None:
        """Put another one over it."""
        self.shapes += other.shapes
        self.labels += other.labels

    def moved(self, by: complex) -> "Sketch":
        """Return the same elsewhere."""
        return Sketch([moved(shape, by) for shape in self.shapes], [_label_moved(held, by) for held in self.labels])


def _label_moved(wanted: Wanted, by: complex) -> Wanted:
    places, anchors = (tuple(point + by for point in held) for held in (wanted.places, wanted.anchors))
    return replace(wanted, places=places, anchors=anchors)


def width(text: str, size: float) -> float:
    """About how wide a text is; a little more rather than less. Between dollars it is a formula in LaTeX."""
    return size * sum(WIDE.get(letter, 0.66) for letter in LATEX.sub("", NAMED.sub("x", text)))


def outline(shape: Shape) -> Polygon:
    """Points along a shape; round ones as polygons."""
    if not isinstance(shape, Arc):
        return shape.points
    if shape.whole:
        return ring(shape.center, shape.radius)
    turns = (1j ** ((shape.start + (shape.stop - shape.start) * step / 6.0) / 90.0) for step in range(7))
    return tuple(shape.center + shape.radius * turn for turn in turns)


def moved(shape: Shape, by: complex) -> Shape:
    """Return a shape elsewhere."""
    if isinstance(shape, Arc):
        return replace(shape, center=shape.center + by)
    return replace(shape, points=tuple(point + by for point in shape.points))


def hatched(a: complex, b: complex) -> Iterable[Shape]:
    """The face of something fixed, solid to the right of the way from `a` to `b`: a line with slanting strokes."""
    way = (b - a) / abs(b - a)
    slant = way * SLANT
    yield LineShape((a, b), "edge")
    count = max(2, round(abs(b - a) / STEP))
    for number in range(1, count + 1):
        start = a + way * abs(b - a) * (number - 0.35) / count
        yield LineShape((start, start + HATCH * slant), "hair")


def rough(a: complex, b: complex, normal: complex) -> Shape:
    """Dots under a face from `a` to `b`, on the side from which `normal` points: there is friction on it."""
    way = (b - a) / abs(b - a)
    return LineShape((a + 0.1 * way - 0.1 * normal, b - 0.1 * way - 0.1 * normal), "dots")


def dot_at(center: complex, radius: float = 0.06) -> Shape:
    """Return a small filled circle: an axle."""
    return Arc(center, radius, fill="ink", weight="hair")
