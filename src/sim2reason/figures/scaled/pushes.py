"""Forces on single bodies, and force fields with their regions."""

import math
from cmath import phase
from collections.abc import Iterator
from math import degrees, hypot

from sim2reason.figures.paths import owner_name
from sim2reason.figures.plane import RIGHT, Polygon, dot, unit_vector
from sim2reason.figures.scaled.lines import label_positions
from sim2reason.figures.scaled.setting import DrawingContext, vector
from sim2reason.figures.scaled.tabletop import spread
from sim2reason.figures.shapes import (
    SIZE,
    SMALL,
    Arc,
    Area,
    LabelRequest,
    LineShape,
    Shape,
    Sketch,
    axle_dot,
    corner_angle,
    width,
)
from sim2reason.scenes.dsl.body import Small
from sim2reason.scenes.dsl.fields import Law, Push
from sim2reason.scenes.dsl.mechanism import ZERO, Force
from sim2reason.scenes.dsl.vectors import BoxRegion as Slab
from sim2reason.scenes.dsl.vectors import DiscRegion, HalfSpace, Region, Vector, add, inner, scale

LONG, BASE = 1.3, 1.1  # units: length of an arrow, and of the line from which its angle is measured
ZERO_TOL = 1e-6  # degrees or units; smaller values count as zero


def is_push(setting: DrawingContext, force: Force) -> bool:
    """Return whether a force is constant in space and time and acts on an uncharged body."""
    look = setting.look(force.body)
    charged = isinstance(look, Small) and bool(look.mark)
    return isinstance(force.law, Push) and force.law.constant and force.region is None and not charged


def pushes(setting: DrawingContext) -> Sketch:
    """Draw an arrow for each constant force at the body's rim, with its stated magnitude and angle."""
    sketch = Sketch()
    for force in setting.mechanism.forces:
        if setting.owns(force.body) and is_push(setting, force):
            _draw(setting, force, sketch)
    return sketch


def _draw(setting: DrawingContext, force: Force, sketch: Sketch) -> None:
    law = force.law
    assert isinstance(law, Push)
    strength = vector(scale(law.profile.value, law.direction))
    projected = setting.view.project_direction(strength)
    if abs(projected) <= ZERO_TOL * hypot(*strength):
        return
    out, name = unit_vector(projected), force.body
    start = setting.at(name) + setting.radius(name) * out
    sketch.shapes.append(LineShape((start, start + LONG * out), arrow=True))
    text = setting.stated(owner_name(name), setting.mechanism.units.spell("N"), hypot(*strength))
    if text:
        tip = start + (LONG + 0.15 + 0.5 * width(text, SMALL) * abs(out.real) + 0.2 * abs(out.imag)) * out
        places = (tip, *label_positions(start, start + LONG * out, text, SMALL))
        sketch.labels.append(LabelRequest(text, places, name, SMALL, name=False))
    for base in _bases(setting, name):
        turn = phase(out / base)
        angle = (
            setting.state_once(owner_name(name), "deg", degrees(abs(turn)))
            if ZERO_TOL < degrees(abs(turn)) <= 90.0
            else ""
        )
        if angle:
            begin = degrees(phase(base))
            sketch.shapes.append(LineShape((start, start + BASE * base), "hair", dashed=True))
            sketch.extend(corner_angle(start, (begin, begin + degrees(turn)), angle, name))
            return


def _bases(setting: DrawingContext, name: str) -> list[complex]:
    """Return the directions from which a force's angle is measured: of the body's slides, then horizontal."""
    slides = [c.axis for c in setting.mechanism.body[name].coordinates if c.kind == "slide"]
    ways = [
        unit_vector(direction) for axis in slides if abs(direction := setting.view.project_direction(axis)) > ZERO_TOL
    ]
    return [sign * direction for direction in (*ways, RIGHT) for sign in (1.0, -1.0)]


PITCH, MARK, ARROW = 1.15, 0.09, 0.55  # units between marks, half the size of a cross, the length of an arrow
CIRCLE_POINTS = 48
FAR_DISTANCE = 1e3  # units, beyond every drawing
NEGATIVE = "\N{MINUS SIGN}"
SOON, FAINT = 1e-3, 1e-12  # s after the start at which a field is evaluated; smallest field that is drawn


def fields(setting: DrawingContext) -> Sketch:
    """Draw the regions, and the marks of every field with a direction."""
    sketch = Sketch()
    for region, _ in setting.regions():
        outline = border(setting, region)
        if outline:
            sketch.shapes.append(Area(outline, "field", weight="thin", dashed=True))
    letters: set[str] = set()
    number = 0
    for force in (f for f in setting.mechanism.forces if setting.owns(f.body) and not is_push(setting, f)):
        shift = complex(0.5, 0.5) * PITCH * (number % 2)
        number += _marks(setting, force, shift, sketch, letters)
    return sketch


def _marks(setting: DrawingContext, force: Force, shift: complex, sketch: Sketch, letters: set[str]) -> bool:
    """Draw the marks of a field on a grid, one with its letter; return whether there are any."""
    places = _grid(spread(setting), shift)
    inside = [at for at in places if force.region is None or _inside(setting, force.region, at)]
    shown = [mark for at in inside if (mark := mark_at(setting, force, at)) is not None]
    sketch.shapes += [shape for _, shapes in shown for shape in shapes]
    letter = shown[0][0] if shown else ""
    if shown and letter not in letters:
        letters.add(letter)
        spots = tuple(at + complex(0.34, 0.3) for at in sorted(inside, key=lambda p: (-p.imag, -p.real)))
        sketch.labels.append(LabelRequest(f"{letter} field", spots, "", SIZE, name=False))  # no body has such a name
    return bool(shown)


def _grid(area: tuple[float, float, float, float], shift: complex) -> Iterator[complex]:
    left, low, right, high = area
    columns, rows = int((right - left) / PITCH), int((high - low) / PITCH)
    for row in range(rows + 1):
        for column in range(columns + 1):
            at = complex(left + PITCH * (column + 0.5), low + PITCH * (row + 0.5)) + shift
            if at.real < right - 0.5 * ARROW and at.imag < high - 0.5 * ARROW:
                yield at


def mark_at(setting: DrawingContext, force: Force, at: complex) -> tuple[str, list[Shape]] | None:
    """Return the letter and the mark of a field at a position; None where it is zero or has no direction."""
    sign = _charged(setting, force.body)
    unit_charge = -1.0 if sign == NEGATIVE else 1.0
    for time in (0.0, SOON):  # of a field that grows from nothing, the way in which it points next
        still, magnetic = (
            scale(unit_charge, part) for part in parts(setting, force.law, world_position(setting, at), time)
        )
        for letter, strength in (("E" if sign else "F", still), ("B", magnetic)):
            if math.hypot(*strength) > FAINT:
                return letter, _symbol(setting, strength, at)
    return None


def parts(setting: DrawingContext, law: Law, where: Vector, time: float) -> tuple[Vector, Vector]:
    """Return the force of a law on a body at rest, and the magnetic field B of its part F = v × B.

    The magnetic field follows from the force F(v) on velocities along the page's two axes x, y and out of the page z,
    since drag is parallel to v: B = (y·F(z), z·F(x), x·F(y)).
    """
    x, y, z = setting.view.right, setting.view.up, setting.view.page_normal

    def across(velocity: Vector, way: Vector) -> float:
        moved, rests = (law.force(where, v, time, math) for v in (velocity, ZERO))
        return inner(way, vector(moved)) - inner(way, vector(rests))

    field = add(scale(across(z, y), x), scale(across(x, z), y), scale(across(y, x), z))
    return vector(law.force(where, ZERO, time, math)), field


def _symbol(setting: DrawingContext, strength: Vector, at: complex) -> list[Shape]:
    """Return a cross for a vector into the page, a dot for one out of it, else an arrow."""
    out, projected = inner(setting.view.page_normal, strength), setting.view.project_direction(strength)
    if abs(projected) > abs(out):
        half = 0.5 * ARROW * unit_vector(projected)
        return [LineShape((at - half, at + half), "hair", arrow=True)]
    if out > 0.0:
        return [Arc(at, MARK, weight="hair"), axle_dot(at, 0.035)]
    a, b = MARK * complex(1, 1), MARK * complex(1, -1)
    return [LineShape((at - a, at + a), "hair"), LineShape((at - b, at + b), "hair")]


def _charged(setting: DrawingContext, body: str) -> str:
    """Return the sign of a body's charge; an empty text if it has none."""
    look = setting.look(body)
    return look.mark if isinstance(look, Small) else ""


def world_position(setting: DrawingContext, at: complex) -> Vector:
    """Return the position in the world frame of a point of the page."""
    view = setting.view
    return add(scale(at.real / view.scale, view.right), scale(at.imag / view.scale, view.up))


def _inside(setting: DrawingContext, region: Region, at: complex) -> bool:
    return all(float(margin) * setting.view.scale > 0.3 for margin in region.margins(world_position(setting, at), math))


def border(setting: DrawingContext, region: Region) -> Polygon:
    """Return the outline of a region on the page, clipped to the drawing; empty for unknown kinds of regions."""
    view, (left, low, right, high) = setting.view, spread(setting)
    page: Polygon = (complex(left, low), complex(right, low), complex(right, high), complex(left, high))
    if isinstance(region, DiscRegion):
        turns = (2.0 * math.pi * n / CIRCLE_POINTS for n in range(CIRCLE_POINTS))
        return tuple(
            view.at(region.center) + view.scale * region.radius * complex(math.cos(t), math.sin(t)) for t in turns
        )
    if isinstance(region, HalfSpace):
        return _cut(page, view.project_direction(region.normal), view.scale * region.offset)
    if isinstance(region, Slab):
        for axis, lower, most in region.sides:
            direction = view.project_direction(axis)
            page = _cut(page, direction, view.scale * lower)
            page = _cut(page, -direction, -view.scale * most)
        return page
    return ()


def _cut(polygon: Polygon, normal: complex, offset: float) -> Polygon:
    """Return the part of a convex polygon where normal·r ≥ offset."""
    vertices: list[complex] = []
    for a, b in zip(polygon, (*polygon[1:], *polygon[:1]), strict=True):
        one, other = dot(normal, a) - offset, dot(normal, b) - offset
        if one >= 0.0:
            vertices.append(a)
        if (one > 0.0 > other) or (one < 0.0 < other):
            vertices.append(a + (b - a) * one / (one - other))
    return tuple(vertices)
