"""Forces of springs: net forces along the only free coordinate, and the work of a varying tension."""

from collections.abc import Collection

import numpy as np

from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.functionals.aggregates import Extreme
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.query import Target
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.quantities.kinematics import Velocity
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Power, sum_formulas, sum_of_squares
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, common_monomial
from sim2reason.solutions.laws.straight_way import StraightMotion
from sim2reason.solutions.oscillations.linear_motion import LinearMotion
from sim2reason.solutions.oscillations.relative_motion import RelativeMotion
from sim2reason.solutions.setting import ProblemContext, capitalized, join_words
from sim2reason.solutions.writing.notation import JOULES
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

SEARCH_INTERVALS, LEVELS = 64, 4  # intervals of a search for a greatest value, and number of refinements


def greatest_target(setting: ProblemContext) -> Target | None:
    """Return the quantity whose greatest value is asked for; None for other questions."""
    query = setting.query
    if not isinstance(query, StretchQuery):
        return None
    functional = FUNCTIONALS[query.functional]
    return Target(functional.quantity.name, query.name, functional.sense) if isinstance(functional, Extreme) else None


def time_of_greatest(setting: ProblemContext) -> float:
    """Return the time, s, of the greatest value asked for, accurate enough to start Newton's method."""
    query, trace, low, high = setting.query, setting.study.trace, 0.0, setting.time
    assert isinstance(query, StretchQuery)
    functional, best = FUNCTIONALS[query.functional], high
    assert isinstance(functional, Extreme)
    for level in range(LEVELS):
        times = np.linspace(low, high, SEARCH_INTERVALS * (8 if level == 0 else 1) + 1)
        best = float(times[int(np.argmax(functional.height(trace.sample(times), query.name)))])
        width = 2.0 * (times[1] - times[0])
        low, high = max(0.0, best - width), min(setting.time, best + width)
    return best


def is_slow_at_greatest(setting: ProblemContext, body: str) -> bool:
    """Return whether a body is slower than half its greatest speed at the time of the greatest value."""
    times = np.append(np.linspace(0.0, setting.time, SEARCH_INTERVALS * LEVELS), time_of_greatest(setting))
    *speeds, then = np.linalg.norm(Velocity.evaluate(setting.study.trace.sample(times), body), axis=1)
    return bool(then < 0.5 * max(speeds))


HALF = Number(0.5)
UNIT_RATIO_TOLERANCE = 1e-9  # tolerance of a ratio of 1
LINEAR = frozenset({"tension", "acceleration", "net force", "spring force"})  # linear in the position


def extension(motion: LinearMotion | RelativeMotion, number: int, position: Expression) -> Expression:
    """Return the extension of a spring, m, at a value of the free coordinate."""
    strain, part = motion.laws.strain(number), motion.extension_ratio(number, motion.free[0])
    return strain.expression() + (position if part == 1.0 else -position if part == -1.0 else Number(part) * position)


def net_force(motion: LinearMotion | RelativeMotion, position: Expression) -> Expression:
    """Return the net force along the free coordinate at a value of it, with the extension of each spring."""
    (i,) = motion.free
    force = motion.steady(i).factored() if motion.steady(i) else ZERO
    for n in motion.springs:
        stretched, part = extension(motion, n, position), -motion.extension_ratio(n, i)
        if stretched.negative:
            stretched, part = -stretched, -part
        pull = motion.laws.stiffness(n).expression() * stretched
        force = force + (-pull if part == -1.0 else Number(part) * pull)
    return force


def collect_stiffness(forces: Polynomial, stiffness: Polynomial) -> Expression:
    """Return a sum of forces with the stiffness of each spring factored out."""
    return forces.collected([n for n in sorted(stiffness.names()) if len(forces.coefficient(n).terms) > 1])


def without_friction(motion: LinearMotion, *, sign: float = 1.0) -> Expression:
    """Return the net force along the free coordinate at its origin, without friction, times `sign`."""
    (i,) = motion.free
    load = (motion.load(i) - motion.friction(i)).scale(sign)
    if common_monomial([*load.terms]):
        return load.factored()
    steady = (motion.steady(i) - motion.friction(i)).scale(sign)
    force = steady.factored() if steady else ZERO
    for n in motion.springs:
        drawn = motion.extension_ratio(n, i)
        stretched, part = motion.laws.strain(n) + motion.begin.scale(drawn), -sign * drawn
        if not stretched:
            continue
        if part < 0.0:
            stretched, part = stretched.scale(-1.0), -part
        pull = motion.laws.stiffness(n).expression() * _positive_first(stretched)
        force = force + (pull if part == 1.0 else Number(part) * pull)
    return force


def _positive_first(polynomial: Polynomial) -> Expression:
    """Return a sum with the terms of positive sign first."""
    ordered = sorted(polynomial.terms.items(), key=lambda term: term[1] < 0.0)
    return Polynomial(dict(ordered)).expression()


def work(motion: LinearMotion | RelativeMotion, position: Expression, relaxed: int = -1) -> Expression:
    """Return the work of all forces along the free coordinate from the start to a position, J.

    `relaxed` is the index of a spring that has its natural length there, if one is known to have.
    """
    (i,) = motion.free
    steady = motion.steady(i)
    work_done = steady.factored() * position if steady else ZERO
    for n in motion.springs:
        stiffness, strain = motion.laws.stiffness(n).expression(), motion.laws.strain(n)
        before = Power(strain.expression(), 2) if strain else ZERO
        lost = before if n == relaxed else before - Power(extension(motion, n, position), 2)
        work_done = work_done + HALF * stiffness * lost
    return work_done


def law_words(
    mechanism: Mechanism,
    motion: LinearMotion | RelativeMotion,
    mass: Expression,
    position: Symbol,
    acceleration: Symbol,
) -> tuple[str, str]:
    """Return the sentences before the equation of motion of the free coordinate.

    The equation is the sum of Newton's second laws if all bodies move along fixed lines at equal speeds; otherwise it
    follows from the power.
    """
    rate, along = Symbol(rf"\dot{{{position.name}}}"), f"along ${position.name}$"
    if isinstance(motion, LinearMotion) and _as_one(mechanism, motion):
        direction = f"each in the direction in which its body moves while ${position.name}$ grows"
        sentence = f"When Newton's second laws of the bodies, {direction}, are added up, tensions cancel:"
        return f"Let ${acceleration.name}$ be the acceleration {along}.", sentence
    energy, growth = (HALF * mass * Power(rate, 2)).latex(), (mass * rate * acceleration).latex()
    changes = f"the kinetic energy ${energy}$ changes at the rate ${growth}$;"
    power = f"this is the power of the forces, ${rate.name}$ times the net force {along}."
    sentence = f"With the acceleration ${acceleration.name}$ {along}, {changes}"
    return sentence, f"{power} As this holds however small the velocity is,"


def _as_one(mechanism: Mechanism, motion: LinearMotion) -> bool:
    """Return whether several bodies move along fixed lines, all as fast as the free coordinate."""
    parts = {k: part for k, entries in motion.ratios.items() for part in entries.values()}
    entries = [mechanism.coordinates[k] for k in parts]
    straight = all(c.kind == "slide" and mechanism.body[c.body].parent is None for c in entries)
    return len(entries) > 1 and straight and all(abs(abs(part) - 1.0) < UNIT_RATIO_TOLERANCE for part in parts.values())


def write_extreme_end(setting: ProblemContext, book: SolutionBuilder, position: Symbol, mover: str) -> None:
    """Write why a quantity that is linear in the position is extreme at a turning point."""
    target, query = greatest_target(setting), setting.query
    if target is None or not isinstance(query, StretchQuery) or target.quantity not in LINEAR:
        return
    step, noun = book.begin_step("extreme"), target.quantity
    superlative = query.functional.partition(" ")[0]
    linear = f"is a linear function of ${position.name}$"
    step.add_text(f"The net force, and with it the acceleration, {linear}.")
    step.add_text(f"So is the {noun}." if noun not in ("acceleration", "net force") else "")
    end = f"at one end of the motion; a comparison of both shows that it is where {mover} turns back"
    step.add_text(f"The {noun} is therefore {superlative} {end}.")
    step.close()


def extensions_sentence(motion: LinearMotion | RelativeMotion, position: Expression, setting: ProblemContext) -> str:
    """Return a sentence with the extension or compression of each spring at a position; empty if all are known."""
    clauses: list[str] = []
    for n in motion.springs:
        stretched = extension(motion, n, position)
        if position == ZERO or not motion.laws.strain(n):
            continue  # the text says by how much, or the displacement does
        size, what = (-stretched, "compression") if stretched.negative else (stretched, "extension")
        clauses.append(f"the {what} of {setting.spring_phrases[setting.mechanism.lines[n].name]} is ${size.latex()}$")
    return f"{capitalized(join_words(clauses))}." if clauses else ""


def write_tension_work(motion: StraightMotion, springs: Collection[int], body: str) -> Symbol:
    """Write the work of a tension on a body and return its symbol; UnsolvedError if other forces vary.

    `springs` are the indices of all lines that are springs; their work and that of the weight are known.
    """
    (k, *others), target, goal = motion.moving([body]), motion.target, motion.goal
    if others or target is None or goal is None:
        raise UnsolvedError("the body moves along no line of its own")
    row, force_name = motion.newton.newton(k), goal.force(target, motion.setting)
    pulling = [n for n in springs if f"S{n}" in row.forces.names()]
    steady = row.forces.terms_without([force_name, *(f"S{n}" for n in pulling)])
    unknown = any(name[0] in "TNf" and name[1:].isdigit() for name in steady.names())
    if unknown or not all(_is_fixed(motion, n) for n in pulling):
        raise UnsolvedError("other forces than the tension change, too")
    found, speed, before = motion.book.fresh("W"), motion.rate("v", k), motion.first_speeds.get(k, NIL)
    gained = (row.inertia.coefficient(f"q{k}") * (speed * speed - before * before)).scale(0.5).expression()
    rest = (steady * motion.rate("s", k)).expression() + sum_formulas(_given_off(motion, n) for n in pulling)
    step, who = motion.book.begin_step("work"), motion.setting.display_name(body)
    law = step.law(found + rest, gained)
    text = f"The work of all forces on {who} is its kinetic energy: {law}, so"
    step.add_text(f"{text} {step.result(found, gained - rest, JOULES)}.")
    step.close()
    return found


def _is_fixed(motion: StraightMotion, number: int) -> bool:
    """Return whether a spring is fixed at one end."""
    return any(motion.mechanism.site[site].body is None for site in motion.mechanism.lines[number].through)


def _given_off(motion: StraightMotion, number: int) -> Expression:
    """Return the energy that a spring has given off, J."""
    line = motion.mechanism.lines[number].name
    strain, growth = motion.spring("strain", line).expression(), motion.growth("s", line).expression()
    return HALF * motion.spring("stiffness", line).expression() * (sum_of_squares([strain]) - Power(strain + growth, 2))
