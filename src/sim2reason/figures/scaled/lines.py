"""Strings, springs, rods and arms between their end points, and the supports of their ends."""

from cmath import phase, rect
from collections.abc import Iterator
from itertools import pairwise
from math import pi

from sim2reason.figures.hanging import plate, pull_text
from sim2reason.figures.paths import spring
from sim2reason.figures.pieces import positions_around
from sim2reason.figures.plane import RIGHT, UP, cross, dot, rectangle, unit_vector
from sim2reason.figures.scaled.rails import rides
from sim2reason.figures.scaled.setting import DrawingContext, vector
from sim2reason.figures.shapes import SIZE, SMALL, Arc, Area, LabelRequest, Shape, Sketch, axle_dot, width
from sim2reason.figures.shapes import LineShape as Stroke
from sim2reason.scenes.dsl.body import Axial, Capped, PulleyWheel, Rectangular, Silhouette, Slender, Small, Spherical
from sim2reason.scenes.dsl.mechanism import Elastic, Line, Prop, Rigid, RigidBody

NAIL, PIVOT, PLATE = 0.07, 0.09, 0.25  # units: radii of a nail and of a pivot, and distance of the wall behind it
ARROW_LENGTH = 1.2
ARC_STEP = 0.2  # units, length of the straight segments of an arc
COINCIDENCE_TOLERANCE = 1e-6


def look_of(setting: DrawingContext, line: Line) -> str:
    """Return the look of a line, such as spring: declared by its connection or body, else by its force law."""
    joint = setting.plan.scene.joints.get(line.whole)
    if joint is not None:
        return joint.connection.look
    body = setting.look(line.whole)
    if isinstance(body, Slender):
        return body.kind
    match line.law:
        case Elastic():
            return "spring"
        case Rigid():
            return "rod"
        case Prop():
            return "prop"
        case _:
            return "string"


def lines(setting: DrawingContext, front: Sketch) -> Sketch:
    """Return the sketch of all lines with supports and arms; axles and joints go to the sketch `front`."""
    sketch = Sketch()
    for line in setting.lines:
        look = look_of(setting, line)
        points = [setting.site(name) for name in line.through]
        if line.circle is not None:
            _around(setting, line, line.circle, sketch)
            continue
        if look == "prop":
            continue
        wound = line.name in setting.plan.scene.builder.wound
        (front if wound else sketch).shapes += strokes(setting, line, look, points)
        sketch.labels += _named(setting, line.whole, points)
        setting.drawn.add(line.whole)
        for end, inward in () if wound else ((0, 1), (-1, -2)):
            _draw_support(setting, line.through[end], unit_vector(points[inward] - points[end] or RIGHT), sketch)
    for body in setting.members:
        _arm(setting, body, sketch, front)
    for joint in setting.plan.scene.joints.values():
        if setting.owns(joint.name) and joint.connection.carries:
            at = setting.site(joint.stops[0].sites[0])
            stiff = joint.connection.look == "weld"
            front.shapes.append(Area(rectangle(at, 0.2, 0.2), "ink") if stiff else Arc(at, PIVOT))
    return sketch


def _around(setting: DrawingContext, line: Line, ends: tuple[str, str], sketch: Sketch) -> None:
    """Draw a spring bent along the circle on which its two bodies move, and the circle if it is not yet drawn."""
    middle = setting.view.at(vector(setting.frames[ends[0]].origin))
    a, b = (setting.at(end) - middle for end in ends)
    circle = Arc(middle, round(abs(a), 6), weight="thin")  # rounded, since all bodies are on the same one
    if circle not in sketch.shapes:
        sketch.shapes.append(circle)
        _radius(setting, ends, middle, sketch)
    turn = phase(b / a) % (2.0 * pi)
    clear = min(setting.radius(ends[0]) / abs(a), 0.3 * turn)
    for straight in spring(0j, complex(abs(a) * (turn - 2.0 * clear)), line):
        along = (p + share * (q - p) for p, q in pairwise(straight) for share in (*_shares(abs(q - p)), 1.0))
        bent = (middle + (abs(a) + p.imag) * unit_vector(a) * rect(1.0, clear + p.real / abs(a)) for p in along)
        sketch.shapes.append(Stroke(tuple(bent), "thin"))
    body = setting.bodies.get(line.whole)
    if body is not None and body.letters:
        half, text = unit_vector(a) * rect(1.0, 0.5 * turn), setting.plan.name(line.whole)
        places = (middle + (abs(a) + far) * half for far in (0.5, -0.5, 0.8, -0.8))
        sketch.labels.append(LabelRequest(text, tuple(places), line.whole))
    setting.drawn.add(line.whole)


def _shares(long: float) -> Iterator[float]:
    """Yield the fractions at which a stroke is divided into short straight pieces, to bend it into an arc."""
    count = 1 + int(long / ARC_STEP)
    return (n / count for n in range(count))


def _radius(setting: DrawingContext, ends: tuple[str, str], middle: complex, sketch: Sketch) -> None:
    """Draw the stated radius of the circle on which bodies move, half way between two of them."""
    a, b = (setting.at(end) - middle for end in ends)
    owner = ends[0].split(".", maxsplit=1)[0]
    text = setting.stated(owner, setting.mechanism.units.length, abs(a) / setting.view.scale)
    if text:
        rim = middle + a * rect(1.0, 0.5 * (phase(b / a) % (2.0 * pi)))
        sketch.shapes.append(Stroke((middle, rim), "hair", arrow=True))
        sketch.labels.append(
            LabelRequest(text, tuple(label_positions(middle, rim, text, SMALL)), owner, SMALL, name=False)
        )


def strokes(setting: DrawingContext, line: Line, look: str, points: list[complex]) -> Iterator[Shape]:
    """Yield the shapes of a string, spring or rod that passes through several points."""
    for number, (a, b) in enumerate(pairwise(points)):
        if abs(b - a) < COINCIDENCE_TOLERANCE:
            continue
        direction, (first, last) = unit_vector(b - a), line.through[number : number + 2]
        start, stop = setting.edge(first, direction), setting.edge(last, -direction)
        if look == "spring":
            yield from (Stroke(part, "thin") for part in spring(start, stop, line))
        else:
            yield Stroke((start, stop), "rod" if look == "rod" else "string")


def _named(setting: DrawingContext, address: str, points: list[complex]) -> list[LabelRequest]:
    """Return the labels of a line that is a body: its name and stated length, beside its middle."""
    a, b = max(pairwise(points), key=lambda pair: abs(pair[1] - pair[0]))
    labels: list[LabelRequest] = []
    body = setting.bodies.get(address)
    if body is not None and body.letters:
        text = setting.plan.name(address)
        labels.append(LabelRequest(text, tuple(label_positions(a, b, text, SIZE)), address))
    owners = (address, address.split(".", maxsplit=1)[0])
    unit_of_length, long = setting.mechanism.units.length, abs(b - a) / setting.view.scale
    length = next((text for owner in owners if (text := setting.stated(owner, unit_of_length, long))), "")
    if length:
        labels.append(LabelRequest(length, tuple(label_positions(a, b, length, SMALL)), address, SMALL, name=False))
    return labels


def label_positions(a: complex, b: complex, text: str, size: float, far: float = 0.2) -> Iterator[complex]:
    """Yield candidate positions of a label beside a stroke, from its middle outwards."""
    direction, wide = unit_vector(b - a), 0.5 * width(text, size)
    for more in (0.0, 0.5):
        for along in (0.5, 0.6, 0.4, 0.7, 0.3, 0.8, 0.2):
            for out in (direction * 1j, direction * -1j):
                away = far + more + abs(out.real) * wide + abs(out.imag) * 0.5 * size
                yield a + along * (b - a) + out * away


def _draw_support(setting: DrawingContext, site: str, inward: complex, sketch: Sketch) -> None:
    """Draw the support of a fixed end: a wall or ceiling, a nail, or a winch."""
    if setting.mechanism.site[site].body is not None:
        return
    at, builder = setting.site(site), setting.plan.scene.builder
    if site in builder.drawing:
        text = pull_text(setting.plan, site)
        sketch.shapes += [Stroke((at, at - ARROW_LENGTH * inward), "string", arrow=True)]
        places = positions_around(at - ARROW_LENGTH * inward, 0.15, width(text, SMALL), start=-inward)
        sketch.labels.append(LabelRequest(text, places, site, SMALL, name=False))
    elif setting.view.level:
        sketch.shapes.append(axle_dot(at, NAIL))
    else:
        slanting = any(
            abs(cross(setting.along(body.name), inward)) < COINCIDENCE_TOLERANCE
            for body in setting.members
            if rides(setting, body) or body.name in setting.mechanism.contacts
        )
        sketch.shapes += [
            *plate(-inward if slanting else support_direction(inward), at, PLATE, 0.9),
            axle_dot(at, NAIL),
        ]


def support_direction(inward: complex) -> complex:
    """Return the direction of the support (up, sideways or down) of a fixed end whose line lies `inward`."""
    if inward.imag < -0.35:
        return UP
    return max((RIGHT, -RIGHT, -UP), key=lambda direction: -dot(direction, inward))


def _arm(setting: DrawingContext, body: RigidBody, sketch: Sketch, front: Sketch) -> None:
    """Draw a body that swings about an axle: the axle, and bars from it to all that the body carries."""
    sized = isinstance(setting.look(body.name), Spherical | Axial | Capped | Rectangular | Silhouette)
    if body.name in setting.mechanism.contacts or isinstance(setting.look(body.name), PulleyWheel):
        return
    stiff = not body.coordinates and body.parent is not None and isinstance(setting.look(body.name), Small | Slender)
    if {c.kind for c in body.coordinates} != {"hinge"} and not stiff:
        return
    if any(body.name in (line.circle or ()) for line in setting.lines):
        return  # a ring leads it
    pivot = setting.view.at(vector(setting.frames[body.name].origin))
    ends = [] if sized else [end for end in _ends(setting, body) if abs(end - pivot) > COINCIDENCE_TOLERANCE]
    for end in ends:
        sketch.shapes.append(Stroke((pivot, end), "rod"))
    if ends:
        far = max(ends, key=lambda end: abs(end - pivot))
        owner = body.name.split(".", maxsplit=1)[0]
        text = setting.stated(owner, setting.mechanism.units.length, abs(far - pivot) / setting.view.scale)
        pieces = carried_pieces(setting, body)
        if text and not (
            len(pieces) > 1 and any(abs(setting.at(piece) - far) < COINCIDENCE_TOLERANCE for piece in pieces)
        ):
            sketch.labels.append(
                LabelRequest(text, tuple(label_positions(pivot, far, text, SMALL)), owner, SMALL, name=False)
            )
        _lettered(setting, body.name, pivot, far, sketch)
    if body.parent is None and not setting.view.level:
        mean = sum(ends) / len(ends) - pivot if ends else -UP
        sketch.shapes += plate(
            support_direction(unit_vector(mean) if abs(mean) > COINCIDENCE_TOLERANCE else -UP), pivot, PLATE + 0.1, 0.9
        )
    if not stiff:
        front.shapes.append(Arc(pivot, PIVOT))


def carried_pieces(setting: DrawingContext, arm: RigidBody) -> list[str]:
    """Return the addresses of the bodies that an arm carries and whose drawn size is real."""
    sized = Spherical | Axial | Capped | Rectangular | Silhouette
    return [
        body.name for body in setting.members if body.parent == arm.name and isinstance(setting.look(body.name), sized)
    ]


def _lettered(setting: DrawingContext, address: str, pivot: complex, far: complex, sketch: Sketch) -> None:
    """Draw the name of an arm that is itself a body."""
    body = setting.bodies.get(address)
    if body is not None and isinstance(body.look, Slender) and body.letters:
        text = setting.plan.name(address)
        sketch.labels.append(LabelRequest(text, tuple(label_positions(pivot, far, text, SIZE)), address))
        setting.drawn.add(address)


def _ends(setting: DrawingContext, body: RigidBody) -> Iterator[complex]:
    """Yield the end points of a body's bars: its centre of mass, the bodies it carries, and its attachment points."""
    if body.mass > 0.0:
        yield setting.at(body.name)
    carried = (other for other in setting.members if other.parent == body.name)
    yield from (setting.view.at(vector(setting.frames[other.name].origin)) for other in carried)
    yield from (setting.site(site.name) for site in setting.mechanism.sites if site.body == body.name)
