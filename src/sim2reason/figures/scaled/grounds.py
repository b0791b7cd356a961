"""Surfaces under or beside bodies: slopes, floors, walls, curved tracks, wedges, tables."""

from cmath import phase
from collections.abc import Iterator
from dataclasses import dataclass
from math import acos, degrees

from sim2reason.figures.paths import owner_name
from sim2reason.figures.plane import UP, box, cross, dot, unit_vector
from sim2reason.figures.scaled.rails import rails, walls
from sim2reason.figures.scaled.setting import DrawingContext, vector
from sim2reason.figures.scaled.tabletop import spread
from sim2reason.figures.shapes import (
    SIZE,
    SMALL,
    Arc,
    Area,
    LabelRequest,
    Sketch,
    corner_angle,
    hatched_line,
    rough,
    width,
)
from sim2reason.scenes.dsl.body import BigBox, Globe, MovingSlope, Tabletop
from sim2reason.scenes.dsl.mechanism import Prop, SurfaceContact

BEYOND, MIN_SURFACE_LENGTH = 0.8, 3.4  # units by which a surface extends beyond the bodies on it, and its least length
ZERO_SLOPE_TOL = 1e-6
MIN_FLOOR_COSINE = 0.99  # cosine of the normal to the vertical from which a surface is a floor
GLOBE_RADIUS = 9.0  # units, radius of a planet of which only the top is visible
WIDTH_FACTOR = 1.25  # times the width of the bodies on a surface, before `BEYOND`


@dataclass(frozen=True, slots=True)
class Surface:
    """A straight surface: contact points, normal, and its body (None if it is fixed)."""

    owner: str | None
    normal: complex
    touched: tuple[complex, ...]
    face: SurfaceContact | None = None  # with what friction something lies on it

    @property
    def along(self) -> complex:
        """Return the unit vector along the surface, to the right or up."""
        direction = self.normal * -1j
        return (
            direction
            if direction.real > ZERO_SLOPE_TOL or (abs(direction.real) <= ZERO_SLOPE_TOL and direction.imag > 0.0)
            else -direction
        )

    @property
    def ends(self) -> tuple[complex, complex]:
        """Return both ends of the surface, with a margin beyond its contact points."""
        places = sorted(dot(point, self.along) for point in self.touched)
        low, high = places[0] - BEYOND, places[-1] + BEYOND
        more = max(0.0, 0.5 * (MIN_SURFACE_LENGTH - (high - low)))
        base = self.touched[0] - dot(self.touched[0], self.along) * self.along
        return base + (low - more) * self.along, base + (high + more) * self.along


def surfaces(setting: DrawingContext) -> list[Surface]:
    """Return the straight surfaces on which bodies lie, without repetitions."""
    surfaces_by_key: dict[tuple[str | None, float, float, float], Surface] = {}
    for face in setting.mechanism.faces:
        parent = setting.mechanism.body[face.subject].parent
        carried = face.subject in setting.stacked or isinstance(setting.look(parent or ""), BigBox)
        bears = isinstance(setting.look(face.subject), MovingSlope | BigBox)
        if not setting.owns(face.subject) or face.turning or carried or bears:
            continue
        normal = unit_vector(setting.view.project_direction(vector(setting.frames.normal(face.subject))) or UP)
        below = reach(setting, face)
        half = max(WIDTH_FACTOR * below, 0.5 * setting.sizes(face.subject)[0]) * normal * 1j
        at = setting.at(face.subject)
        for end in (at - half, at + half, *walls(setting, at, normal * 1j, parent)):
            _touch(surfaces_by_key, parent, normal, end - below * normal, face)
    for foot in setting.mechanism.feet:
        at, normal = setting.site(foot.site), unit_vector(setting.view.project_direction(foot.normal))
        if setting.owns(foot.name) and abs(dot(at, normal) - setting.view.scale * foot.height) < ZERO_SLOPE_TOL:
            for end in _below(setting, setting.mechanism.site[foot.site].body or "", at, normal):
                _touch(surfaces_by_key, None, normal, end)
    return list(surfaces_by_key.values())


def _below(setting: DrawingContext, body: str, foot: complex, normal: complex) -> Iterator[complex]:
    """Yield two points of the surface under a body, on both sides of the body's lowest point."""
    along = normal * 1j
    middle = dot(foot, normal) * normal + dot(setting.at(body), along) * along
    for side in (-WIDTH_FACTOR, WIDTH_FACTOR):
        yield middle + side * setting.radius(body) * along


def reach(setting: DrawingContext, face: SurfaceContact) -> float:
    """Return the distance from a body's position to its face, in units: its radius, or half its height if it slides."""
    turning = [abs(factor) for name, factor in face.slip if name.endswith(".hinge")]
    return setting.view.scale * turning[0] if turning else setting.radius(face.subject)


def _touch(
    surfaces_by_key: dict[tuple[str | None, float, float, float], Surface],
    owner: str | None,
    normal: complex,
    point: complex,
    face: SurfaceContact | None = None,
) -> None:
    key = (owner, round(normal.real, 6), round(normal.imag, 6), round(dot(point, normal), 2))
    before = surfaces_by_key[key].touched if key in surfaces_by_key else ()
    surfaces_by_key[key] = Surface(owner, normal, (*before, point), face)


def grounds(setting: DrawingContext) -> Sketch:
    """Return the sketch of all surfaces under bodies, from back to front."""
    sketch = Sketch()
    _straight(setting, sketch)
    for face in setting.mechanism.faces:
        if setting.owns(face.subject) and face.turning:
            _curved(setting, face, sketch)
    sketch.extend(rails(setting))
    _walls(setting, sketch)
    for address, body in setting.bodies.items():
        if isinstance(body.look, Tabletop):
            _note(setting, address, body.look.tilt, sketch)
    return sketch


def _straight(setting: DrawingContext, sketch: Sketch) -> None:
    """Draw planes, floors and wedges."""
    straight = surfaces(setting)
    wedges = dict.fromkeys(s.owner for s in straight if isinstance(setting.look(s.owner or ""), MovingSlope))
    for surface in straight:
        if surface.owner not in wedges:
            _fixed(setting, surface, sketch)
            _rough(setting, surface, sketch)
    for owner in wedges:
        _wedge(setting, owner or "", [s for s in straight if s.owner == owner], sketch)


def _fixed(setting: DrawingContext, surface: Surface, sketch: Sketch) -> None:
    """Draw a fixed surface as a hatched line; for a slope also the triangle below it, with its angle."""
    a, b = surface.ends
    slope = surface.along.imag
    if abs(slope) < ZERO_SLOPE_TOL or surface.normal.imag < ZERO_SLOPE_TOL:
        sketch.shapes += hatched_line(a, b) if surface.normal.imag > 0.0 or slope > 0.0 else hatched_line(b, a)
        return
    low, high = (a, b) if a.imag < b.imag else (b, a)
    corner = complex(high.real, low.imag)
    sketch.shapes.append(Area((low, corner, high) if corner.real > low.real else (corner, low, high), "fixed"))
    left, right = sorted((low, corner), key=lambda p: p.real)
    sketch.shapes += hatched_line(left, right)
    _angle(low, high, sketch, setting)


def _rough(setting: DrawingContext, surface: Surface, sketch: Sketch) -> None:
    """Draw dots under a face with friction, and its coefficient if the text states it."""
    face = surface.face
    if face is None or face.friction == 0.0:
        return
    a, b = surface.ends
    sketch.shapes.append(rough(a, b, surface.normal))
    coefficients = (coefficient for owner in setting.owners if (coefficient := setting.plan.friction_text(owner, face)))
    if text := next(coefficients, ""):
        left, low, right, _ = box((a, b))
        wide = 0.5 * width(text, SMALL)
        spots = (complex(0.5 * (left + right), low - 0.5), complex(right - wide, low - 0.5))
        inside = complex(right - wide - 0.2, low + 0.3)
        sketch.labels.append(LabelRequest(text, (inside, *spots) if a.imag != b.imag else spots, "", SMALL, name=False))


def _angle(low: complex, high: complex, sketch: Sketch, setting: DrawingContext) -> None:
    """Draw the angle at the foot of a slope."""
    direction = unit_vector(high - low)
    side = 1.0 if direction.real > 0.0 else -1.0
    value = round(degrees(acos(min(1.0, abs(direction.real)))), 9)
    if value % 90.0 == 0.0:
        return
    start, stop = (0.0, value) if side > 0.0 else (180.0 - value, 180.0)
    texts = [text for owner in setting.owners if (text := setting.stated(owner, "deg", value))]
    for owner in setting.owners:
        setting.state_once(owner, "deg", value)
    if texts:
        sketch.extend(corner_angle(low, (start, stop), texts[0], next(iter(setting.owners))))


def _wedge(setting: DrawingContext, owner: str, faces: list[Surface], sketch: Sketch) -> None:
    """Draw a body with one or two faces, standing on its floor."""
    ends = [sorted(face.ends, key=lambda p: p.imag) for face in faces]
    if len(faces) == 2:
        apex = _meeting(faces[0], faces[1])
        ends = [[low, apex] for low, _ in ends]
    base = min(low.imag for low, _ in ends)
    feet = [low + (high - low) * (base - low.imag) / (high.imag - low.imag or 1.0) for low, high in ends]
    tops = [high for _, high in ends]
    corners = [*feet, *tops, *(complex(top.real, base) for top in tops if len(faces) == 1)]
    left, _, right, _ = box(corners)
    outline = tuple(sorted(corners, key=lambda p: _round(p, sum(corners) / len(corners))))
    sketch.shapes += [Area(outline, "wedge"), *hatched_line(complex(left - 0.9, base), complex(right + 0.9, base))]
    for foot, top in zip(feet, tops, strict=True):
        _angle(foot, top, sketch, setting)
    text = setting.plan.caption(owner)
    middle = sum(corners) / len(corners)
    size = SIZE if text == setting.plan.name(owner) else SMALL
    places = tuple(middle + dx - 0.2j for dx in (0.0, 0.35, -0.35, 0.7, -0.7))
    sketch.labels.append(LabelRequest(text, places, owner, size))
    setting.drawn.add(owner)


def _round(point: complex, middle: complex) -> float:
    return (
        unit_vector(point - middle).real
        if point.imag < middle.imag - ZERO_SLOPE_TOL
        else 4.0 - unit_vector(point - middle).real
    )


def _meeting(one: Surface, other: Surface) -> complex:
    """Return the intersection of two surfaces."""
    a, u, b, v = one.touched[0], one.along, other.touched[0], other.along
    return a + u * cross(b - a, v) / cross(u, v)


def _curved(setting: DrawingContext, face: SurfaceContact, sketch: Sketch) -> None:
    """Draw a circular track about the origin of a body's frame, inside or outside the body on it."""
    center = setting.view.at(vector(setting.frames[face.subject].origin))
    at = setting.at(face.subject)
    outward = dot(setting.view.project_direction(vector(setting.frames.normal(face.subject))), at - center) > 0.0
    radius = abs(at - center)
    if not face.guided:
        radius += setting.radius(face.subject) * (-1.0 if outward else 1.0)
    if face.guided:
        sketch.shapes.append(Arc(center, radius))
        return
    start, stop = (0.0, 180.0) if outward else (180.0, 360.0)
    sketch.shapes.append(Arc(center, radius, start, stop))
    if outward:
        sketch.shapes += hatched_line(center - radius - 0.6, center + radius + 0.6)


def _walls(setting: DrawingContext, sketch: Sketch) -> None:
    """Draw the ground and walls that bodies may hit, and supports of bodies that stand on edges."""
    standing = {
        setting.mechanism.site[site].body
        for line in setting.lines
        if isinstance(line.law, Prop)
        for site in line.through
    }
    falling = (body for body in setting.members if body.name not in standing)
    floors = {f for body in falling if (f := setting.floor(body)) is not None}
    for height in floors:
        around = [setting.at(body.name) for body in setting.members]
        left, _, right, _ = box(around)
        level = setting.view.at((0.0, 0.0, height)).imag
        sketch.shapes += hatched_line(complex(left - 1.2, level), complex(right + 4.2, level))
    for meeting in setting.mechanism.meetings:
        if meeting.a is not None or meeting.normal is None or not setting.owns(meeting.b):
            continue
        if setting.view.level:
            continue  # the sheet ends there
        if abs(meeting.normal[2]) < MIN_FLOOR_COSINE:  # a wall across a track, level or not
            normal, at = unit_vector(setting.view.project_direction(meeting.normal)), setting.at(meeting.b)
            foot = at + (meeting.distance * setting.view.scale - dot(at, normal)) * normal
            half = 0.9 * normal * -1j
            sketch.shapes += hatched_line(foot - half, foot + half)
    for line in setting.lines:
        if isinstance(line.law, Prop):
            _stand(setting, line.through, sketch)


def _stand(setting: DrawingContext, ends: tuple[str, ...], sketch: Sketch) -> None:
    """Draw the ground at an initial contact between a fixed point and a body that may lift off, such as a rocket."""
    for site, other in (ends, ends[::-1]):
        body = setting.mechanism.site[other].body
        if setting.mechanism.site[site].body is None and body is not None:
            up = unit_vector(setting.site(other) - setting.site(site) or UP)
            foot, half = setting.at(body) - 0.65 * up, 2.2 * up * -1j
            if any(isinstance(b.look, Globe) for b in setting.bodies.values()):
                turn = degrees(phase(up))
                sketch.shapes.append(Arc(foot - GLOBE_RADIUS * up, GLOBE_RADIUS, turn - 16.0, turn + 16.0))
            else:
                sketch.shapes += hatched_line(foot - half, foot + half)


def _note(setting: DrawingContext, address: str, tilt: float, sketch: Sketch) -> None:
    """Add a label that states the tilt of a table, because a view from above cannot show the tilt."""
    setting.drawn.add(address)
    if tilt:
        text = f"tilted at {setting.stated(owner_name(address), 'deg', tilt)}; y points up the slope"
        left, low, right, _ = spread(setting)
        spot = complex(0.5 * (left + right), low - 0.45)
        sketch.labels.append(LabelRequest(text, (spot,), address, SMALL, name=False))
