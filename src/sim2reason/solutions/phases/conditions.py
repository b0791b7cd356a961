"""Conditions that end a phase: an event of the motion, or the moment of the question, as the zero of a formula."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from sim2reason.questions import Moment
from sim2reason.questions.moments.angles import Deflected, TurnedThrough
from sim2reason.questions.moments.distances import Away, Closest, Farthest, Moved
from sim2reason.questions.moments.strings import MostCompressed, MostStretched, NaturalLength
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.moments.turning_points import HighestPoint, LowestPoint, Stopped
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.vectors import Number as Quantity
from sim2reason.simulation.engines.exact.assembly import Assembly
from sim2reason.simulation.quantities.subjects.interactions import members
from sim2reason.simulation.trace import Event
from sim2reason.solutions.algebra.expressions import Expression, Symbol
from sim2reason.solutions.algebra.functions import Absolute, Call, Root, array_values, sum_of_squares
from sim2reason.solutions.algebra.polynomials import Polynomial, total
from sim2reason.solutions.phases.coordinates import DEFLECTION
from sim2reason.solutions.phases.equations import PhaseEquations
from sim2reason.solutions.setting import join_words
from sim2reason.solutions.solution import Condition
from sim2reason.solutions.writing.lexicon import DualValue
from sim2reason.solutions.writing.notation import DEGREES, METRES, SECONDS
from sim2reason.solutions.writing.steps import UnsolvedError

CONDITION_SAMPLES = 2000  # instants of a phase at which a condition is evaluated
ZERO_TOLERANCE = 1e-12  # in SI units: tolerance of zero
ZERO_RTOL = 1e-6  # tolerance at the end of a phase, relative to the largest value of a condition
EDGE_FRACTION = 1e-4  # fraction of a phase at both ends in which sign changes are ignored

# ---- events of the engine


def event_condition(equations: PhaseEquations, event: Event) -> tuple[Expression, str]:
    """Return the formula whose zero is an event that ends a phase, and the event in words.

    Raises:
        UnsolvedError: no formula is known for this kind of event.
    """
    condition = EVENTS.get(event.kind)
    if condition is None:
        raise UnsolvedError(f"no condition is known for the event {event.kind}")
    return condition(equations, event)


def _collision(equations: PhaseEquations, event: Event) -> tuple[Expression, str]:
    m = equations.mechanism
    number = next(n for n, meeting in enumerate(m.meetings) if set(meeting.names) == set(event.subjects))
    gap = equations.motion.read_recorded(lambda a: a.separation(a.mechanism.meetings[number]).gap)
    called = [equations.setting.display_name(name) for name in event.subjects]
    return gap.expression(), f"{join_words(called)} collide" if len(called) > 1 else f"{called[0]} hits the surface"


def _row(kind: str, phrase: str, *, force: bool) -> Callable[[PhaseEquations, Event], tuple[Expression, str]]:
    def condition(equations: PhaseEquations, event: Event) -> tuple[Expression, str]:
        row = next(
            n
            for n, candidate in enumerate(equations.segment.kinds)
            if candidate.name == event.subjects[0] and candidate.kind in kind
        )
        line = equations.setting.string_phrases.get(
            event.subjects[0], equations.setting.display_name(event.subjects[0])
        )
        if force:
            return equations.force("row", row).expression(), f"{line} {phrase}"
        return _spare(equations, row).expression(), f"{line} {phrase}"

    return condition


def _spare(equations: PhaseEquations, row: int) -> Polynomial:
    """Return the slack of a string, m: its initial length minus its current length."""
    mechanisms = equations.lexicon.mechanism, equations.lexicon.twin
    starts = [{line.name: _length_at_start(m, line.name) for line in m.constraints} for m in mechanisms]
    here, there = (a.rows(begun)[row].value for a, begun in zip(equations.motion.assemblies, starts, strict=True))
    return equations.motion.read(here, there)


def _length_at_start(m: object, line: str) -> float:
    frames = initial_frames(m)  # type: ignore[arg-type]
    return float(sum((run.value for run in frames.pieces(m.line[line])), 0.0))  # type: ignore[attr-defined,arg-type]


def _stick(equations: PhaseEquations, event: Event) -> tuple[Expression, str]:
    face = equations.mechanism.face_number[event.subjects[0]]
    return equations.slip(face).expression(), f"{equations.setting.display_name(event.subjects[0])} stops sliding"


def _slip(equations: PhaseEquations, event: Event) -> tuple[Expression, str]:
    face, who = equations.mechanism.face_number[event.subjects[0]], equations.setting.display_name(event.subjects[0])
    if equations.rough.get(face, 0):
        return equations.slip(face).expression(), f"{who} reverses its sliding"
    friction = Absolute(equations.force("friction", face).expression())
    return friction - equations.friction_bound(face).expression(), f"{who} begins to slide"


def _border(phrase: str) -> Callable[[PhaseEquations, Event], tuple[Expression, str]]:
    def condition(equations: PhaseEquations, event: Event) -> tuple[Expression, str]:
        body = event.subjects[0]
        sizes: list[tuple[float, Polynomial]] = []
        for number, force in enumerate(equations.mechanism.forces):
            if force.body != body or force.region is None:
                continue
            for index in range(len(_margins(equations.motion.assemblies[0], number))):
                margin = equations.motion.read_recorded(lambda a, n=number, p=index: _margins(a, n)[p])
                sizes.append((abs(equations.book.value(margin.expression())), margin))
        return min(sizes, key=lambda each: each[0])[
            1
        ].expression(), f"{equations.setting.display_name(body)} {phrase} the field"

    return condition


def _margins(assembly: Assembly, number: int) -> tuple[Quantity, ...]:
    force = assembly.mechanism.forces[number]
    assert force.region is not None
    return force.region.margins(assembly.frames.center(force.body).place, assembly.maths)


def _burnt(equations: PhaseEquations, event: Event) -> tuple[Expression, str]:
    del event
    here, there = equations.lexicon.mechanism.burns[0], equations.lexicon.twin.burns[0]
    rate = equations.motion.number(DualValue(here.rate, there.rate))
    fuel = equations.motion.number(DualValue(here.rate * here.until, there.rate * there.until))
    return (rate * Polynomial.from_expression(equations.names.time) - fuel).expression(), "the fuel is used up"


EVENTS: Mapping[str, Callable[[PhaseEquations, Event], tuple[Expression, str]]] = {
    "collision": _collision,
    "slack": _row("string", "goes slack", force=True),
    "taut": _row("string", "becomes taut", force=False),
    "stick": _stick,
    "slip": _slip,
    "enter": _border("enters"),
    "exit": _border("leaves"),
    "burn-out": _burnt,
}

# ---- moments of questions


def moment_conditions(equations: PhaseEquations, moment: Moment | None) -> list[Expression]:
    """Return formulas that vanish at the moment of a question, the simplest first, and record its numbers as given.

    Raises:
        UnsolvedError: no formula is known for this moment.
    """
    for cls, condition in MOMENTS.items():
        if type(moment) is cls:
            formulas = condition(equations, moment)
            return formulas if isinstance(formulas, list) else [formulas]
    raise UnsolvedError(f"no condition is known for the moment {type(moment).__name__}")


def _at_time(equations: PhaseEquations, moment: AtTime) -> Expression:
    name = given_symbol(equations, "t", moment.after, SECONDS)
    return equations.names.time - name


def _distance(equations: PhaseEquations, moment: Moved | Away) -> Expression:
    name = given_symbol(equations, "d", moment.value, METRES)
    return vector_magnitude(equations.displacement(moment.name)) - name


def _still(equations: PhaseEquations, moment: Stopped) -> list[Expression]:
    velocity = equations.kinematic_vector("velocity", moment.name)
    moving = [rate for rate in equations.names.rates if any(rate.name in part.names() for part in velocity)]
    return [*(moving if len(moving) == 1 else []), signed_magnitude(velocity)]


def _vertical(equations: PhaseEquations, moment: HighestPoint | LowestPoint) -> list[Expression]:
    """Return formulas that may vanish at a highest or lowest point: angle or rate of rotation, vertical velocity."""
    names = equations.names
    velocity = equations.kinematic_vector("velocity", moment.name)[2]
    turning = [k for k, rate in enumerate(names.rates) if rate.name in velocity.names()]
    simple: list[Expression] = []
    if len(turning) == 1 and equations.mechanism.coordinates[turning[0]].kind == "hinge":
        angle = names.places[turning[0]]
        simple = [angle, *([Call("sin", angle)] if angle.name.startswith(DEFLECTION) else []), names.rates[turning[0]]]
    return [*simple, velocity.factored()]


def _apsis(equations: PhaseEquations, moment: Closest | Farthest) -> Expression:
    one, other = members(moment.name)
    separation = [
        b - a
        for a, b in zip(
            equations.kinematic_vector("place", one), equations.kinematic_vector("place", other), strict=True
        )
    ]
    parting = [
        b - a
        for a, b in zip(
            equations.kinematic_vector("velocity", one), equations.kinematic_vector("velocity", other), strict=True
        )
    ]
    return total(r * v for r, v in zip(separation, parting, strict=True)).expression()


def _spring_rate(equations: PhaseEquations, moment: MostStretched | MostCompressed) -> Expression:
    return equations.length(moment.name, "rate").expression()


def _natural(equations: PhaseEquations, moment: NaturalLength) -> Expression:
    return (equations.length(moment.name) - equations.law(moment.name, "length")).expression()


def _turned_condition(equations: PhaseEquations, moment: TurnedThrough) -> Expression:
    name = given_symbol(equations, r"\beta", np.radians(moment.value), DEGREES)
    return Absolute(equations.names.place(equations.hinge(moment.name)).expression()) - name


def _deflected(equations: PhaseEquations, moment: Deflected) -> Expression:
    name = given_symbol(equations, r"\beta", np.radians(moment.value), DEGREES)
    hinges = [k for k, c in enumerate(equations.mechanism.coordinates) if c.kind == "hinge"]
    if len(hinges) != 1 or not equations.names.places[hinges[0]].name.startswith(DEFLECTION):
        raise UnsolvedError("its deflection is no coordinate")
    return Absolute(equations.names.places[hinges[0]]) - name


MOMENTS: Mapping[type[Moment], Callable[..., Expression | list[Expression]]] = {
    AtTime: _at_time,
    Moved: _distance,
    Away: _distance,
    Stopped: _still,
    HighestPoint: _vertical,
    LowestPoint: _vertical,
    Closest: _apsis,
    Farthest: _apsis,
    MostStretched: _spring_rate,
    MostCompressed: _spring_rate,
    NaturalLength: _natural,
    TurnedThrough: _turned_condition,
    Deflected: _deflected,
}


def given_symbol(equations: PhaseEquations, base: str, value: float, unit: str) -> Symbol:
    """Return the symbol of a number that the question itself states, with its value recorded."""
    name = equations.book.fresh(base)
    equations.book.set_value(name.name, value, unit)
    equations.stated.append((name.name, value, unit))
    return name


def signed_magnitude(parts: tuple[Polynomial, ...]) -> Expression:
    """Return the only nonzero component of a vector, with its sign; else the magnitude of the vector."""
    kept = [part for part in parts if part]
    return kept[0].factored() if len(kept) == 1 else vector_magnitude(parts)


def vector_magnitude(parts: tuple[Polynomial, ...]) -> Expression:
    """Return the magnitude of a vector."""
    kept = [part for part in parts if part]
    if len(kept) == 1:
        return Absolute(kept[0].factored())
    return Root(sum_of_squares(part.expression() for part in kept))


# ---- which of its zeros


def locate_condition(equations: PhaseEquations, formulas: Sequence[Expression], begin: float, end: float) -> Condition:
    """Return the first formula that vanishes at the end of a phase, with the direction and number of its sign change.

    Raises:
        UnsolvedError: none of the formulas has a zero there in the motion of the engine.
    """
    inner = np.linspace(begin, end, CONDITION_SAMPLES + 1)[1:-1]
    times = np.append(inner, begin + (1.0 - 1e-9) * (end - begin))
    known = equations.sampled(times)
    for formula in formulas:
        values = array_values(formula, known)
        last, before = float(values[-1]), values[:-1]
        if np.isfinite(values).all() and abs(last) <= max(ZERO_RTOL * float(np.abs(before).max()), ZERO_TOLERANCE):
            rises = 1 if before[-1] < 0.0 else -1
            edge = max(2, int(EDGE_FRACTION * CONDITION_SAMPLES))
            signs = np.sign(before[edge:-edge])
            changes = np.flatnonzero(np.diff(signs) != 0)
            return Condition(formula, rises, 1 + sum(1 for n in changes if signs[n + 1] == rises))
    raise UnsolvedError("the moment is no zero of a formula that is known for it")
