"""Stages of a motion with constant accelerations: durations, velocities, displacements and end conditions."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from sim2reason.simulation.engines.exact.motion import Segment
from sim2reason.solutions.algebra.expressions import (
    ZERO,
    Expression,
    Number,
    Quotient,
    Symbol,
    multiply_factors,
    ratio,
    sum_terms,
)
from sim2reason.solutions.algebra.functions import Power, Root, sum_of_squares
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, balance, total
from sim2reason.solutions.closed_forms.symbolic_answers import acceleration_over_distance
from sim2reason.solutions.laws.directions import earlier_turn_words, write_first_passage, write_later_turning
from sim2reason.solutions.laws.dynamics import RATE_RTOL, SharedRate
from sim2reason.solutions.laws.rolling_words import arc_words, constant_words, glided_words, speed_words
from sim2reason.solutions.laws.written_dynamics import WrittenDynamics
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.writing.notation import METRES, SECONDS, SPEED, subscript
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError, why_this_time


@dataclass(frozen=True, slots=True)
class End:
    """The end of a stage: at a known time, after a distance along a coordinate, at rest, or when slip ends."""

    time: Symbol | None = None
    coordinate: int = -1
    distance: Polynomial | None = None  # along the coordinate; None: the coordinate comes to rest
    what: str = ""  # in words
    slip: Mapping[int, Polynomial] = field(default_factory=dict[int, Polynomial])  # factors of slip
    turned: int | None = None  # contact at which the direction of slip reverses


HALF = Number(0.5)


@dataclass
class Stage:
    """A stage of constant accelerations, with initial velocities `speeds` and displacements `places` by coordinate."""

    setting: ProblemContext
    book: SolutionBuilder
    segment: Segment
    span: float  # duration, s, used only for signs
    end: End
    speeds: Mapping[int, Polynomial] = field(default_factory=dict[int, Polynomial])
    places: Mapping[int, Polynomial] = field(default_factory=dict[int, Polynomial])
    uniform: bool = False  # all velocities are constant

    def __post_init__(self) -> None:
        """Prepare the laws of the segment, and convert initial values to those relative to the ground."""
        self.dynamics = WrittenDynamics(self.setting, self.book, self.segment)
        self.speeds = self.dynamics.by_themselves(self.speeds)
        self.places = self.dynamics.by_themselves(self.places)
        self.written_time: Symbol | None = self.end.time
        self._velocity: dict[str, Polynomial] = {}
        self._moved: dict[str, Polynomial] = {}

    def relative(self, kind: str, k: int) -> Polynomial:
        """Return a final velocity ``v`` or displacement ``s`` relative to the carrier of the body."""
        of = {"v": self.velocity, "s": self.place}[kind]
        if k not in self.dynamics.carrier_coordinates:
            return of(k)
        j, sign = self.dynamics.carrier_coordinates[k]
        return of(k) - of(j).scale(sign)

    def reach(self, goals: Sequence[str]) -> None:
        """Write the derivation of the accelerations and forces in `goals`, such as ``q3`` or ``T1``."""
        if not self.uniform:
            self.dynamics.reach(goals)

    # ---- by coordinate

    def acceleration(self, k: int) -> Polynomial:
        """Return the acceleration along a coordinate."""
        return NIL if self.uniform else self.dynamics.names[f"q{k}"]

    def velocity(self, k: int) -> Polynomial:
        """Return the final velocity along a coordinate."""
        if self.uniform:
            return self.speeds.get(k, NIL)
        shared = self._shared(k)
        if shared is None:
            return NIL if k in self.dynamics.frozen else self.speeds.get(k, NIL)
        return self._at_end(shared).scale(float(shared.sense[k]))

    def place(self, k: int) -> Polynomial:
        """Return the displacement along a coordinate at the end, since the start of the motion, m."""
        shared, before = self._shared(k), self.places.get(k, NIL)
        if self.uniform or (shared is None and k in self.dynamics.unforced):
            return self._glided(k, before)
        if shared is None:
            if self.speeds.get(k, NIL) and k not in self.dynamics.frozen:
                raise UnsolvedError("a coordinate that keeps its speed without a law")
            return before
        return before + self._travelled(shared).scale(float(shared.sense[k]))

    def gain(self, k: int) -> Polynomial:
        """Return the displacement along a coordinate in this stage, m."""
        shared = self._shared(k)
        if self.uniform or (shared is None and k in self.dynamics.unforced):
            return self._glided(k, NIL)
        if shared is None and k == self.end.coordinate and self.end.distance is not None:
            return self.end.distance
        if shared is None and k not in self.dynamics.frozen:
            raise UnsolvedError("a coordinate whose acceleration is not found")
        return self._travelled(shared).scale(float(shared.sense[k])) if shared is not None else NIL

    def gained(self, k: int) -> Polynomial:
        """Return the displacement along a coordinate in this stage, relative to the carrier of the body, m."""
        if k not in self.dynamics.carrier_coordinates:
            return self.gain(k)
        j, sign = self.dynamics.carrier_coordinates[k]
        return self.gain(k) - self.gain(j).scale(sign)

    def path(self, k: int) -> Expression:
        """Return the distance travelled along a coordinate in this stage, with reversals, m."""
        shared = None if self.uniform else self._shared(k)
        if shared is None or (self._ends(shared) and self.end.distance is not None):  # no reversal before the end
            return self._size(self.gain(k).expression())
        begun, late = self._initial_velocity(shared), self._value(shared, moved=False)
        early = self.book.value(begun.expression())
        if not early or early * late >= -RATE_RTOL * abs(early):
            gone = self._travelled(shared).expression()
            write_later_turning(self.book, begun.factored(), shared.symbol, self.written_time)
            return self._size(gone)
        step, name = self.book.begin_step("distance"), self.book.fresh("s", subscript(shared.symbol.name))
        formula = -Quotient(Power(begun.factored(), 2), multiply_factors(Number(2.0), shared.symbol))
        where = f"at {step.result(name, formula, METRES, law=True)}"
        turned = earlier_turn_words(self.book, step, begun.factored(), shared.symbol, self.time)
        step.add_text(f"It turns back where its velocity is zero, {where}{turned}.")
        step.close()
        return sum_terms(self._size(name), self._size(self._travelled(shared).expression() - name))

    def _size(self, held: Expression) -> Expression:
        """Return the magnitude of a formula: the formula, or its negative if its value is negative."""
        return held if self.book.value(held) >= 0.0 else -held

    def _glided(self, k: int, before: Polynomial) -> Polynomial:
        """Write the displacement along a coordinate at constant velocity, m."""
        if not self.speeds.get(k, NIL):
            return before
        time, step, name = self.time, self.book.begin_step("distance"), self.book.fresh("s")
        formula = (before + self.speeds[k] * Polynomial.from_expression(time)).expression()
        step.add_text(f"{glided_words(self.dynamics, k)} {step.result(name, formula, METRES, law=True)}.")
        step.close()
        return Polynomial.from_expression(name)

    def _at_constant_velocity(self) -> Symbol:
        """Write the duration of a stage at constant velocity that ends at a distance, s."""
        k = self.end.coordinate
        if self.end.distance is None or not self.speeds.get(k, NIL):
            raise UnsolvedError("nothing ends a motion at constant velocity")
        step, name = self.book.begin_step("time"), self.book.fresh("t")
        formula = ratio(self.end.distance.expression(), self.speeds[k].expression())
        step.add_text(
            f"{constant_words(self.dynamics, k)}, which gives {step.result(name, formula, SECONDS, law=True)}."
        )
        step.close()
        return name

    def _shared(self, k: int) -> SharedRate | None:
        """Return the common rate to which the rate of a coordinate belongs; None if the laws name no such rate."""
        return next((shared for shared in self.dynamics.shared if k in shared.sense), None)

    def _initial_velocity(self, shared: SharedRate) -> Polynomial:
        """Return the initial velocity of bodies with a common rate, positive in the sense of the rate's symbol."""
        k, sense = next(iter(shared.sense.items()))
        return self.speeds.get(k, NIL).scale(float(sense))

    def _ends(self, shared: SharedRate) -> bool:
        """Return whether one of the coordinates with a common rate ends the stage."""
        return not self.end.slip and self.end.coordinate in shared.sense

    def _value(self, shared: SharedRate, *, moved: bool) -> float:
        """Return, from the engine, the final velocity, m/s, or displacement, m, of bodies with a common rate."""
        k, sense = next(iter(shared.sense.items()))
        scale = sense * self.dynamics.newton.scale[k].value
        own = self.dynamics.relative_to_ground
        v, a = scale * own(self.segment.v)[k], scale * own(self.segment.found.a)[k]
        return v * self.span + 0.5 * a * self.span**2 if moved else v + a * self.span

    # ---- written once

    @property
    def time(self) -> Symbol:
        """Return the duration of the stage, s."""
        if self.written_time is None:
            self.written_time = self._lasting()
        return self.written_time

    def _rolling(self) -> Symbol:
        """Write the time at which slip ends: Σ factor · (v + a t) = 0, summed over the coordinates that slip."""
        begun = total(part * self.speeds.get(k, NIL) for k, part in self.end.slip.items())
        gained = total(part * self.acceleration(k) for k, part in self.end.slip.items())
        step, name = self.book.begin_step("time"), self.book.fresh("t")
        law = step.law(*balance(begun + gained * Polynomial.from_expression(name)))
        swapped = -1.0 if self.book.value(gained.expression()) > 0.0 else 1.0  # makes both parts positive
        formula = ratio(begun.scale(swapped).expression(), gained.scale(-swapped).expression())
        step.add_text(f"{self.end.what} {law}, so {step.result(name, formula, SECONDS)}.")
        step.close()
        return name

    def _lasting(self) -> Symbol:
        """Write the duration of the stage."""
        if self.uniform:
            return self._at_constant_velocity()
        if self.end.slip:
            return self._rolling()
        shared = self._shared(self.end.coordinate)
        if shared is None:
            raise UnsolvedError("what ends a stage does not move")
        begun, a = self._initial_velocity(shared).factored(), shared.symbol
        step, name = self.book.begin_step("time"), self.book.fresh("t")
        if self.end.distance is None:
            law = step.law(sum_terms(begun, multiply_factors(a, name)), ZERO)
            step.add_text(f"{self.end.what} {law}, so {step.result(name, Quotient(-begun, a), SECONDS)}.")
        else:
            distance = self.end.distance.scale(float(shared.sense[self.end.coordinate])).expression()
            rate, why = self._over(shared)
            law = step.law(distance, _path(begun, rate, name))
            result = step.result(name, self._root(shared, distance), SECONDS)
            if begun != ZERO:
                why = why_this_time(self.book, step, name, self._root(shared, distance, first=False))
            step.add_text(f"{self.end.what} {law}, so {result}{why}.")
            slowed = self.book.value(begun) > 0.0 > self.book.value(a)
            if slowed and self.book.is_hidden(sum_terms(begun, a)) and self._value(shared, moved=False) > 0.0:
                who = self.setting.display_name(self.dynamics.mechanism.coordinates[self.end.coordinate].body)
                self.book.afterwards.append(lambda: write_first_passage(self.book, begun, a, name, who))
        step.close()
        return name

    def _root(self, shared: SharedRate, distance: Expression, *, first: bool = True) -> Expression:
        """Return the first positive root t of d = v t + ½ a t², or the other root."""
        begun, a = self._initial_velocity(shared).factored(), shared.symbol
        if begun == ZERO:
            return Root(Quotient(multiply_factors(Number(2.0), distance), self._over(shared)[0]))
        under = sum_terms(Power(begun, 2), multiply_factors(Number(2.0), multiply_factors(a, distance)))
        sign = 1.0 if (self._value(shared, moved=False) >= 0.0) is first else -1.0
        return Quotient(sum_terms(multiply_factors(Number(sign), Root(under)), -begun), a)

    def _over(self, shared: SharedRate) -> tuple[Expression, str]:
        """Return the acceleration for d = ½ a t², or its magnitude for motion either way, and a clause saying why."""
        bodies = [self.dynamics.mechanism.coordinates[k].body for k in shared.sense]
        begun = self._initial_velocity(shared).factored()
        return acceleration_over_distance(self.setting, self.book, begun, shared.symbol, bodies)

    def _at_end(self, shared: SharedRate) -> Polynomial:
        """Return the final velocity of bodies with a common rate, written once."""
        name = shared.symbol.name
        if name not in self._velocity:
            self._velocity[name] = self._speed(shared)
        return self._velocity[name]

    def _speed(self, shared: SharedRate) -> Polynomial:
        """Write the final velocity, m/s: v + a t, or √(v² + 2 a d) for a known distance."""
        if self._ends(shared) and self.end.distance is None and self.end.time is None:
            return NIL
        begun, a = self._initial_velocity(shared).factored(), shared.symbol
        if self._ends(shared) and self.end.distance is not None:
            return self._by_distance(shared, begun)
        time = self.time
        step, name = self.book.begin_step("velocity"), self.book.fresh("v", subscript(shared.symbol.name))
        equation = step.result(name, sum_terms(begun, multiply_factors(a, time)), SPEED, law=True)
        words = speed_words(self.dynamics, shared, begun, name)
        step.add_text(f"After the time ${time.name}$, {words}{equation}.")
        step.close()
        return Polynomial.from_expression(name)

    def _by_distance(self, shared: SharedRate, begun: Expression) -> Polynomial:
        """Write the final velocity after a known distance."""
        assert self.end.distance is not None
        distance = self.end.distance.scale(float(shared.sense[self.end.coordinate])).expression()
        step, name = self.book.begin_step("velocity"), self.book.fresh("v", subscript(shared.symbol.name))
        rate, why = self._over(shared)
        square = sum_terms(sum_of_squares([begun]), multiply_factors(Number(2.0), multiply_factors(rate, distance)))
        law = step.law(Power(name, 2), square)
        sign = 1.0 if self._value(shared, moved=False) >= 0.0 else -1.0
        step.add_text(
            f"{self.end.what} {law}, so {step.result(name, multiply_factors(Number(sign), Root(square)), SPEED)}{why}."
        )
        step.close()
        return Polynomial.from_expression(name)

    def _travelled(self, shared: SharedRate) -> Polynomial:
        """Return the displacement in this stage of bodies with a common rate, written once."""
        name = shared.symbol.name
        if name not in self._moved:
            self._moved[name] = self._distance(shared)
        return self._moved[name]

    def _distance(self, shared: SharedRate) -> Polynomial:
        """Write the displacement, m: v t + ½ a t², or v²/2a for a body that comes to rest."""
        if self._ends(shared) and self.end.distance is not None:
            return self.end.distance.scale(float(shared.sense[self.end.coordinate]))
        begun, a = self._initial_velocity(shared).factored(), shared.symbol
        if self._ends(shared) and self.end.time is None:
            step, name = self.book.begin_step("distance"), self.book.fresh("s", subscript(shared.symbol.name))
            law = step.law(sum_terms(Power(begun, 2), multiply_factors(Number(2.0), multiply_factors(a, name))), ZERO)
            formula = -Quotient(Power(begun, 2), multiply_factors(Number(2.0), a))
            step.add_text(f"{self.end.what} {law}, so {step.result(name, formula, METRES)}.")
        else:
            time = self.time
            step, name = self.book.begin_step("distance"), self.book.fresh("s", subscript(shared.symbol.name))
            equation, what = (
                step.result(name, _path(begun, a, time), METRES, law=True),
                arc_words(self.dynamics, shared),
            )
            step.add_text(f"After the time ${time.name}$, {what}{equation}.")
        step.close()
        return Polynomial.from_expression(name)


def _path(begun: Expression, a: Expression, time: Expression) -> Expression:
    """Return the displacement v t + ½ a t² at constant acceleration."""
    return sum_terms(multiply_factors(begun, time), multiply_factors(HALF, multiply_factors(a, Power(time, 2))))
