"""Initial velocities, and stated angles and heights, drawn as arrows, arcs and dimension lines."""

from cmath import phase, rect
from collections.abc import Mapping
from math import degrees, pi, radians

from sim2reason.figures.paths import owner_name
from sim2reason.figures.plane import RIGHT, UP, cross, crosses, dot, segment_distance, unit_vector
from sim2reason.figures.scaled.lines import label_positions
from sim2reason.figures.scaled.setting import OBLONG, DrawingContext, vector
from sim2reason.figures.shapes import SMALL, Arc, LabelRequest, LineShape, Shape, Sketch, width
from sim2reason.scenes.dsl.body import Slender
from sim2reason.scenes.dsl.body import Small as SmallBody
from sim2reason.scenes.dsl.measures import show_unit
from sim2reason.scenes.dsl.mechanism import RigidBody
from sim2reason.scenes.dsl.vectors import inner

LENGTHS, SHORTEST = (1.7, 1.3, 1.0, 0.75, 0.6), 0.6  # units, of the longest arrow and of any: thrice its head
ARROW_GAP = 0.15  # units between two arrows, at least
REST_SPEED = 1e-9
MINUS = "\N{MINUS SIGN}"
ARC_SEGMENTS = 12  # straight segments of a curved arrow
ARC_RADIUS = 0.85
SPEED_STEPS = (1.0, 2.0, 5.0)


def speeds(setting: DrawingContext, *, headings: bool = True) -> Sketch:
    """Draw the initial velocity of every moving body as an arrow, labelled with its speed or with one common scale.

    With `headings`, angles of velocities are drawn too.
    """
    sketch, unsaid = Sketch(), False
    moving = {b.name: v for b in setting.members if _shown(setting, b, v := setting.velocity(b.name))}
    fastest = max((abs(v) for v in moving.values()), default=0.0)
    longest = next((n for n in LENGTHS if not _runs_over(setting, moving, n / fastest)), LENGTHS[-1]) if moving else 0.0
    unit_of_speed = setting.mechanism.units.spell("m/s")
    long = {name: max(SHORTEST, longest * abs(velocity) / fastest) for name, velocity in moving.items()}
    ahead = {name: (_tail(setting, name, unit_vector(v)), long[name] * unit_vector(v)) for name, v in moving.items()}
    for name, velocity in moving.items():
        direction, (start, arrow) = unit_vector(velocity), ahead[name]
        if any(_run_together(ahead[name], other) for each, other in ahead.items() if each != name):
            start = _arrow_start(setting, name, direction)
        end = start + arrow
        sketch.shapes.append(LineShape((start, end), "thin", arrow=True))
        text = _speed(setting, name, abs(velocity))
        unsaid |= not text
        if text:
            tip = end + direction * (0.15 + 0.5 * width(text, SMALL) * abs(direction.real) + 0.2 * abs(direction.imag))
            sketch.labels.append(
                LabelRequest(text, (tip, *label_positions(start, end, text, SMALL)), name, SMALL, name=False)
            )
        if headings:
            _heading(setting, name, velocity, sketch)
    if unsaid and len(moving) > 0:
        value = max(m * 10.0**k for k in range(-6, 7) for m in SPEED_STEPS if m * 10.0**k <= fastest * 1.001)
        setting.legend = (value * longest / fastest, f"{value:g} {show_unit(unit_of_speed)}")
    return sketch


def _shown(setting: DrawingContext, body: RigidBody, velocity: complex) -> bool:
    """Return whether a body gets an arrow: if its speed is stated, or else its velocity follows from the text.

    A body fixed to a rotating one gets an arrow only if its own speed is stated.
    """
    if abs(velocity) <= REST_SPEED or body.name not in setting.bodies:
        return False
    unit_of_speed = setting.mechanism.units.spell("m/s")
    stated = setting.stated(owner_name(body.name), unit_of_speed, abs(velocity))
    return bool(stated or (body.coordinates and not setting.plan.leaves_open(body.name, unit_of_speed)))


def _speed(setting: DrawingContext, name: str, speed: float) -> str:
    """Return the text of a body's stated speed, or of a stated negative velocity without its sign."""
    owner, unit_of_speed = owner_name(name), setting.mechanism.units.spell("m/s")
    velocity = setting.stated(owner, unit_of_speed, -speed)
    turned = velocity[1:] if velocity.startswith(MINUS) else ""
    return setting.stated(owner, unit_of_speed, speed) or turned


def _tail(setting: DrawingContext, name: str, direction: complex) -> complex:
    """Return the start of a velocity arrow: at the rim of a round body, beside a block, clear of strings."""
    look, at = setting.look(name), setting.at(name)
    if not isinstance(look, SmallBody) or look.kind not in OBLONG or setting.view.level:
        return at + setting.radius(name) * direction
    if name in setting.stacked.values():
        return at + (0.5 * setting.sizes(name)[0] + 0.15) * direction + 0.2 * UP
    return _arrow_start(setting, name, direction)


def _arrow_start(setting: DrawingContext, name: str, direction: complex) -> complex:
    """Return the start of an arrow above a body, or to its left."""
    out = direction * 1j if (direction * 1j).imag > 0.0 or abs(direction.imag) > 0.999 else direction * -1j
    back = 0.45 if setting.sizes(name)[0] >= setting.plan.sizes.width else 0.0  # not over a neighbour
    return setting.at(name) + (setting.radius(name) + 0.25) * out - back * direction


def _run_together(one: tuple[complex, complex], other: tuple[complex, complex]) -> bool:
    """Return whether two arrows (tail, direction) touch or cross."""
    (a, along), (b, across) = one, other
    if crosses(a, a + along, b, b + across):
        return True
    ends = ((b, one), (b + across, one), (a, other), (a + along, other))
    return any(segment_distance(point, tail, tail + arrow) < ARROW_GAP for point, (tail, arrow) in ends)


def _runs_over(setting: DrawingContext, moving: Mapping[str, complex], size: float) -> bool:
    """Return whether an arrow of this scale would cross another body."""
    spots = {body.name: (setting.at(body.name), setting.radius(body.name)) for body in setting.members}
    for name, velocity in moving.items():
        at, radius = spots[name]
        if abs(_tail(setting, name, unit_vector(velocity)) - at) > radius + REST_SPEED:
            continue  # beside it
        reach = radius + max(SHORTEST, size * abs(velocity)) + 0.15
        for other, (position, wide) in spots.items():
            along = max(0.0, min(reach, dot(position - at, unit_vector(velocity))))
            if other != name and abs(at + along * unit_vector(velocity) - position) < wide:
                return True
    return False


def _heading(setting: DrawingContext, name: str, velocity: complex, sketch: Sketch) -> None:
    """Draw the angle of a velocity to the horizontal, or to the x axis, if the text states it."""
    owner = name.split(".", maxsplit=1)[0]
    turn = degrees(phase(velocity)) % 360.0
    if setting.view.level:
        if turn % 90.0 and (text := setting.state_once(owner, "deg", turn)):
            _mark(text, name, setting, (0.0, turn), sketch)
        return
    side = 0.0 if velocity.real >= 0.0 else 180.0
    raised = turn if turn < 180.0 else turn - 360.0
    value = abs(raised) if side == 0.0 else 180.0 - abs(raised)
    if value % 90.0 > 1e-6 and (text := setting.state_once(owner, "deg", value)):
        _mark(text, name, setting, (side, raised if side == 0.0 or raised > 0.0 else raised + 360.0), sketch)


def _mark(text: str, name: str, setting: DrawingContext, turn: tuple[float, float], sketch: Sketch) -> None:
    """Draw an arc between two directions (degrees) with its value, and a dashed line at its start."""
    (start, stop), at = turn, setting.at(name)
    size = abs(stop - start)
    low, high = sorted((start, stop))
    base = rect(1.0, radians(start))
    radius = ARC_RADIUS + (0.35 if size < 20.0 else 0.0)
    sketch.shapes += [
        LineShape((at + setting.radius(name) * base, at + 1.7 * base), "hair", dashed=True),
        Arc(at, radius, low, high, weight="thin"),
    ]
    middle = rect(1.0, radians(0.5 * (low + high)))
    wide = 0.5 * width(text, SMALL)
    reach = radius + 0.12 + wide * abs(middle.real) + 0.5 * SMALL * abs(middle.imag)
    places = [at + middle * (reach + 0.15 * n) for n in range(4)]
    outside = rect(1.0, radians(high if stop == high else low) + (0.25 if stop == high else -0.25))
    places += [at + outside * (reach + 0.3 * n) for n in range(3)]
    sketch.labels.append(LabelRequest(text, tuple(places), name, SMALL, name=False))


def spins(setting: DrawingContext) -> Sketch:
    """Draw a curved arrow for every stated angular velocity, about an axle or the body's own axis."""
    sketch = Sketch()
    for body in setting.members:
        for hinge in body.coordinates:
            rate = setting.mechanism.units.spell("rad/s")
            if hinge.kind == "hinge" and abs(hinge.speed) > REST_SPEED:
                text = setting.stated(owner_name(body.name), rate, abs(hinge.speed))
                if text:
                    sense = 1.0 if inner(hinge.axis, setting.view.page_normal) * hinge.speed > 0.0 else -1.0
                    _curved(text, setting, body, sense, sketch)
    return sketch


def _curved(text: str, setting: DrawingContext, body: RigidBody, sense: float, sketch: Sketch) -> None:
    """Draw a curved arrow round a spinning body, or ahead of the far end of a body on an axle."""
    pivot = setting.view.at(vector(setting.frames[body.name].origin))
    arm = _tip(setting, body, pivot) - pivot
    axle = {c.kind for c in body.coordinates} == {"hinge"} and abs(arm) > setting.radius(body.name)
    if axle:
        radius, begin, long = 0.62 * abs(arm), phase(arm) + sense * 0.3 / abs(arm), 1.3
    else:
        radius = setting.radius(body.name) + 0.2
        begin, long = 0.5 * pi - sense * 0.7, 1.4 * radius
    turns = [begin + sense * long / radius * n / ARC_SEGMENTS for n in range(ARC_SEGMENTS + 1)]
    sketch.shapes.append(LineShape(tuple(pivot + rect(radius, turn) for turn in turns), "thin", arrow=True))
    places: list[complex] = []
    for far in (0.12, 0.3, 0.5):
        for turn in (turns[-1], turns[ARC_SEGMENTS // 2], turns[-1] + sense * 0.3 / radius):
            direction = rect(1.0, turn)
            aside = far + 0.5 * width(text, SMALL) * abs(direction.real) + 0.5 * SMALL * abs(direction.imag)
            places += [pivot + (radius + aside) * direction, pivot + (radius - aside) * direction]
    ahead = rect(1.0, turns[-1]) * 1j * sense
    tip = pivot + rect(radius, turns[-1])
    places += [
        tip + ahead * (0.15 + n * 0.2 + 0.5 * width(text, SMALL) * abs(ahead.real) + 0.5 * SMALL) for n in range(3)
    ]
    sketch.labels.append(LabelRequest(text, tuple(places), body.name, SMALL, name=False))


def deflections(setting: DrawingContext) -> Sketch:
    """Draw the stated angles between the vertical and the bodies that hang from fixed points."""
    sketch = Sketch()
    if setting.view.level:
        return sketch
    for top, end, owner in _hanging(setting):
        if abs(end - top) < REST_SPEED:
            continue
        turn = degrees(phase((end - top) / -UP))
        if abs(turn) > 1e-6 and (text := setting.state_once(owner, "deg", abs(turn))):
            radius = _free(setting, top, end, abs(turn))
            long = max(min(abs(end - top), 2.4), radius + 0.4)
            sketch.shapes.append(LineShape((top, top - long * UP), "hair", dashed=True))
            _sector(text, owner, top, turn, radius, sketch)
    return sketch


def _free(setting: DrawingContext, top: complex, end: complex, turn: float) -> float:
    """Return a radius for the arc of a deflection angle at which the arc misses the bodies on the hanging line."""
    direction, taken = unit_vector(end - top), list[tuple[float, float]]()
    for body in setting.members:
        if body.name in setting.bodies and not isinstance(setting.look(body.name), Slender):
            out, reach = setting.at(body.name) - top, setting.radius(body.name) + 0.08
            if abs(cross(direction, out)) < reach:
                taken.append((dot(direction, out) - reach, dot(direction, out) + reach))
    usual = ARC_RADIUS + (0.45 if turn < 25.0 else 0.0)
    radii = (usual, 1.5, ARC_RADIUS, 0.6, 2.0, 2.5, 3.0)
    return next((r for r in radii if not any(low < r < high for low, high in taken)), usual)


def _sector(text: str, owner: str, at: complex, turn: float, radius: float, sketch: Sketch) -> None:
    low, high = sorted((-90.0, -90.0 + turn))
    sketch.shapes.append(Arc(at, radius, low, high, weight="thin"))
    middle = rect(1.0, radians(0.5 * (low + high)))
    reach = radius + 0.12 + 0.5 * width(text, SMALL) * abs(middle.real) + 0.5 * SMALL * abs(middle.imag)
    aside = at + (1.0 if turn < 0.0 else -1.0) * (0.14 + 0.5 * width(text, SMALL))
    places = [at + middle * (reach + 0.15 * n) for n in range(5)] if abs(turn) > 25.0 else []
    places += [aside - (radius - 0.2 * n) * UP for n in range(4)]
    sketch.labels.append(LabelRequest(text, tuple(places), owner, SMALL, name=False))


def _hanging(setting: DrawingContext) -> list[tuple[complex, complex, str]]:
    """Return the lines from fixed points to hanging bodies: strings, rods and hinged arms."""
    segments: list[tuple[complex, complex, str]] = []
    for line in setting.lines:
        if len(line.through) == 2:
            ends = line.through if setting.mechanism.site[line.through[0]].body is None else line.through[::-1]
            if setting.mechanism.site[ends[0]].body is None:
                segments.append((setting.site(ends[0]), setting.site(ends[1]), owner_name(line.whole)))
    for body in setting.members:
        if any(c.kind == "hinge" for c in body.coordinates) and body.name not in setting.mechanism.contacts:
            pivot = setting.view.at(vector(setting.frames[body.name].origin))
            segments.append((pivot, _tip(setting, body, pivot), owner_name(body.name)))
    return segments


def _tip(setting: DrawingContext, body: RigidBody, pivot: complex) -> complex:
    """Return the far end of an arm: its centre of mass, or the first body that it carries."""
    at = setting.view.at(vector(setting.frames.center(body.name).place))
    if abs(at - pivot) > REST_SPEED:
        return at
    carried = (other for other in setting.members if other.parent == body.name)
    return next((setting.view.at(vector(setting.frames[other.name].origin)) for other in carried), at)


def heights(setting: DrawingContext) -> Sketch:
    """Draw the stated heights of bodies above the ground."""
    sketch = Sketch()
    for body in setting.members:
        floor = setting.floor(body)
        if floor is None:
            continue
        at, scale = setting.at(body.name), setting.view.scale
        height = setting.place(body.name)[2] - floor
        text = setting.stated(owner_name(body.name), setting.mechanism.units.length, height)
        if text and height:
            top, low = at - 0.6 * RIGHT, at - 0.6 * RIGHT - height * scale * UP
            sketch.shapes += _dimension(low, top, at)
            aside = top.real - 0.12 - 0.5 * width(text, SMALL)
            places = tuple(complex(aside, low.imag + t * height * scale) for t in (0.5, 0.65, 0.35))
            sketch.labels.append(LabelRequest(text, places, body.name, SMALL, name=False))
    return sketch


def _dimension(low: complex, top: complex, at: complex) -> list[Shape]:
    """Return a double arrow beside the measured distance, with a thin line to the body."""
    middle = 0.5 * (low + top)
    return [
        LineShape((middle, top), "hair", arrow=True),
        LineShape((middle, low), "hair", arrow=True),
        LineShape((top - 0.15 * RIGHT, at - 0.25 * RIGHT), "hair"),
    ]
