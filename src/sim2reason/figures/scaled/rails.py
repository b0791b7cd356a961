"""Rails and guides, boxes with bodies on top and beside them, and small pulleys not named in the text."""

from cmath import phase
from collections.abc import Iterator
from itertools import pairwise
from math import degrees

from sim2reason.figures.hanging import plate
from sim2reason.figures.paths import flat, is_pulley, owner_name
from sim2reason.figures.plane import RIGHT, UP, cross, unit_vector
from sim2reason.figures.scaled.setting import BESIDE, MAX_VERTICAL_COSINE, DrawingContext
from sim2reason.figures.shapes import (
    SIZE,
    SMALL,
    Arc,
    Area,
    LabelRequest,
    LineShape,
    Sketch,
    axle_dot,
    corner_angle,
    hatched_line,
)
from sim2reason.scenes.dsl.body import BigBox, Small
from sim2reason.scenes.dsl.mechanism import RigidBody

RAIL_LENGTH = 2.0  # units of rail on either side of a guided body
SMALL_PULLEY_RADIUS = 0.24  # radius of a small pulley
GAP, FOOT, ROOM = 0.1, 0.6, 0.5  # units: beside a box, below bodies beside it, and beside bodies on it
ZERO_TOL = 1e-6
FOOT_LINE_LENGTH = 2.2  # units, length of the horizontal line at the foot of a rail


def rides(setting: DrawingContext, body: RigidBody) -> bool:
    """Return whether a small body is guided along a line that is not vertical, without a surface below it."""
    look, slides = setting.look(body.name), [c for c in body.coordinates if c.kind == "slide"]
    if not isinstance(look, Small) or body.name in setting.mechanism.contacts or setting.view.level:
        return False
    led = len(slides) == 1 and body.parent is None and look.kind in BESIDE
    return led and abs(setting.view.project_direction(slides[0].axis).real) > MAX_VERTICAL_COSINE


def walls(setting: DrawingContext, point: complex, direction: complex, on: str | None = None) -> Iterator[complex]:
    """Yield the ends on a rail's line of springs and strings that are tied to the ground, or to the body `on`."""
    for line in setting.lines:
        for site in (line.through[0], line.through[-1]):
            at = setting.site(site)
            if setting.mechanism.site[site].body == on and abs(cross(at - point, direction)) < ZERO_TOL:
                yield at


def rails(setting: DrawingContext) -> Sketch:
    """Return the sketch of all rails, guides, boxes and unnamed pulleys, behind the bodies."""
    sketch = Sketch()
    riding: dict[tuple[float, float], list[RigidBody]] = {}
    for body in setting.members:
        if rides(setting, body):
            direction, at = setting.along(body.name), setting.at(body.name)
            riding.setdefault((round(cross(direction, at), 3), round(direction.imag, 6)), []).append(body)
    for group in riding.values():
        _rail(setting, group, sketch)
    for body in setting.members:
        if isinstance(setting.look(body.name), BigBox):
            _box(setting, body.name, sketch)
    if not setting.view.level:
        for site, before, after in _bends(setting):
            _wheel(setting, site, before, after, sketch)
    return sketch


def _rail(setting: DrawingContext, group: list[RigidBody], sketch: Sketch) -> None:
    """Draw a rail: below carts and below bodies with strings or neighbours along it, else through the body's middle."""
    body = group[0]
    direction, at, look = setting.along(body.name), setting.at(body.name), setting.look(body.name)
    faces = setting.plan.scene.builder.faces
    own = (faces.get(site.name) for site in setting.mechanism.sites if site.body == body.name)
    along = any(to is not None and abs(cross(setting.view.project_direction(to), direction)) < ZERO_TOL for to in own)
    cart = isinstance(look, Small) and look.kind == "cart"
    others = [((setting.at(b.name) - at) / direction).real for b in group]
    ends = [
        min(others) - RAIL_LENGTH,
        max(others) + RAIL_LENGTH,
        *_stops(setting, group, direction, at),
        *(((end - at) / direction).real for end in walls(setting, at, direction)),
    ]
    down = (
        setting.radius(body.name) * direction * 1j if cart or along or len(group) > 1 or _carries(setting, body) else 0j
    )
    sketch.shapes.append(LineShape((at + min(ends) * direction - down, at + max(ends) * direction - down), "rod"))
    _tilt(setting, body, at + min(ends) * direction - down, direction, sketch)


def _tilt(setting: DrawingContext, body: RigidBody, low: complex, direction: complex, sketch: Sketch) -> None:
    """Draw the angle between a rail and the horizontal at its left end, if the text states it."""
    turn = degrees(phase(direction))
    text = setting.state_once(owner_name(body.name), "deg", abs(turn)) if abs(turn) > ZERO_TOL else ""
    if text:
        sketch.shapes.append(LineShape((low, low + FOOT_LINE_LENGTH), "hair", dashed=True))
        sketch.extend(corner_angle(low, (0.0, turn), text, body.name))


def _stops(setting: DrawingContext, group: list[RigidBody], direction: complex, at: complex) -> Iterator[float]:
    """Yield the positions of walls that bodies on a rail may hit, relative to `at`."""
    names = {body.name for body in group}
    for meeting in setting.mechanism.meetings:
        if meeting.a is None and meeting.normal is not None and meeting.b in names:
            normal = setting.view.project_direction(meeting.normal)
            if abs(cross(normal, direction)) < ZERO_TOL:
                yield ((meeting.distance * setting.view.scale * normal - at) / direction).real


def _carries(setting: DrawingContext, body: RigidBody) -> bool:
    return any(other.parent == body.name for other in setting.members)


def _box(setting: DrawingContext, address: str, sketch: Sketch) -> None:
    """Draw the outline of a box, the guides at its sides, and the floor."""
    children = [body for body in setting.members if body.parent == address]
    lying = [body for body in children if body.name in setting.mechanism.contacts]
    sliding = [body for body in children if body not in lying]
    sites = [setting.site(site.name) for site in setting.mechanism.sites if site.body == address]
    tops = [setting.at(body.name) - setting.radius(body.name) * UP for body in lying] or [setting.at(address)]
    top = min(position.imag for position in tops)
    low = min([position.imag for position in (*sites, *(setting.at(body.name) for body in sliding))]) - FOOT
    sides: dict[float, float] = {}
    for side in (-1.0, 1.0):
        beside = [body for body in sliding if (setting.at(body.name) - tops[0]).real * side > 0.0]
        if beside:
            inner = min(setting.at(b.name).real * side - 0.5 * setting.sizes(b.name)[0] for b in beside) - GAP
            guide = complex(side * (inner + 0.5 * GAP), low + 0.1), complex(side * (inner + 0.5 * GAP), top - ROOM)
            sketch.shapes.append(LineShape(guide, "rod"))
        else:
            inner = max(position.real * side for position in (*tops, *sites))
            inner = max(inner, max(position.real * side for position in tops) + ROOM + 0.5)
        sides[side] = side * inner
    left, right = sides[-1.0], sides[1.0]
    corners = (complex(left, low), complex(right, low), complex(right, top), complex(left, top))
    sketch.shapes[:0] = [Area(corners, "wedge"), *hatched_line(complex(left - 1.4, low), complex(right + 1.4, low))]
    _eyes(setting, address, sides, sketch)
    text = setting.plan.caption(address)
    size = SIZE if text == setting.plan.name(address) else SMALL
    sketch.labels.append(LabelRequest(text, (0.5 * (corners[0] + corners[2]),), address, size))
    setting.drawn.add(address)


def _eyes(setting: DrawingContext, address: str, sides: dict[float, float], sketch: Sketch) -> None:
    """Draw the short arms that attach string ends, and pulleys at the edges, to a box."""
    ends = {site for line in setting.mechanism.lines for site in (line.through[0], line.through[-1])}
    for site in setting.mechanism.sites:
        at, bends = setting.site(site.name), {name: (a, b) for name, a, b in _bends(setting)}
        if site.body != address or (site.name not in ends and site.name not in bends):
            continue
        wall = sides[1.0 if at.real > 0.5 * sum(sides.values()) else -1.0]
        if site.name in bends:
            to = _axle(at, *bends[site.name])
            sketch.shapes.append(LineShape((complex(wall, at.imag - 0.5 * setting.plan.sizes.height), to), "edge"))
        elif abs(wall - at.real) > ZERO_TOL:
            sketch.shapes.append(LineShape((complex(wall, at.imag), at), "edge"))


def _bends(setting: DrawingContext) -> Iterator[tuple[str, complex, complex]]:
    """Yield the sites without named pulleys at which strings bend, with both directions away from them."""
    for line in setting.mechanism.lines:
        for (before, _), (site, after) in pairwise(pairwise(line.through)):
            if setting.owns(site) and not is_pulley(setting.plan.scene.bodies.get(site.rpartition(".")[0])):
                a, b = _string_direction(setting, site, before), _string_direction(setting, site, after)
                if abs(cross(a, b)) > ZERO_TOL:
                    yield site, a, b


def _string_direction(setting: DrawingContext, site: str, other: str) -> complex:
    """Return the direction from a site to its neighbour on a string."""
    if setting.owns(other):
        return unit_vector(setting.site(other) - setting.site(site))
    facing = setting.plan.scene.builder.faces.get(site)
    return RIGHT if facing is None else unit_vector(flat(facing))


def _axle(at: complex, before: complex, after: complex) -> complex:
    """Return the centre of a small pulley that touches both segments of a string."""
    middle = unit_vector(before + after)
    return at + SMALL_PULLEY_RADIUS / abs(cross(middle, after)) * middle


def _wheel(setting: DrawingContext, site: str, before: complex, after: complex, sketch: Sketch) -> None:
    """Draw a small pulley inside the bend of a string, supported from outside."""
    at = _axle(setting.site(site), before, after)
    if setting.mechanism.site[site].body is None:
        sketch.shapes += plate(-UP if (before + after).imag > 0.0 else UP, at, 0.45, 0.6)
    sketch.shapes += [Arc(at, SMALL_PULLEY_RADIUS), axle_dot(at, 0.05)]
