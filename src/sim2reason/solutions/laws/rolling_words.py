"""Sentences about bodies that roll or slip: rotation, moment of inertia and friction."""

from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.laws.directions import slip_direction_text
from sim2reason.solutions.laws.dynamics import Dynamics, SharedRate
from sim2reason.solutions.laws.newton import Newton, Row
from sim2reason.solutions.setting import ProblemContext, capitalized
from sim2reason.solutions.writing.lexicon import UnreadError

REASON = "From then on it rolls, which on level ground needs no friction"


def radius_of(setting: ProblemContext, body: str) -> str:
    """Return the words for the radius of a body's rim: *outer radius* for a thick-walled pipe or a stepped pulley."""
    two = is_stepped(setting, body) or getattr(setting.scene.bodies.get(body), "bore", None)
    return "outer radius" if two else "radius"


def rim_of(setting: ProblemContext, body: str) -> str:
    """Return the words for the rim of a body: *the outer rim* for a stepped pulley."""
    return f"the {'outer ' if is_stepped(setting, body) else ''}rim of {setting.display_name(body)}"


def is_stepped(setting: ProblemContext, body: str) -> bool:
    """Return whether strings are wound round a body at several radii."""
    own = {c.name for c in setting.mechanism.body[body].coordinates}
    return len({abs(w.radius) for line in setting.mechanism.lines for w in line.wheels if w.coordinate in own}) > 1


def rolling_bodies(dynamics: Dynamics, shared: SharedRate) -> list[str]:
    """Return the bodies with a shared rate that rotate while their centres move.

    The rate is that of the rim relative to the centre, which is the radius times the angular rate.
    """
    bodies = (dynamics.mechanism.coordinates[k] for k in shared.sense)
    return [
        coordinate.body
        for coordinate in bodies
        if coordinate.kind == "hinge" and dynamics.newton.moving_coordinates(coordinate.body)
    ]


def only_turning(dynamics: Dynamics, shared: SharedRate) -> str:
    """Return the body of a rate that describes the rotation of one body alone, as of a slipping wheel; else ""."""
    rolling = rolling_bodies(dynamics, shared)
    return rolling[0] if len(rolling) == len(shared.sense) == 1 else ""


def turning_noun(dynamics: Dynamics, shared: SharedRate) -> str:
    """Return the words for the angular acceleration or angle of a body that only rotates, and the positive sense."""
    rate = "the angle through which it turns" if dynamics.measure.values else "its angular acceleration"
    body, sense = only_turning(dynamics, shared), _positive(dynamics, shared)
    return f"the {radius_of(dynamics.setting, body)} of {dynamics.setting.display_name(body)} times {rate}{sense}"


def rolling_words(dynamics: Dynamics, body: str, shared: SharedRate) -> str:
    """Return the sentence that a body rolls without slipping, and its rotation with the positive sense.

    The positive sense is repeated, since it may differ from that of an earlier phase.
    """
    rate = "the angle through which it turns" if dynamics.measure.values else "its angular acceleration"
    who, radius = capitalized(dynamics.setting.display_name(body)), radius_of(dynamics.setting, body)
    later = dynamics.segment is not dynamics.setting.motion.segments[0]
    sense = _positive(dynamics, shared, last=False) if later else ""
    return f"{who} rolls without slipping, so its {radius} times {rate}{sense} is ${shared.symbol.name}$, too."


def rolling_direction_words(dynamics: Dynamics, k: int, sense: float) -> str:
    """Return words for the direction in which a body rolls for a sense of rotation; "" without a surface."""
    for face in range(len(dynamics.mechanism.faces)):
        slip = dynamics.newton.slip(face)
        slides = [j for j in slip if dynamics.mechanism.coordinates[j].kind == "slide"]
        if k in slip and len(slides) == 1:
            values = dynamics.book.values
            sign = -sense * slip[k].value(values) * slip[slides[0]].value(values)
            return dynamics.moving(slides[0], 1 if sign > 0.0 else -1)
    return ""


def _positive(dynamics: Dynamics, shared: SharedRate, *, last: bool = True) -> str:
    """Return words that say which sense of a rotation counts as positive, as an aside; "" without a rotation."""
    hinges = ((k, s) for k, s in shared.sense.items() if dynamics.mechanism.coordinates[k].kind == "hinge")
    ways = [(k, sense, rolling_direction_words(dynamics, k, float(sense))) for k, sense in hinges]
    if not ways:
        return ""
    k, sense, direction = ways[0]
    how = f"in the sense of rolling {direction}" if direction else winding_direction_words(dynamics, k, sense)
    return f", counted as positive {how}{'' if last else ','}" if how else ""


def winding_direction_words(dynamics: Dynamics, k: int, sense: int) -> str:
    """Return words for the positive sense of a pulley's rotation, such as *when the string runs onto pulley P*.

    The words are empty if no string runs over the pulley.
    """
    newton, body = dynamics.newton, dynamics.mechanism.coordinates[k].body  # the rate is that of the string wound up
    for onto, to in ((True, "onto"), (False, "off")):
        for line in newton.lines:
            pace = newton.stretch(dynamics.mechanism.lines.index(line), k).value(dynamics.book.values) * sense
            if pace and (pace > 0.0) is onto and line.name in dynamics.setting.string_phrases:
                return (
                    f"when {dynamics.setting.string_phrases[line.name]} runs {to} {dynamics.setting.display_name(body)}"
                )
    return ""


def glided_words(dynamics: Dynamics, k: int) -> str:
    """Return the words before the formula of the distance or arc that a body covers at a constant rate."""
    coordinate = dynamics.mechanism.coordinates[k]
    if coordinate.kind != "hinge":
        return f"{constant_words(dynamics, k)}, which gives"
    radius = f"the {radius_of(dynamics.setting, coordinate.body)} of {dynamics.setting.display_name(coordinate.body)}"
    return f"{constant_words(dynamics, k)}, so {radius} times the angle through which it has turned is"


def not_slipping(dynamics: Dynamics, row: Row) -> str:
    """Return a clause such as *, nor does it slip on pulley P*; empty if no body turns with the string."""
    indices = (int(name[1:]) for name in sorted(row.inertia.names()) if name[0] == "q" and name[1:].isdigit())
    bodies = [c.body for c in (dynamics.mechanism.coordinates[k] for k in indices) if c.kind == "hinge"]
    return f", nor does it slip on {dynamics.setting.bodies_phrase(bodies)}" if bodies else ""


def inertia_words(dynamics: Dynamics, k: int) -> str:
    """Return the words between *torque on* a body and the equation: division by the radius, moment of inertia."""
    newton = dynamics.newton
    try:
        radius, inertia = newton.lexicon.read(newton.scale[k]), newton.turning(k, k)
    except UnreadError:
        return ", divided by its radius"
    if radius.symbol is None:
        return ", divided by its radius"
    size, called = (
        (inertia * radius * radius).expression(),
        radius_of(dynamics.setting, dynamics.mechanism.coordinates[k].body),
    )
    return f", whose moment of inertia is ${size.latex()}$, divided by its {called} ${radius.symbol.latex()}$"


def rim_inertia_words(newton: Newton, setting: ProblemContext, k: int) -> str:
    """Return the sentence with the moment of inertia of a body on a hinge; empty if it has none."""
    body = setting.mechanism.coordinates[k].body
    inertia, radius = newton.turning(k, k), radius_of(setting, body)
    size = f"${inertia.expression().latex()}$ times the square of its {radius}"
    return f"The moment of inertia of {setting.display_name(body)} is {size}." if inertia else ""


def slipping_words(dynamics: Dynamics, face: int, normal: Polynomial) -> str:
    """Return the sentence that a round body slips at its contact, with the friction in terms of the normal force."""
    newton = dynamics.newton
    size, side = newton.coefficient(face) * normal, float(newton.slip_directions[face])
    ways = [slip_direction_text(dynamics, face, sign) for sign in (side, -side)]
    if not all(ways):
        return ""
    who = capitalized(dynamics.setting.display_name(dynamics.mechanism.faces[face].subject))
    friction = f"the friction ${size.expression().latex()}$ acts on it {ways[1]}"
    return f"{who} slips {ways[0]} at the point of contact, so {friction}."


def speed_words(dynamics: Dynamics, shared: SharedRate, begun: Expression, name: Symbol) -> str:
    """Return words for the velocity that a symbol stands for, if it is plain *v* or belongs to a rotation; else ""."""
    body = only_turning(dynamics, shared)
    first = f", at first ${begun.latex()}$," if begun != ZERO else ""
    if body:
        radius = f"the {radius_of(dynamics.setting, body)} of {dynamics.setting.display_name(body)}"
        return f"{radius} times its angular velocity{first} is "
    return f"the velocity in the direction of ${shared.symbol.name}$ is " if name.name == "v" else ""


def arc_words(dynamics: Dynamics, shared: SharedRate) -> str:
    """Return the words that introduce the arc of a body that only rotates; empty for other displacements."""
    body = only_turning(dynamics, shared)
    radius = f"the {radius_of(dynamics.setting, body)} of {dynamics.setting.display_name(body)}" if body else ""
    return f"{radius} times the angle through which it has turned is " if body else ""


def constant_words(dynamics: Dynamics, k: int) -> str:
    """Return a clause that a velocity is constant; the first one adds that level rolling needs no friction."""
    newton = dynamics.newton
    rolls = any(
        side == 0 and newton.single_slip_coordinate(face) is None for face, side in newton.slip_directions.items()
    )
    turns = dynamics.mechanism.coordinates[k].kind == "hinge"
    rate = f"the {'angular velocity' if turns else 'velocity'}"
    if rolls and any(step.text.startswith(REASON) for step in dynamics.book.steps):
        return f"Then {rate} is constant"
    return f"{f'{REASON}, so' if rolls else 'From then on'} {rate} is constant"
