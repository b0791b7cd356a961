"""The place of greatest speed in motion with one degree of freedom: where the net force is zero."""

from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.springs import NaturalLength
from sim2reason.solutions.algebra.expressions import Expression, Symbol
from sim2reason.solutions.algebra.fractions import over
from sim2reason.solutions.oscillations.linear_motion import LinearMotion
from sim2reason.solutions.oscillations.net_force import collected
from sim2reason.solutions.oscillations.single_way import SingleWay
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.writing.comparing import exceeds
from sim2reason.solutions.writing.steps import UnsolvedError
from sim2reason.solutions.writing.unit_latex import METRES

STILL = 1e-6  # relative, and m


def swings_on(setting: Setting) -> bool:
    """Return whether the motion in question goes on after it first comes to rest, by the engine."""
    return any(0.0 < held.start < setting.time * (1.0 - STILL) for held in setting.motion.segments)


def fastest_place(way: SingleWay, seen: float) -> Symbol:
    """Find where the net force is zero; UnsolvedError unless the engine has `seen` the greatest speed there."""
    motion, name = way.motion, way.name
    (i,) = motion.free
    stiffness, load = motion.stiffness(i, i), motion.load(i)
    if not stiffness:
        raise UnsolvedError("it never is in balance")
    there = load.value(motion.givens) / stiffness.value(motion.givens)
    if abs(there - seen) > 1e-3 * max(abs(there), abs(seen), STILL):
        raise UnsolvedError("the greatest value is not where forces balance")
    if not load:
        raise UnsolvedError("it begins in balance")
    step = way.book.open("balance")
    gathered = collected(load, stiffness)
    law = step.law(stiffness.expression() * name, gathered)
    if isinstance(motion, LinearMotion) and motion.friction(i) and swings_on(way.setting):
        step.say(f"Friction makes each swing smaller than the one before, so {way.mover} is fastest in the first.")
    formula = over(load, stiffness) if gathered == load.expression() else gathered / stiffness.expression()
    step.say(f"The kinetic energy is greatest where the net force is zero: {law},")
    step.say(f"so {step.result(name, formula, METRES)}.")
    step.close()
    _tell_on_the_way(way, name)
    return name


def _tell_on_the_way(way: SingleWay, name: Symbol) -> None:
    """Verify that the body passes this place before the motion in question ends."""
    book, end = way.book, _end(way)
    if end is None or book.is_hidden(end) or book.is_hidden(name):
        return
    near, far = (-held if book.value(held) < 0.0 else held for held in (name, end))
    step, last = book.open("verify"), book.fresh(name.name, r"\text{end}")
    exceeds(book, step, far, near)
    told = step.verified(last, end, METRES)
    spring = way.setting.springs[way.query.moment.name] if isinstance(way.query.moment, NaturalLength) else ""
    there = f"{spring} has its natural length, at {told}" if spring else f"${name.name} = {end.latex()}$ is reached"
    step.say(f"This point is passed before {there}.")
    step.close()


def _end(way: SingleWay) -> Expression | None:
    """Return the place at which the motion in question ends, if the question states one."""
    moment = way.query.moment
    if isinstance(moment, NaturalLength):
        return way.relaxed_place(moment.name)
    return way.moved_to(moment) if isinstance(moment, Moved) and isinstance(way.motion, LinearMotion) else None
