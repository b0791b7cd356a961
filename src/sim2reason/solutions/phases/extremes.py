"""Extreme values and accumulated quantities within phases, and the text of phases integrated numerically."""

from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import reduce
from math import radians

import numpy as np

from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.functionals.aggregates import Extreme
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments import Happening
from sim2reason.scenes.dsl.mechanism import Elastic
from sim2reason.simulation.engines.exact.motion import Motion, Segment
from sim2reason.simulation.trace import Event, Trace
from sim2reason.solutions.algebra.expressions import Expression, Number, Sum, Symbol, multiply_factors, sum_terms
from sim2reason.solutions.algebra.functions import Absolute, Power, Root
from sim2reason.solutions.algebra.polynomials import Polynomial, total
from sim2reason.solutions.algebra.rounded_numbers import DIGITS
from sim2reason.solutions.goals import Components
from sim2reason.solutions.phases.conditions import vector_magnitude
from sim2reason.solutions.phases.equations import PhaseEquations
from sim2reason.solutions.setting import ProblemContext, join_words
from sim2reason.solutions.solution import Integration, with_unit
from sim2reason.solutions.writing.steps import STATE_DIGITS, SolutionBuilder, StepBuilder, UnsolvedError

HALF = Number(0.5)


def value_of(functional: str, name: str, trace: Trace, end: float) -> float:
    """Return the value of a functional from the start to a time (s) in the motion of the engine.

    Raises:
        UnsolvedError: the functional has no value.
    """
    value = FUNCTIONALS[functional].value(trace, name, end)
    if value is None:
        raise UnsolvedError(f"the motion has no {functional}")
    return radians(value) if FUNCTIONALS[functional].unit == "deg" else value


def rate_of(functional: str, name: str, equations: PhaseEquations) -> Expression:
    """Return the rate at which a functional of a subject grows during a phase.

    Raises:
        UnsolvedError: no rate is known for the functional.
    """
    rate = ACCUMULATION_RATES.get(functional)
    if rate is None:
        raise UnsolvedError(f"no rate is known for {functional}")
    return rate(equations, name)


def _path(equations: PhaseEquations, name: str) -> Expression:
    return vector_magnitude(equations.kinematic_vector("velocity", name))


def _tension(equations: PhaseEquations, name: str) -> Expression:
    rows = [row for row in equations.rows if equations.kind(row).name == name]
    if rows:
        return equations.force("row", rows[0]).expression()
    return Number(0.0)


def _dashpot(equations: PhaseEquations, name: str) -> Expression:
    law = equations.mechanism.line[name].law
    assert isinstance(law, Elastic)
    rate = equations.length(name, "rate").expression()
    return multiply_factors(equations.law(name, "damping").expression(), Power(rate, 2))


def _friction(equations: PhaseEquations, name: str) -> Expression:
    face = equations.mechanism.face_number[name]
    if not equations.rough.get(face, 0):
        return Number(0.0)
    force = equations.kinetic_friction(face).expression()
    return multiply_factors(force, Absolute(equations.slip(face).expression()))


def _angle(equations: PhaseEquations, name: str) -> Expression:
    return Absolute(equations.names.rates[equations.hinge(name)])


ACCUMULATION_RATES: Mapping[str, Callable[[PhaseEquations, str], Expression]] = {
    "distance travelled": _path,
    "impulse of a tension": _tension,
    "energy dissipated by a dashpot": _dashpot,
    "energy dissipated by friction": _friction,
    "total angle": _angle,
}


EXTREME_SAMPLES = 4000  # instants at which the quantity is evaluated
BISECTION_STEPS = 60  # bisections of an interval with the zero of a rate


def extreme_time(motion: Motion, functional: str, name: str, end: float) -> float:
    """Return the approximate time, s, of an extreme functional's value in the motion up to `end`."""
    definition = FUNCTIONALS[functional]
    if not isinstance(definition, Extreme):
        raise UnsolvedError(f"{functional} is no greatest or least value")
    times = np.linspace(0.0, end, EXTREME_SAMPLES + 1)[1:-1]
    return float(times[int(np.argmax(definition.height(motion.state(times), name)))])


def quantity_of(functional: str) -> str:
    """Return the quantity whose extreme value a functional is; empty if it is none."""
    definition = FUNCTIONALS[functional]
    return definition.quantity.name if isinstance(definition, Extreme) else ""


def rate_formulas(equations: PhaseEquations, functional: str, name: str) -> list[Expression]:
    """Return formulas that vanish at the instant of a functional's extreme value, the simplest first.

    Raises:
        UnsolvedError: no formula is known for its quantity.
    """
    quantity = "height" if functional == "greatest height" else quantity_of(functional)
    if quantity not in EXTREME_RATES:
        raise UnsolvedError(f"no rate is known for the quantity {quantity}")
    return EXTREME_RATES[quantity](equations, name)


def refine_zero(equations: PhaseEquations, formula: Expression, near: float, width: float) -> float:
    """Return the zero of a formula near an instant, s, in the motion of the engine.

    Raises:
        UnsolvedError: the formula does not change its sign there.
    """

    def at(time: float) -> float:
        known = {key: float(value[0]) for key, value in equations.sampled(np.array([time])).items()}
        return float(formula.value(known).real)

    low, high = near - width, near + width
    below, above = at(low), at(high)
    if not below * above < 0.0:
        raise UnsolvedError("the extreme value is no zero of the rate")
    for _ in range(BISECTION_STEPS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if at(middle) * below > 0.0 else (low, middle)
    return 0.5 * (low + high)


def _inner(one: Components, other: Components) -> Polynomial:
    return total(a * b for a, b in zip(one, other, strict=True))


def _speed(equations: PhaseEquations, name: str) -> list[Expression]:
    velocity, acceleration = equations.kinematic_vector("velocity", name), equations.acceleration(name)
    moving = [(v, a) for v, a in zip(velocity, acceleration, strict=True) if v or a]
    simple = [moving[0][1].factored()] if len(moving) == 1 else []
    return [*simple, _inner(velocity, acceleration).expression()]


def _displacement(equations: PhaseEquations, name: str) -> list[Expression]:
    displacement, velocity = equations.displacement(name), equations.kinematic_vector("velocity", name)
    moving = [v for v in velocity if v]
    simple = [moving[0].factored()] if len(moving) == 1 else []
    return [*simple, _inner(displacement, velocity).expression()]


def _height(equations: PhaseEquations, name: str) -> list[Expression]:
    return [equations.kinematic_vector("velocity", name)[2].factored()]


def _extension(equations: PhaseEquations, name: str) -> list[Expression]:
    return [equations.length(name, "rate").expression()]


def _hinge(equations: PhaseEquations, name: str, symbols: str) -> list[Expression]:
    return [getattr(equations.names, symbols)[equations.hinge(name)]]


EXTREME_RATES: Mapping[str, Callable[[PhaseEquations, str], list[Expression]]] = {
    "velocity": _speed,
    "kinetic energy": _speed,
    "displacement": _displacement,
    "height": _height,
    "extension": _extension,
    "spring energy": _extension,
    "angular velocity": lambda equations, name: _hinge(equations, name, "accelerations"),
}


MAX_EQUATION_LENGTH = 900  # maximum length of the LaTeX of an equation that is written out
ORDINALS = ("", "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth")


def write_problem(
    book: SolutionBuilder, step: StepBuilder, integration: Integration, *, first: bool, letter: str
) -> None:
    """Write the equations and initial values of a phase; repeated square roots get symbols of their own."""
    sides = [side for law in integration.equations for side in (law.left, law.right)]
    count = Counter(root for side in sides for root in _roots(side))
    named = {root: book.fresh(letter) for root, times in count.items() if times > 1}
    laws = [f"${_with(law.left, named).latex()} = {_with(law.right, named).latex()}$" for law in integration.equations]
    if any(len(law) > MAX_EQUATION_LENGTH for law in laws):
        raise UnsolvedError("the equations of motion are too long to be written")
    where = [f"${name.name} = {root.latex()}$" for root, name in named.items()]
    equations = "equations of motion are" if len(laws) > 1 else "equation of motion is"
    step.add_text(f"The {equations} {join_words(laws)}{f', where {join_words(where)}' if where else ''}.")
    begun = [f"${c.place} = {c.initial_place.latex()}$" for c in integration.coordinates]
    begun += [f"${c.rate} = {c.initial_rate.latex()}$" for c in integration.coordinates]
    step.add_text(f"{'Initially' if first else 'The phase begins with'} {join_words(begun)}.")
    if integration.accumulated:
        (integral,) = integration.accumulated
        rate, begun = integral.rate.latex(), integral.initial.latex()
        step.add_text(rf"Along with them, $\dot{{{integral.name}}} = {rate}$ from ${begun}$ is integrated.")


def end_sentence(book: SolutionBuilder, integration: Integration, end_phrase: str, used: frozenset[str]) -> str:
    """Return the sentence about the end of a phase, with the values that later steps use."""
    condition = integration.until
    kept = [name for _, name in integration.ends if name in used]
    begins = {name for step in book.steps if step.integration is not None for name in step.integration.symbols()}
    digits = {name: STATE_DIGITS if name in begins else DIGITS for name in kept}
    values = [f"${name} = {with_unit(book.values[name], book.units[name], digits[name])}$" for name in kept]
    if not values:
        raise UnsolvedError("nothing rests on the state to which the motion is integrated")
    later = 1 < condition.occurrence < len(ORDINALS)
    which = f" for the {ORDINALS[condition.occurrence]} time" if later else ""
    when = (
        f"{end_phrase}, that is, until {_equation(condition.expression)}"
        if end_phrase
        else _equation(condition.expression)
    )
    first = " for the first time" if not end_phrase and condition.occurrence == 1 and not condition.direction else ""
    return f"Numerical integration until {when}{which or first}{',' if end_phrase else ''} gives {join_words(values)}."


def _equation(formula: Expression) -> str:
    """Return the equation that a formula is zero, in LaTeX; a symbol that is subtracted becomes the right side."""
    if isinstance(formula, Sum) and isinstance(last := -formula.terms[-1], Symbol):
        return f"${reduce(sum_terms, formula.terms[:-1]).latex()} = {last.name}$"
    return f"${formula.latex()} = 0$"


def _roots(formula: Expression) -> Iterator[Root]:
    if isinstance(formula, Root):
        yield formula
    for part in formula.parts:
        yield from _roots(part)


def _with(formula: Expression, named: dict[Root, Symbol]) -> Expression:
    """Return a formula with symbols in place of roots."""
    if isinstance(formula, Root) and formula in named:
        return named[formula]
    return formula.built_of([_with(part, named) for part in formula.parts]) if formula.parts else formula


MAX_PHASES = 8  # largest number of phases of a solution that is still readable
EVENT_TIME_RTOL = 1e-9  # relative tolerance of the time of an event at the moment of the question


@dataclass(frozen=True, slots=True)
class PhaseInterval:
    """A segment of the motion with its end time, s, and the events that end it."""

    segment: Segment
    ends: float
    events: tuple[Event, ...]


def asked_time(setting: ProblemContext) -> float:
    """Return the time, s, of the moment that decides the answer; approximate for an extreme value."""
    query = setting.query
    if query.kind == "extremum" and isinstance(query, StretchQuery):
        return extreme_time(setting.motion, query.functional, query.name, setting.time)
    return query.moment.evaluation_time(setting.time) if query.moment is not None else setting.time


def phase_intervals(setting: ProblemContext, time: float) -> list[PhaseInterval]:
    """Return the phases of the motion up to a time, s, each with its end time and events.

    Raises:
        UnsolvedError: there is none, there are too many, or one ends without an event.
    """
    motion, moment = setting.motion, setting.query.moment
    segments = [s for s in motion.segments if s.start < time or s.start == 0.0]
    ends_at_event = moment is not None and moment.event and setting.query.kind != "extremum"
    intervals: list[PhaseInterval] = []
    for segment, following in zip(segments, [*segments[1:], None], strict=True):
        ends = following.start if following is not None else time
        near = EVENT_TIME_RTOL * max(ends, EVENT_TIME_RTOL)
        events = tuple(e for e in motion.events if e.changes_motion and abs(e.time - ends) <= near)
        if following is None and not ends_at_event:
            events = ()
        if following is not None and not events:
            raise UnsolvedError("the equations change where no event is recorded")
        intervals.append(PhaseInterval(segment, ends, events))
    if not intervals or len(intervals) > MAX_PHASES:
        raise UnsolvedError(f"the motion has {len(intervals)} phases")
    return intervals


def moment_words(setting: ProblemContext) -> str:
    """Return the event at the moment of the question as a statement; empty if the moment is no event."""
    moment = setting.query.moment
    if setting.query.kind == "extremum" or not isinstance(moment, Happening):
        return ""
    clause = moment.clause(setting.words)
    return clause.statement if clause is not None else ""
