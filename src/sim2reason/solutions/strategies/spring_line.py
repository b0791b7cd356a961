"""Spring along a line: a body released from rest oscillates harmonically along its only spring."""

from collections.abc import Callable, Mapping
from math import acos, hypot, sqrt
from typing import ClassVar

from sim2reason.base.records import cached_property
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.distances import Away
from sim2reason.questions.moments.strings import MostCompressed, MostStretched, NaturalLength
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Elastic, Mechanism
from sim2reason.scenes.dsl.vectors import subtract_triples
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root, vector_length
from sim2reason.solutions.oscillations.harmonic import measured_period
from sim2reason.solutions.oscillations.net_force import greatest_target
from sim2reason.solutions.setting import DIRECTION_TOLERANCE, ProblemContext, capitalized
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.swings.angle import FormulaMethod
from sim2reason.solutions.writing.notation import (
    ANGULAR_SPEED,
    METRES,
    QUANTITY_SYMBOLS,
    RADIANS,
    SECONDS,
    magnitude_words,
)
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

PARTS = "stiffness", "length"


def single_spring_law(m: Mechanism) -> Elastic | None:
    """Return the law of the only spring, from a fixed point to the only body; None for other mechanisms."""
    other = m.faces or m.forces or m.attractions or m.burns or m.meetings or m.feet
    slides = all(c.kind == "slide" and abs(c.axis[2]) < DIRECTION_TOLERANCE for c in m.coordinates)
    if len(m.lines) != 1 or len(m.bodies) != 1 or len(m.coordinates) != 2 or other or not slides:
        return None
    law, ends = m.lines[0].law, [m.site[site].body for site in m.lines[0].through]
    plain = isinstance(law, Elastic) and not law.damping and not law.side
    return law if isinstance(law, Elastic) and plain and len(ends) == 2 and None in ends else None


def ends(m: Mechanism) -> tuple[float, float]:
    """Return the vector, m, from the fixed end of the spring to the body at the start, along the coordinates."""
    frames, through = initial_frames(m), m.lines[0].through
    fixed, free = sorted(through, key=lambda site: m.site[site].body is not None)
    separation = subtract_triples(frames.site(free).place, frames.site(fixed).place)
    x, y = (sum(a * b for a, b in zip(separation, c.axis, strict=True)) for c in m.coordinates)
    return float(x), float(y)


def length(m: Mechanism) -> float:
    """Return the length of the spring at the start, m."""
    return hypot(*ends(m))


def quantity_of(setting: ProblemContext) -> str:
    """Return the quantity that is asked for, or whose greatest value is asked for; empty for a time."""
    target = greatest_target(setting) if isinstance(setting.query, StretchQuery) else setting.query.target
    return target.quantity if target is not None else ""


class SingleSpringBody:
    """The parameters of a body on a single spring, in the symbols of the text."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder) -> None:
        """Read the parameters; raise UnreadError if one is not a simple function of the numbers in the text."""
        self.setting, self.book = setting, book
        self.apart = [self.read(lambda m, n=n: ends(m)[n]) for n in (0, 1)]
        self.stiffness, self.natural = (self.read(lambda m, of=of: getattr(m.lines[0].law, of)) for of in PARTS)
        self.mass = self.read(lambda m: m.bodies[0].mass)

    def read(self, number: Callable[[Mechanism], float]) -> Expression:
        """Return a formula for a number of the mechanism."""
        return self.setting.lexicon.formula_for(number).expression()

    @cached_property
    def length(self) -> Symbol:
        """Write the initial length of the spring, m, and return its symbol."""
        text, name = "The initial length of the spring is", self.book.fresh(r"\ell", "1")
        return self.book.add_step("length", text, name, vector_length(self.apart), METRES)

    def answer(self, way: FormulaMethod, turned: Callable[[Expression], Expression]) -> Symbol:
        """Write the answer by the method in `way` and return the answer's symbol; `turned` sets a formula's sign."""
        method, text = way
        along: Expression = getattr(self, method)()
        formula, quantity = turned(along), quantity_of(self.setting)
        if isinstance(formula, Symbol):
            return formula
        if formula == -along:
            text = magnitude_words(text, quantity)
        name = self.book.fresh(QUANTITY_SYMBOLS[quantity])
        return self.book.add_step("answer", text, name, formula, self.setting.unit)


HALF, TWO = Number(0.5), Number(2.0)
MOMENTS = (AtTime, Away, MostCompressed, MostStretched, NaturalLength, Stopped)


@strategy
class SpringLine(Strategy):
    """The strategy for a body on a level table, released from rest on a single strained spring."""

    name = "oscillation along a spring"
    cost = 1.0
    kinds = frozenset({"state", "event", "time_to_event", "extremum", "period"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that the strategy cannot apply to a mechanism; empty if it may apply."""
        rest = not any(coordinate.speed for coordinate in mechanism.coordinates)
        return "" if rest and single_spring_law(mechanism) else "no lone body is let go on a single spring"

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        query = setting.query
        if _reaches_its_end(setting):
            return "it passes through the fixed end of the spring"
        if isinstance(query, PeriodQuery):
            return ""
        if isinstance(query, StretchQuery):
            return "" if query.functional in _Oscillating.GREATEST else f"no way to the {query.functional}"
        if not isinstance(query.moment, MOMENTS):
            return f"no way to the moment {type(query.moment).__name__}"
        quantity = query.target.quantity if query.target is not None else ""
        return "" if quantity in ("", *_Oscillating.METHOD_BY_QUANTITY) else f"no way to the quantity {quantity}"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the amplitude, the angular frequency, the phase and the answer, and return the answer's symbol."""
        return _Oscillating(setting, book).write().name


def _reaches_its_end(setting: ProblemContext) -> bool:
    """Return whether the body reaches the fixed end, where the force reverses, by the moment."""
    m, query = setting.mechanism, setting.query
    law = single_spring_law(m)
    assert law is not None
    strain = length(m) - law.length
    if strain < law.length or isinstance(query.moment, NaturalLength):
        return False
    if isinstance(query, StretchQuery):
        return query.functional not in ("greatest speed", "greatest kinetic energy")
    if not isinstance(query.moment, AtTime | Away):
        return True
    return setting.time * sqrt(law.stiffness / m.bodies[0].mass) > acos(-law.length / strain)


class _Oscillating(SingleSpringBody):
    """The quantities of a body on a spring with the extension x₀ cos ωt."""

    @cached_property
    def strain(self) -> Symbol:
        """Write the initial extension, the amplitude up to a sign, and return its symbol."""
        text = "Released from rest, the extension oscillates as a cosine with the initial value"
        return self.book.add_step("strain", text, self.book.fresh("x", "0"), self.length - self.natural, METRES)

    @property
    def amplitude(self) -> Expression:
        """Return the amplitude of the oscillation, in m."""
        return self.book.magnitude(self.strain)

    @cached_property
    def rate(self) -> Symbol:
        """Write the angular frequency ω = √(k/m) and return its symbol."""
        text = "The force is proportional to the extension, so the angular frequency is"
        formula = Root(self.stiffness / self.mass)
        return self.book.add_step("oscillation", text, self.book.fresh(r"\omega"), formula, ANGULAR_SPEED)

    @cached_property
    def phase(self) -> Expression:
        """Write the phase ωt at the moment and return it."""
        moment = self.setting.query.moment
        if isinstance(moment, AtTime):
            time = self.book.fresh("t")
            self.book.state_given(time.name, moment.after, SECONDS)
            return self.book.add_step("phase", "The phase is then", self.book.fresh(r"\phi"), self.rate * time, RADIANS)
        if isinstance(moment, NaturalLength):
            return HALF * PI
        if isinstance(moment, Stopped):
            return PI
        if isinstance(moment, Away):
            name = self.book.fresh("d")
            self.book.state_given(name.name, moment.value, METRES)
            formula = Call("arccos", ONE - name / self.amplitude)
            who = capitalized(self.setting.display_name(self.setting.mechanism.bodies[0].name))
            text = f"{who} is this far from its start when the extension has changed by as much, at the phase"
            return self.book.add_step("phase", text, self.book.fresh(r"\phi"), formula, RADIANS)
        stretched = self.book.value(self.strain) > 0.0
        return TWO * PI if isinstance(moment, MostStretched) == stretched else PI

    def _trig(self, function: str) -> Expression:
        """Return the cosine or the sine of the phase, as a number at a quarter of the period."""
        plain = {HALF * PI: (ZERO, ONE), PI: (Number(-1.0), ZERO), TWO * PI: (ONE, ZERO)}.get(self.phase)
        if plain is not None:
            return plain[0] if function == "cos" else plain[1]
        return Call("cos", self.phase) if function == "cos" else Call("sin", self.phase)

    # ---- what is asked

    def write(self) -> Symbol:
        """Write the answer to the query and return the answer's symbol."""
        query = self.setting.query
        if isinstance(query, PeriodQuery):
            return self._period(query)
        if isinstance(query, StretchQuery):
            return self.answer(self.GREATEST[query.functional], lambda formula: formula)
        if query.target is None:
            formula = self.phase / self.rate
            return self.book.add_step("time", "At this phase the time is", self.book.fresh("t"), formula, SECONDS)
        return self.answer(self.METHOD_BY_QUANTITY[query.target.quantity], self._component_or_magnitude)

    def _component_or_magnitude(self, formula: Expression) -> Expression:
        """Return the component that is asked for, or the magnitude."""
        target = self.setting.query.target
        sense = target.sense if target is not None else None
        if sense is not None and any(sense.vector):
            return formula * self._along(sense.vector)
        return formula if self.book.value(formula) >= 0.0 else -formula

    def _along(self, way: tuple[float, float, float]) -> Expression:
        """Return a component of the unit vector from the fixed end to the body."""
        for number, coordinate in enumerate(self.setting.mechanism.coordinates):
            part = sum(a * b for a, b in zip(coordinate.axis, way, strict=True))
            if abs(abs(part) - 1.0) < 1e-9:
                return self.apart[number] * part / self.length
        raise UnsolvedError("a component along neither axis")

    def _period(self, query: PeriodQuery) -> Symbol:
        if query.small and query.modes > 1:
            raise UnsolvedError("there are several modes")
        return measured_period(self.book, query, self.rate)

    def _extension(self) -> Expression:
        return self.strain * self._trig("cos")

    def _current_length(self) -> Expression:
        return self.natural + self._extension()

    def _pull(self) -> Expression:
        return self.stiffness * self._extension()

    def _stored(self) -> Expression:
        return HALF * self.stiffness * Power(self._extension(), 2)

    def _speed(self) -> Expression:
        return -(self.strain * self.rate * self._trig("sin"))

    def _momentum(self) -> Expression:
        return self.mass * self._speed()

    def _kinetic(self) -> Expression:
        return HALF * self.mass * Power(self._speed(), 2)

    def _force(self) -> Expression:
        return -self._pull()

    def _acceleration(self) -> Expression:
        return self._force() / self.mass

    def _moved(self) -> Expression:
        return self.strain * (self._trig("cos") - ONE)

    def _amplitude(self) -> Expression:
        return self.amplitude

    def _fastest(self) -> Expression:
        return self.amplitude * self.rate

    def _farthest(self) -> Expression:
        return TWO * self.amplitude

    def _whole(self) -> Expression:
        return HALF * self.stiffness * Power(self.strain, 2)

    GREATEST: ClassVar[Mapping[str, FormulaMethod]] = {
        "greatest speed": ("_fastest", "It is fastest at the natural length:"),
        "greatest kinetic energy": ("_whole", "At the natural length all energy is kinetic:"),
        "greatest extension": ("_amplitude", "This is the amplitude,"),
        "greatest compression": ("_amplitude", "This is the amplitude,"),
        "greatest spring energy": ("_whole", "The energy is the same at both ends of the oscillation:"),
        "greatest displacement": ("_farthest", "The other end of the oscillation is at the distance"),
    }
    METHOD_BY_QUANTITY: ClassVar[Mapping[str, FormulaMethod]] = {
        "extension": ("_extension", "The change in its length is"),
        "spring length": ("_current_length", "The length is the natural length plus the extension,"),
        "spring force": ("_pull", "The spring force is"),
        "spring energy": ("_stored", "The elastic energy is"),
        "extension rate": ("_speed", "The extension changes at the rate"),
        "velocity": ("_speed", "The velocity is the rate of change of the extension:"),
        "momentum": ("_momentum", "The momentum is"),
        "kinetic energy": ("_kinetic", "The kinetic energy is"),
        "net force": ("_force", "The force of the spring is"),
        "acceleration": ("_acceleration", "By Newton's second law, the acceleration is"),
        "displacement": ("_moved", "The displacement is the change in the extension,"),
    }
