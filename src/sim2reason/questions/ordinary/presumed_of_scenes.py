"""Tests of the presumptions of a question, such as that a body is moving up at the moment in question."""

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np

from sim2reason.questions.moments.reached import Reached
from sim2reason.questions.ordinary.moment_phrases import fixed_end
from sim2reason.questions.ordinary.presumptions import (
    EVEN,
    MOTION_PRESUMPTIONS,
    STEADY,
    Case,
    find_named_body,
    one_way,
    relaxed_at_rest,
)
from sim2reason.questions.ordinary.vocabulary import (
    ACROSS,
    ASKS_FOR_POSITION,
    BESIDE,
    CENTERED,
    CENTRAL,
    DIES_AWAY,
    DRAWN,
    FARTHEST,
    FREE_AXLE,
    GOES_DOWN,
    GOES_UP,
    HEADING,
    LIES,
    LIFTS,
    LIGHT,
    LINE_WITH_FIXED_END,
    LOWEST,
    MUTUAL,
    PASSES_EQUILIBRIUM,
    SIDEWAYS,
    SPRUNG,
    STANDS,
)
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import ZERO, ConstantTension
from sim2reason.simulation.equilibrium import equilibrium
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.quantities.kinematics import Acceleration, Displacement, Velocity
from sim2reason.simulation.quantities.subjects.bodies import Bodies, ancestor_chain, center_path
from sim2reason.simulation.quantities.subjects.interactions import Springs
from sim2reason.simulation.quantities.subjects.rotating_parts import Pulleys, SwingingLines


def _address(mention: str, words: Words) -> str:
    """Return the first address that a phrase of the text denotes; empty if there is none."""
    return next((address for address, phrase in words.mentions.items() if phrase == mention), "")


def _light(case: Case) -> bool:
    """Return whether a pulley has no mass; true if the question names no pulley."""
    address = _address(case.who, case.words)
    body = case.words.mechanism.body.get(address)
    return body is None or body.mass == 0.0


def _sideways(case: Case) -> bool:
    """Return whether a body moves neither straight up or down nor along one line."""
    return not one_way(case)


def _lifts(case: Case) -> bool:
    """Return whether the engine of a body accelerates it upwards at the start."""
    name, start = find_named_body(case.who, case.words), case.followed.study.trace.at(0.0)
    burns = any(burn.body == name for burn in case.words.mechanism.burns)
    return burns and float(Acceleration.evaluate(start, name)[0, 2]) > EVEN


def _centered(case: Case) -> bool:
    """Return whether the centre of mass of a body lies on the body's axis."""
    name = find_named_body(case.who, case.words)
    return bool(name) and case.words.mechanism.body[name].center == ZERO


def is_fixed_spring_of(who: str, spring: str, words: Words) -> bool:
    """Return whether a spring is fixed at one end and tied to a body at the other."""
    known = {phrase: name for name, phrase in words.subject_phrases(Springs()).items()}
    alone = fixed_end(words) if spring == LINE_WITH_FIXED_END else (known.get(spring, ""),)
    line, name = words.mechanism.line.get(next(iter(alone), "")), find_named_body(who, words)
    if line is None:
        return False
    ends = {words.mechanism.site[site].body for site in (line.through[0], line.through[-1])}
    return None in ends and (who == spring or name in ends)


def _drawn(case: Case) -> bool:
    """Return whether a hand draws in a string that is tied to a body."""
    mechanism, name = case.words.mechanism, find_named_body(case.who, case.words)
    drawn = [line for line in mechanism.lines if isinstance(line.law, ConstantTension)]
    return any(name == mechanism.site[end].body for line in drawn for end in (line.through[0], line.through[-1]))


def is_carried(who: str, on: str, words: Words) -> bool:
    """Return whether a body is carried by another one, or hangs on a string that runs over a pulley."""
    mechanism, name = words.mechanism, find_named_body(who, words)
    address = _address(on, words)
    if not name:
        return False
    over = [line for line in mechanism.lines if any(site.rpartition(".")[0] == address for site in line.through[1:-1])]
    hung = any(mechanism.site[end].body == name for line in over for end in (line.through[0], line.through[-1]))
    return hung or find_named_body(on, words) in [body.name for body in ancestor_chain(mechanism, name)[1:]]


def _placed(case: Case) -> bool:
    """Return whether a question asks for a displacement, a height, an extension or the length of a spring."""
    return case.query.target is not None and case.query.target.quantity in (
        "displacement",
        "height above the start",
        "extension",
        "spring length",
    )


def _balanced(case: Case) -> bool:
    """Return whether all bodies are where they would stay at rest, and the springs have not their natural lengths."""
    rest, trace = equilibrium(case.words.mechanism), case.followed.study.trace
    if rest is None or rest.free or relaxed_at_rest(case):
        return False
    away = np.abs(trace.at(case.then).q[0] - rest.coordinates)
    return bool((away <= STEADY * np.ptp(trace.scan.q, axis=0)).all())


def _rising(case: Case) -> bool:
    """Return whether a body moves up at the instant in question, but not at earlier ones with the same value."""
    return _vertical_velocity(case, case.then) > 0.0 and not _before(case) > 0.0


def _falling(case: Case) -> bool:
    """Return whether a body moves down at the instant in question, but not at earlier ones with the same value."""
    return _vertical_velocity(case, case.then) < 0.0 and not _before(case) < 0.0


def _vertical_velocity(case: Case, time: float) -> float:
    """Return the vertical velocity of a body at a time, m/s; zero if no body is meant."""
    name = find_named_body(case.who, case.words)
    return float(Velocity.evaluate(case.followed.study.trace.at(time), name)[0, 2]) if name else 0.0


def _before(case: Case) -> float:
    """Return the vertical velocity, m/s, when a value was first reached; zero if that is the instant in question."""
    moment, trace = case.query.moment, case.followed.study.trace
    if not isinstance(moment, Reached) or moment.number == 1:
        return 0.0
    first = replace(moment, number=1).time(trace)
    return _vertical_velocity(case, first) if first is not None else 0.0


def _dies_away(case: Case) -> bool:
    """Return whether the speed of a body at the instant asked about is zero, compared with its own greatest speed."""
    name, trace = find_named_body(case.who, case.words), case.followed.study.trace
    if not name:
        return False
    speeds = np.linalg.norm(Velocity.evaluate(trace.scan, name), axis=1)
    last = float(np.linalg.norm(Velocity.evaluate(trace.at(case.then), name)))
    return last <= STEADY * float(speeds.max(initial=0.0))


def _lowest(case: Case) -> bool:
    """Return whether a body is never lower than at the start."""
    name = find_named_body(case.who, case.words)
    return bool(name) and float(Displacement.evaluate(case.followed.study.trace.scan, name)[:, 2].min()) >= -EVEN


def _stands(case: Case) -> bool:
    """Return whether the speed of a body at the instant asked about is zero, compared with all speeds."""
    name, trace = find_named_body(case.who, case.words), case.followed.study.trace
    speed = float(np.linalg.norm(Velocity.evaluate(trace.at(case.then), name))) if name else np.inf
    return speed <= STEADY * float(np.abs(trace.scan.v).max(initial=0.0))


def _central(case: Case) -> bool:
    """Return whether a single spring is the only force along the path of the only body."""
    mechanism = case.words.mechanism
    heavy = [body.name for body in mechanism.bodies if body.mass > 0.0]
    rubs = any(contact.friction > 0.0 for contact in mechanism.contacts.values())
    free = not (mechanism.forces or mechanism.attractions or mechanism.meetings or mechanism.burns or rubs)
    return free and len(heavy) == 1 and len(mechanism.lines) == 1 and not center_path(mechanism, heavy[0]).rises


def _swung(who: str, words: Words) -> str:
    """Return the only body with a mass, if it hangs on the swinging line that a phrase means; else an empty string."""
    heavy = [body.name for body in words.mechanism.bodies if body.mass > 0.0]
    return heavy[0] if len(heavy) == 1 and who in words.subject_phrases(SwingingLines()).values() else ""


def _across(case: Case) -> bool:
    """Return whether a body has been lower, on its path, than at the start and at present, as on a swing.

    What oscillates on a level line has been faster on its way than at both ends of it.
    """
    trace = case.followed.study.trace
    name = _swung(case.who, case.words) or find_named_body(case.who, case.words)
    if not name:
        return False
    scan = trace.scan
    depth = -Displacement.evaluate(scan, name)[:, 2][scan.times <= case.then]
    passed = depth if float(np.ptp(depth)) > EVEN else np.linalg.norm(Velocity.evaluate(scan, name), axis=1)
    return float(passed.max(initial=0.0)) > max(float(passed[0]), float(passed[len(depth) - 1])) + EVEN


def _free_axle(case: Case) -> bool:
    """Return whether a pulley is fixed, so that no string is tied to its axle."""
    mechanism = case.words.mechanism
    address = _address(case.who, case.words)
    fixed = all(site.body is None for site in mechanism.site.values() if site.name.rpartition(".")[0] == address)
    return address in Pulleys().names(mechanism) and fixed


def _mutual(case: Case) -> bool:
    """Return whether bodies can collide only with one another, and not with a wall."""
    return all(meeting.a is not None for meeting in case.words.mechanism.meetings)


def _sprung(case: Case) -> bool:
    """Return whether there are two bodies, and one spring, which runs straight from one to the other."""
    mechanism = case.words.mechanism
    heavy = {body.name for body in mechanism.bodies if body.mass > 0.0}
    ends = [{mechanism.site[site].body for site in mechanism.line[name].through} for name in Springs().names(mechanism)]
    return len(heavy) == 2 and ends == [heavy]


def _heads(axis: str, sign: float) -> Callable[[Case], bool]:
    """Return a test of whether a body moves along an axis with the given sign, for the first time."""

    def test(case: Case) -> bool:
        name = find_named_body(case.who, case.words)
        senses = Bodies().senses(case.words.mechanism, name) if name else ()
        ways = {sense.axis: np.array(sense.vector) for sense in senses}
        if not {"x", "y"} <= ways.keys():
            return False
        trace = case.followed.study.trace
        along, across = sign * ways[axis], ways["y" if axis == "x" else "x"]
        before = Velocity.evaluate(trace.scan, name)[trace.scan.times < case.then * (1.0 - STEADY)]
        turns = np.flatnonzero(np.diff(np.sign(before @ across)))
        heads = float(Velocity.evaluate(trace.at(case.then), name)[0] @ along) > 0.0
        return heads and not bool((before[turns] @ along > 0.0).any())

    return test


def _beside(axis: str, sign: float, *, farthest: bool) -> Callable[[Case], bool]:
    """Return a test of whether a body is on a given side of an axis and, if `farthest`, never farther from the axis."""

    def test(case: Case) -> bool:
        name, trace = find_named_body(case.who, case.words), case.followed.study.trace
        quantity = QUANTITIES[f"{axis} coordinate"]
        if not farthest and name in quantity.subjects(case.words.mechanism):
            return sign * float(quantity.evaluate(trace.at(case.then), name)[0]) > 0.0
        senses = Bodies().senses(case.words.mechanism, name) if name else ()
        direction = next((sign * np.array(sense.vector) for sense in senses if sense.axis == axis), None)
        if direction is None:
            return False
        here = float(Displacement.evaluate(trace.at(case.then), name)[0] @ direction)
        most = float((Displacement.evaluate(trace.scan, name) @ direction).max())
        return here > 0.0 and (not farthest or most <= here * (1.0 + STEADY))

    return test


PRESUMPTIONS: Mapping[str, tuple[str, Callable[[Case], bool]]] = {
    **MOTION_PRESUMPTIONS,
    DRAWN: ("no hand pulls {who}", _drawn),
    LIGHT: ("{who} has a weight of its own", _light),
    SIDEWAYS: ("{who} goes along one line", _sideways),
    PASSES_EQUILIBRIUM: ("the motion does not pass through an equilibrium where it is fastest", _balanced),
    ASKS_FOR_POSITION: ("that is not a matter of the place alone", _placed),
    LIFTS: ("{who} does not lift off at first", _lifts),
    GOES_UP: ("{who} is not on its way up then", _rising),
    CENTERED: ("the centre of mass of {who} is not on its axis", _centered),
    DIES_AWAY: ("{who} does not come to rest by and by", _dies_away),
    ACROSS: ("{who} is on the same side", _across),
    LIES: (
        "{who} does not lie on a face",
        lambda case: find_named_body(case.who, case.words) in case.words.mechanism.contacts,
    ),
    LOWEST: ("{who} is not lowest at first", _lowest),
    STANDS: ("{who} does not stand still then", _stands),
    CENTRAL: ("a force acts beside that of the spring", _central),
    FREE_AXLE: ("{who} is not fixed in place", _free_axle),
    SPRUNG: ("they are not joined by a spring alone", _sprung),
    MUTUAL: ("there are walls, too", _mutual),
    **{
        f"{HEADING}{sign}{axis}": ("{who} does not move that way", _heads(axis, float(f"{sign}1")))
        for axis in "xy"
        for sign in "+-"
    },
    **{
        f"{kind}{sign}{axis}": (
            "{who} is not on that side, or gets farther out later",
            _beside(axis, float(f"{sign}1"), farthest=kind == FARTHEST),
        )
        for kind in (BESIDE, FARTHEST)
        for axis in "xy"
        for sign in "+-"
    },
    GOES_DOWN: ("{who} is not on its way down then", _falling),
}
"""By the name of a presumption, the message if it fails, and its test."""
