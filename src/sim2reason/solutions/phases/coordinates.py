"""Coordinates for equations of motion: positions and angles that the text gives, otherwise displacements."""

from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from math import atan2, pi

from sim2reason.scenes.dsl.frames import Frames, initial_frames
from sim2reason.scenes.dsl.mechanism import Coordinate, Mechanism
from sim2reason.scenes.dsl.units import parse_unit
from sim2reason.scenes.dsl.vectors import dot, inner, subtract_triples
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.laws.equations_of_motion import Names
from sim2reason.solutions.setting import DIRECTION_TOLERANCE, ProblemContext, join_words
from sim2reason.solutions.writing.lexicon import DualValue, Lexicon, UnreadError
from sim2reason.solutions.writing.notation import (
    ACCELERATION,
    ANGULAR_ACCELERATION,
    ANGULAR_SPEED,
    METRES,
    RADIANS,
    SPEED,
    split_name,
    with_subscript,
)
from sim2reason.solutions.writing.steps import SolutionBuilder

DEFLECTION = r"\varphi"  # prefix of the symbols of angles with the downward vertical
AXES = {0: "x", 1: "y", 2: "z"}
SLIDE_UNITS = METRES, SPEED, ACCELERATION
HINGE_UNITS = RADIANS, ANGULAR_SPEED, ANGULAR_ACCELERATION
COUNTED = (
    "The number of a phase, as a subscript, marks accelerations and forces in that phase, and other quantities at its "
    "end."
)


@dataclass(frozen=True, slots=True)
class _Choice:
    """A coordinate as the text uses it: letter, origin, positive sense (1 or -1), description and subscripts."""

    letter: str
    origin: Polynomial
    sense: float
    description: str
    marks: str


@dataclass(frozen=True, slots=True)
class ChosenCoordinates:
    """The symbols of all coordinates, and the sentence that introduces them."""

    names: Names
    sentence: str
    descriptions: tuple[str, ...]

    def used(self, names: AbstractSet[str]) -> str:
        """Return a sentence that introduces only the coordinates and derivatives used by phases in closed form.

        `names` are the names in use, with the number of a phase as the last part of their subscripts.
        """
        stems = {_without_phase(name) for name in names}
        own, indices = [*zip(self.names.places, self.names.rates, self.names.accelerations, strict=True)], list[int]()
        indices = [n for n, symbols in enumerate(own) if any(symbol.name in stems for symbol in symbols)]
        if not indices:
            return ""
        clauses = [f"${own[n][0].name}$ be {self.descriptions[n]}" for n in indices]
        derived: list[str] = []
        for n in indices:
            q, v, a = own[n]
            rated = v.name in stems
            derived += [f"${v.name} = {_dotted(q)}$"] if rated else []
            after = _dotted(v) if rated else _dotted(q, r"\ddot")
            derived += [f"${a.name} = {after}$"] if a.name in stems else []
        followed = f", and let {join_words(derived)}" if derived else ""
        let = f"Let {join_words(clauses)}{followed}."
        phases = {number for name in names if (number := split_name(name)[1].rpartition(",")[2]).isdigit()}
        return f"{let} {COUNTED}" if len(phases) > 1 else let


def choose(setting: ProblemContext, book: SolutionBuilder) -> ChosenCoordinates:
    """Name the coordinates of the mechanism, their derivatives and the time.

    A position or an angle that the text gives becomes a coordinate itself; every other coordinate is the displacement
    from the start.
    """
    places, rates, accelerations, choices = list[Symbol](), list[Symbol](), list[Symbol](), list[_Choice]()
    for k, coordinate in enumerate(setting.mechanism.coordinates):
        choice = _hinge(setting, k) if coordinate.kind == "hinge" else _slide(setting, k)
        hinge = coordinate.kind == "hinge"
        label = choice.letter if not hinge and choice.letter != "s" else ""
        marks = ",".join(part for part in (choice.marks, label) if part)
        choices.append(choice)
        places.append(book.fresh(choice.letter, choice.marks))
        rates.append(book.fresh(r"\omega" if hinge else _velocity(setting, marks), marks))
        accelerations.append(book.fresh(r"\alpha" if hinge else "a", marks))
    senses, origins = tuple(c.sense for c in choices), tuple(c.origin for c in choices)
    names = Names(tuple(places), tuple(rates), tuple(accelerations), book.fresh("t"), senses, origins)
    return ChosenCoordinates(names, _introduction(names, choices), tuple(choice.description for choice in choices))


def _velocity(setting: ProblemContext, marks: str) -> str:
    """Return a letter for velocities, u if the text uses v for a number."""
    return "u" if setting.is_given(with_subscript("v", marks)) else "v"


def _introduction(names: Names, choices: list[_Choice]) -> str:
    clauses = [
        f"${position.name}$ be {choice.description}" for position, choice in zip(names.places, choices, strict=True)
    ]
    pairs = zip(names.places, names.rates, names.accelerations, strict=True)
    derived = [f"${v.name} = {_dotted(q)}$, ${a.name} = {_dotted(v)}$" for q, v, a in pairs]
    whose = "its derivatives are" if len(clauses) == 1 else "their derivatives are"
    return f"Let {join_words(clauses)}; {whose} {', '.join(derived)}."


def _dotted(symbol: Symbol, dots: str = r"\dot") -> str:
    base, mark = split_name(symbol.name)
    return rf"{dots}{{{base}}}" + (f"_{{{mark}}}" if mark else "")


def _without_phase(name: str) -> str:
    """Return a name without the phase number, the last part of its subscript."""
    base, mark = split_name(name)
    return with_subscript(base, ",".join(mark.split(",")[:-1]))


def _slide(setting: ProblemContext, k: int) -> _Choice:
    """Choose a position along an axis of the text if its initial value is given, otherwise a displacement."""
    mechanism, coordinate = setting.mechanism, setting.mechanism.coordinates[k]
    body = mechanism.body[coordinate.body]
    mark = setting.subscript_of(coordinate.body)
    axis = next((n for n in range(3) if abs(coordinate.axis[n]) > 1.0 - DIRECTION_TOLERANCE), None)
    several = len(body.coordinates) > 1
    if axis is not None and body.parent is None and several:
        sense = 1.0 if coordinate.axis[axis] > 0.0 else -1.0
        origin = _given_place(setting.lexicon, k, sense)
        description = _position(setting, coordinate.body, AXES[axis])
        if origin is not None and description:
            letter = coordinate.label if len(coordinate.label) == 1 else AXES[axis]
            return _Choice(letter, origin, sense, description, mark)
    plane = several and not any(abs(each.axis[2]) > 1.0 - DIRECTION_TOLERANCE for each in body.coordinates)
    if plane and coordinate.label in AXES.values():  # of the text
        description = f"the displacement of {setting.display_name(coordinate.body)} along {coordinate.label}"
        return _Choice(coordinate.label, NIL, 1.0, description, mark)
    backwards = coordinate.speed < 0.0
    sense = -1.0 if backwards else 1.0
    direction = coordinate.axis if not backwards else (-coordinate.axis[0], -coordinate.axis[1], -coordinate.axis[2])
    letter = coordinate.label if several and len(coordinate.label) == 1 else "s"
    return _Choice(letter, NIL, sense, _moved(setting, coordinate, direction), mark)


def _position(setting: ProblemContext, body: str, axis: str) -> str:
    """Return the description of a position coordinate that the text or a suspension defines; else empty."""
    who = setting.display_name(body)
    if any(split_name(given.symbol)[0] in AXES.values() for given in setting.lexicon.givens.values()):
        return f"the {axis} coordinate of {who}"
    if any(line.law.row for line in setting.mechanism.lines):
        adjective = {"x": "horizontal", "y": "horizontal", "z": "vertical"}[axis]
        return f"the {adjective} coordinate of {who}, measured from the point of suspension"
    return ""


def _moved(setting: ProblemContext, coordinate: Coordinate, direction: tuple[float, float, float]) -> str:
    mechanism, who = setting.mechanism, setting.display_name(coordinate.body)
    if any(burn.body == coordinate.body for burn in mechanism.burns):
        return f"the distance that {who} has moved from its starting point"
    parent = mechanism.body[coordinate.body].parent
    off = any(abs(inner(foot.normal, coordinate.axis)) > 1.0 - DIRECTION_TOLERANCE for foot in mechanism.feet)
    where = "off the plane" if off else setting.direction_words(direction, on=parent)
    relative = f" relative to {setting.display_name(parent)}" if parent is not None else ""
    return f"the displacement of {who} {where}{relative}"


def _given_place(lexicon: Lexicon, k: int, sense: float) -> Polynomial | None:
    """Return the initial value of coordinate k as a position if the text states it or it is zero; None otherwise.

    The text may count positions from another origin than the mechanism: then the initial coordinate is one of its
    numbers, with which the fixed points of springs have simple coordinates as well.
    """
    begun, fixed = _along(lexicon.mechanism, k, sense), _along(lexicon.twin, k, sense)
    try:
        offsets = [
            lexicon.read(DualValue(a - begun[0], b - fixed[0])) for a, b in zip(begun[1:], fixed[1:], strict=True)
        ]
        own = lexicon.read(DualValue(begun[0], fixed[0]))
    except UnreadError:
        return None
    metre = parse_unit("m")
    lengths = [
        Polynomial.from_expression(Symbol(given.symbol))
        for given in lexicon.givens.values()
        if parse_unit(given.parameter.measure.unit).factor_to(metre) is not None
    ]
    fitting = [
        position
        for position in (own, *lengths)
        if _simple(position) and all(_simple(position + part) for part in offsets)
    ]
    return fitting[0] if fitting else None


def _simple(position: Polynomial) -> bool:
    return not position or position.symbol is not None


def _along(m: Mechanism, k: int, sense: float) -> list[float]:
    """Return the positions, m, along a coordinate's axis, of its body, other bodies and fixed ends of its lines."""
    coordinate, frames = m.coordinates[k], initial_frames(m)
    sites = [
        site
        for line in m.lines
        if any(m.site[s].body == coordinate.body for s in line.through)
        for site in line.through
        if m.site[site].body is None
    ]
    others = [body.name for body in m.bodies if body.name != coordinate.body]
    points = [frames.center(name) for name in (coordinate.body, *others)] + [frames.site(site) for site in sites]
    return [sense * float(dot(point.place, coordinate.axis)) for point in points]


def _hinge(setting: ProblemContext, k: int) -> _Choice:
    """Choose the angle with the downward vertical if its initial value is given, otherwise the angle turned."""
    coordinate = setting.mechanism.coordinates[k]
    who, mark = setting.display_name(coordinate.body), setting.subscript_of(coordinate.body)
    one, other = _deflection(setting.lexicon.mechanism, k), _deflection(setting.lexicon.twin, k)
    if one is None or other is None or setting.mechanism.forces:
        return _choose_turned_angle(setting, coordinate)
    (here, turn), (there, _) = one, other
    side = 1.0 if here >= 0.0 else -1.0
    description = f"the angle from the downward vertical through the axle to {_line(who)}"
    try:
        origin = setting.lexicon.read(DualValue(abs(here), abs(there)))
    except UnreadError:
        origin = NIL
    if origin.symbol is not None and origin == Polynomial.from_expression(origin.symbol):
        return _Choice(DEFLECTION, origin, side * turn, description, mark)
    if abs(here) < DIRECTION_TOLERANCE and abs(there) < DIRECTION_TOLERANCE:
        sense = -1.0 if coordinate.speed * turn < 0.0 else 1.0
        return _Choice(DEFLECTION, NIL, sense * turn, description, mark)
    return _choose_turned_angle(setting, coordinate)


def _choose_turned_angle(setting: ProblemContext, coordinate: Coordinate) -> _Choice:
    """Choose the angle turned, positive in the direction of the initial rotation."""
    speeds = [c.speed for c in setting.mechanism.coordinates if c.kind == "hinge"]
    sense = -1.0 if max(speeds, key=abs) < 0.0 else 1.0  # one sense for all
    description = f"the angle through which {setting.display_name(coordinate.body)} has turned"
    if abs(coordinate.axis[1]) > 1.0 - DIRECTION_TOLERANCE:
        description += f" {'clockwise' if sense * coordinate.axis[1] > 0.0 else 'counter-clockwise'}"
    return _Choice(r"\psi", NIL, sense, description, setting.subscript_of(coordinate.body))


def _line(who: str) -> str:
    return f"the line from there to the centre of mass of {who}"


def _deflection(m: Mechanism, k: int) -> tuple[float, float] | None:
    """Return the initial angle of a hinge's centre of mass with the downward vertical, and its sense.

    The angle counts towards the right in radians; the sense is 1 if it grows with the coordinate, -1 if it falls. None
    if the hinge is not horizontal, moves with something that turns, or carries its centre of mass on its axis.
    """
    frames: Frames = initial_frames(m)
    if abs(m.coordinates[k].axis[1]) < 1.0 - DIRECTION_TOLERANCE:
        return None
    bodies = [body for body in m.bodies if body.mass and (steps := frames[body.name].steps) and steps[-1].number == k]
    if not bodies or any(len(frames[body.name].hinges) != 1 for body in bodies):
        return None
    pivot = frames[bodies[0].name].hinges[0].pivot
    assert pivot is not None
    mass = sum(body.mass for body in bodies)
    offsets = [(body.mass / mass, subtract_triples(frames.center(body.name).place, pivot)) for body in bodies]
    x, z = (sum(share * float(offset[n]) for share, offset in offsets) for n in (0, 2))
    if x * x + z * z < DIRECTION_TOLERANCE * DIRECTION_TOLERANCE:
        return None
    beta = atan2(x, -z)
    beta = beta if abs(abs(beta) - pi) > DIRECTION_TOLERANCE else abs(beta)
    return beta, -m.coordinates[k].axis[1]
