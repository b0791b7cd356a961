"""Shapes of bodies by their looks, and labels of their names."""

from cmath import rect
from collections.abc import Iterable
from dataclasses import replace
from itertools import product
from math import acos, asin, pi, sqrt

from sim2reason.figures.hanging import block_labels
from sim2reason.figures.pieces import positions_around
from sim2reason.figures.plane import RIGHT, UP, Polygon, hull, rectangle, unit_vector
from sim2reason.figures.scaled.lines import label_positions
from sim2reason.figures.scaled.setting import OBLONG, SLAB_STEP, DrawingContext
from sim2reason.figures.shapes import (
    MAX_LETTER_LENGTH,
    SIZE,
    SMALL,
    TINY,
    Arc,
    Area,
    LabelRequest,
    Shape,
    Sketch,
    width,
)
from sim2reason.scenes.dsl.body import Axial, BodyLook, Capped, Rectangular, Silhouette, Small, Spherical

MIN_THICKNESS = 0.13  # units: drawn thickness of thin bodies, at least
ROCKET_OUTLINE = ((-0.2, -0.5), (0.2, -0.5), (0.2, 0.25), (0.0, 0.65), (-0.2, 0.25))
ROCKET_FINS = (((-0.2, -0.5), (-0.38, -0.65), (-0.2, -0.15)), ((0.2, -0.5), (0.38, -0.65), (0.2, -0.15)))
LETTERED = ("puck", "sphere")  # round bodies with room for a letter
MIN_SIDE_COMPONENT = 0.5  # an axis with at least this component in the page is drawn from the side
MAX_LABEL_SLOPE = 0.3  # largest sine of a slope at which labels along it fit into a slab
ARC_POINTS = 24  # points of half a round outline


def body(setting: DrawingContext, address: str, along: complex = RIGHT) -> Sketch:
    """Return the sketch of a body at its position; `along` is the direction of a block's long side."""
    look, at = setting.look(address), setting.at(address)
    if look is None:
        return undeclared_body(setting, address, at)
    return Sketch(list(shapes(setting, address, look, at, along)), names(setting, address, look, at))


def undeclared_body(setting: DrawingContext, address: str, at: complex) -> Sketch:
    """Return the sketch of a body whose class declares no look: a dashed box with its name."""
    text = setting.plan.caption(address)
    wide = max(1.0, width(text, SMALL) + 0.2)
    box = Area(rectangle(at, wide, 0.7), dashed=True)
    return Sketch([box], [LabelRequest(text, (at,), address, SMALL)])


def shapes(setting: DrawingContext, address: str, look: BodyLook, at: complex, along: complex) -> Iterable[Shape]:
    """Return the shapes of a body, from back to front."""
    x, y, z = (setting.view.project_direction(axis) for axis in setting.axes(address))
    size = setting.view.scale
    match look:  # each kind of look has its own shapes
        case Small(kind):
            return small(kind, at, setting.radius(address), setting.sizes(address), along)
        case Spherical():
            return sphere(look, at, size, z)
        case Axial():
            return axial(look, at, size, (x, z))
        case Capped():
            outline = cap(look, at, size, z)
        case Rectangular(a, b, c):
            edges, signs = (a * x, b * y, c * z), product((-0.5, 0.5), repeat=3)
            outline = hull(at + size * sum(s * edge for s, edge in zip(each, edges, strict=True)) for each in signs)
        case Silhouette(points):
            outline = tuple(at + size * (px * x + pz * z) for px, pz in points)
        case _:
            return []
    return [Area(outline, "block")]


def small(kind: str, at: complex, radius: float, sizes: tuple[float, float], along: complex) -> list[Shape]:
    """Return the shapes of a body whose size does not matter."""
    wide, tall = sizes
    match kind:
        case "block" | "slab":
            return [Area(rectangle(at, wide, tall, along), "block")]
        case "cart":
            out = along * 1j
            wheels = [Arc(at - out * (radius - 0.13) + side * 0.3 * along, 0.13) for side in (-1.0, 1.0)]
            return [Area(rectangle(at + 0.1 * out, wide, tall - 0.2, along), "block"), *wheels]
        case "rocket":
            parts = (*ROCKET_FINS, ROCKET_OUTLINE)
            return [Area(tuple(at + complex(*p) for p in part), "block") for part in parts]
        case "star":
            return [Arc(at, radius, fill="star")]
        case _:
            return [Arc(at, radius, fill="block" if kind in LETTERED else "ball")]


def sphere(look: Spherical, at: complex, size: float, z: complex) -> list[Shape]:
    """Return the disc of a sphere with its hollow in white; a hole through the wall opens it."""
    radius, inner = look.radius * size, (look.radius - look.wall) * size
    middle, hole = at + look.offset * size * z, look.hole * size
    if look.wall and hole:
        return [Area(shell(at, (radius, inner), (abs(middle - at), hole), unit_vector(z)), "block")]
    found: list[Shape] = [Arc(at, radius, fill="block")]
    found += [Arc(at, inner, weight="thin")] if look.wall else []
    return found + ([Arc(middle, hole, weight="thin")] if hole else [])


def shell(at: complex, radii: tuple[float, float], hole: tuple[float, float], direction: complex) -> Polygon:
    """Return the outline of a ring that has a circular hole (distance, radius) on its side in a direction."""

    def opening(radius: float) -> float:
        """Return half the angle that the hole cuts out of a circle, radians."""
        off, reach = hole
        cosine = (radius**2 + off**2 - reach**2) / (2.0 * radius * off) if off else 1.0
        return acos(max(-1.0, min(1.0, cosine)))

    outer, inner = ([at + radius * direction * rect(1.0, turn) for turn in _turns(opening(radius))] for radius in radii)
    return (*outer, *reversed(inner))


def _turns(gap: float) -> list[float]:
    return [gap + (2.0 * pi - 2.0 * gap) * n / (2 * ARC_POINTS) for n in range(2 * ARC_POINTS + 1)]


def axial(look: Axial, at: complex, size: float, ways: tuple[complex, complex]) -> list[Shape]:
    """Return a circle or polygon for a view along the body's axis, else a rectangle."""
    x, z = ways
    if abs(z) > MIN_SIDE_COMPONENT:
        wide, tall = max(MIN_THICKNESS, 2.0 * look.radius * size), max(MIN_THICKNESS, look.height * size)
        return [Area(rectangle(at, wide, tall, unit_vector(z) * -1j), "block")]
    radius = look.radius * size
    if look.sides:
        start = x if abs(x) > MIN_SIDE_COMPONENT else RIGHT
        corners = tuple(at + radius * start * rect(1.0, 2.0 * pi * n / look.sides) for n in range(look.sides))
        return [Area(corners, "block")]
    found: list[Shape] = [Arc(at, radius, fill="block")]
    found += [Arc(at, radius - look.wall * size, weight="thin")] if look.wall else []
    found += [Arc(at, look.step * size, fill="disc", weight="thin")] if look.step else []
    return found + ([Arc(at + look.offset * size * x, look.hole * size, weight="thin")] if look.hole else [])


def cap(look: Capped, at: complex, size: float, z: complex) -> Polygon:
    """Return the outline of a spherical cap: a circular segment, or the section of a bowl's wall."""
    if abs(z) <= MIN_SIDE_COMPONENT:
        wide = sqrt(max(0.0, look.height * (2.0 * look.radius - look.height))) if look.height < look.radius else 0.0
        radius = size * (wide or look.radius)
        return tuple(at + radius * rect(1.0, pi * n / ARC_POINTS) for n in range(2 * ARC_POINTS))
    up = unit_vector(z)
    outer = _segment(look.radius, look.height)
    inner = _segment(look.radius - look.wall, look.height - look.wall) if look.wall else ()
    return tuple(at + size * (p.real * up * -1j + p.imag * up) for p in (*outer, *reversed(inner)))


def _segment(radius: float, height: float) -> Polygon:
    """Return the outline of a cap, relative to the centre of its flat face, with the cap's top upwards."""
    center = height - radius
    low = asin(max(-1.0, min(1.0, -center / radius)))
    turns = (low + (pi - 2.0 * low) * n / ARC_POINTS for n in range(ARC_POINTS + 1))
    return tuple(complex(0.0, center) + radius * rect(1.0, turn) for turn in turns)


def names(setting: DrawingContext, address: str, look: BodyLook, at: complex) -> list[LabelRequest]:
    """Return the labels of a body's name and, if wanted, mass: inside it if they fit, else beside it."""
    plan, named = setting.plan, setting.bodies[address].letters
    if isinstance(look, Small) and look.kind == "slab":
        return slab_labels(setting, address, at)
    if isinstance(look, Small) and look.kind in OBLONG:
        inside, *rest = block_labels(plan, address, at, setting.sizes(address))
        if not _covered(setting, address):
            return [inside, *rest]
        wide = width(inside.text, SIZE)
        return [
            replace(inside, places=(*inside.places, *positions_around(at, 0.55, wide, start=unit_vector(-1 + 1j)))),
            *rest,
        ]
    name, radius = plan.name(address), setting.radius(address)
    mark = look.mark if isinstance(look, Small) else ""
    labels = [LabelRequest(mark, (at,), address, SMALL, name=False)] if mark else []
    long, half = lengthwise(setting, address, look)
    fits = not mark and len(name) <= MAX_LETTER_LENGTH and width(name, SIZE) < 1.5 * half and _plain(look)
    mass = plan.mass(address)
    if fits and mass:
        labels.append(
            LabelRequest(
                mass, positions_around(at, radius + 0.1, width(mass, SMALL), start=UP), address, SMALL, name=False
            )
        )
    text = name if fits or not mass else f"{name} ({mass})"
    size = SIZE if text == name else SMALL
    start = -unit_vector(velocity) if (velocity := setting.velocity(address)) else UP
    aside = tuple(label_positions(at - long, at + long, text, size, half + 0.12)) if long else ()
    ring = (positions_around(at, radius + far, width(text, size), start=start) for far in (0.1, 0.7))
    beyond = (*aside, *(position for each in ring for position in each))
    places = (at, *beyond) if fits else beyond
    if not named:  # it needs no name, but a number may stand beside it
        text, size = mass, SMALL
        places = positions_around(at, radius + 0.1, width(mass, SMALL), start=UP)
    return [*labels, LabelRequest(text, places, address, size, name=bool(named))] if text else labels


def slab_labels(setting: DrawingContext, address: str, at: complex) -> list[LabelRequest]:
    """Return the labels of a slab's name and mass: side by side inside it, or beyond its ends."""
    name, mass, along = setting.plan.name(address), setting.plan.mass(address), setting.along(address)
    half, wide = 0.5 * setting.sizes(address)[0], 0.5 * width(name, SIZE)
    if not mass:
        ends = (at + side * (half + 0.2 + wide) * along for side in (1.0, -1.0))
        return [LabelRequest(name, (at,) if wide < half else tuple(ends), address)]
    first, level = -0.6 * width(mass, TINY) * along, abs(along.imag) < MAX_LABEL_SLOPE
    bare = 0.5 * SLAB_STEP  # of the slab, at either end, where another one lies on it
    ends = tuple(at + side * (half - 0.5 * bare) * along for side in (-1.0, 1.0))
    places = (at + 0.3 * along,) if level else ()
    mass_label = LabelRequest(mass, places, address, TINY, name=False, anchors=ends)
    return [LabelRequest(name, (at + first if level else at,), address), mass_label]


def lengthwise(setting: DrawingContext, address: str, look: BodyLook) -> tuple[complex, float]:
    """Return half the length of a thin body along its direction (0 for others), and half its width."""
    match look:
        case Axial(radius, height):
            sizes = (2.0 * radius, 2.0 * radius, height)
        case Rectangular(x, y, z):
            sizes = (x, y, z)
        case _:
            return 0j, setting.radius(address)
    edges = [0.5 * size * setting.view.at(axis) for size, axis in zip(sizes, setting.axes(address), strict=True)]
    shorter, longer = sorted(edges, key=abs)[1:]
    half = max(0.5 * MIN_THICKNESS, abs(shorter))
    return (longer if abs(longer) > 2.0 * half else 0j), half


def _covered(setting: DrawingContext, address: str) -> bool:
    """Return whether another body or a line is attached to the middle of a body, where its name would be."""
    joints = (j for j in setting.plan.scene.joints.values() if setting.owns(j.name) and j.connection.carries)
    sites = (setting.mechanism.site[joint.stops[0].sites[0]] for joint in joints)
    return any(
        site.body == address and abs(setting.site(site.name) - setting.at(address)) < MIN_THICKNESS for site in sites
    )


def _plain(look: BodyLook) -> bool:
    """Return whether a body has room for a letter inside: neither filled with ink nor hollow."""
    match look:
        case Small(kind):
            return kind in (*LETTERED, "star")
        case Spherical(_, wall, hole):
            return not wall and not hole
        case Axial(_, _, wall, _, hole):
            return not wall and not hole
        case Rectangular():
            return True
        case _:
            return False
