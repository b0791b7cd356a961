"""A harmonic oscillation about an equilibrium: its positions, speeds, times and period, written as needed."""

from dataclasses import dataclass
from math import atan2, cos, pi, sin, sqrt

from sim2reason.base.records import cached_property
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.solutions.algebra.closed_roots import fraction
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.fractions import reduced_quotient
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.oscillations.linear_motion import LinearMotion
from sim2reason.solutions.oscillations.net_force import collect_stiffness
from sim2reason.solutions.oscillations.relative_motion import RelativeMotion
from sim2reason.solutions.writing.notation import (
    ANGULAR_SPEED,
    KILOGRAMS,
    METRES,
    RADIANS,
    SECONDS,
    STIFFNESS,
    latex,
    split_name,
)
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

TWO = Number(2.0)


def measured_period(book: SolutionBuilder, query: PeriodQuery, rate: Expression, text: str = "The period is") -> Symbol:
    """Write the period, frequency or angular frequency asked for, from ω in rad/s, and return the answer's symbol."""
    if query.measure == "angular frequency" and isinstance(rate, Symbol):
        return rate
    if query.measure == "angular frequency":
        return book.add_step("period", "The angular frequency is", book.fresh(r"\omega"), rate, ANGULAR_SPEED)
    if query.measure == "frequency":
        return book.add_step("period", "The frequency is", book.fresh("f"), rate / (TWO * PI), latex("Hz"))
    return book.add_step("period", text, book.fresh("T"), TWO * PI / rate, SECONDS)


HALF = Number(0.5)
AMPLITUDE_RTOL = 1e-7  # tolerance relative to the amplitude


@dataclass
class HarmonicOscillation:
    """A harmonic oscillation x(t) = x₀ (1 − cos ωt) + (v₀/ω) sin ωt, with `name` the symbol of x."""

    book: SolutionBuilder
    motion: LinearMotion | RelativeMotion
    name: Symbol
    first: Polynomial  # v₀
    like: "HarmonicOscillation | None" = None  # an earlier one with the same mass and stiffness, already written

    @property
    def _free(self) -> int:
        return self.motion.free[0]

    # ---- in numbers

    @cached_property
    def numbers(self) -> tuple[float, float, float]:
        """Return ω in rad/s, x₀ in m and v₀ in m/s by the engine."""
        m, k = (float(self.motion.matrix(entry)[0, 0]) for entry in ("mass", "stiffness"))
        at = self.motion.givens
        if k <= 0.0:
            raise UnsolvedError("there is no restoring force")
        return sqrt(k / m), self.motion.load(self._free).value(at) / k, self.first.value(at)

    def state_at(self, time: float) -> tuple[float, float]:
        """Return the displacement, m, and the velocity, m/s, at a time in s."""
        omega, rest, fast = self.numbers
        c, s = cos(omega * time), sin(omega * time)
        return rest * (1.0 - c) + fast / omega * s, rest * omega * s + fast * c

    @property
    def amplitude_value(self) -> float:
        """Return the amplitude, m."""
        omega, rest, fast = self.numbers
        return sqrt(rest**2 + (fast / omega) ** 2)

    def is_turning_point(self, time: float) -> bool:
        """Return whether a time, s, is a turning point."""
        omega, _, _ = self.numbers
        return abs(self.state_at(time)[1]) <= AMPLITUDE_RTOL * omega * self.amplitude_value

    def instants(self, until: float) -> list[float]:
        """Return the times, s, of turning points and of passages through the equilibrium, up to the time `until`."""
        omega, rest, fast = self.numbers
        begun = atan2(fast / omega, -rest)
        times = [(begun + n * pi / 2.0) / omega for n in range(-4, int(2.0 * omega * until / pi) + 5)]
        return [time for time in times if 0.0 < time <= until * (1.0 + AMPLITUDE_RTOL)]

    # ---- in writing

    def displacement_at_phase(self, angle: Expression) -> Expression:
        """Return the formula of the displacement at a phase ωt."""
        formula: Expression = (
            self.equilibrium - self.equilibrium * Call("cos", angle) if self.equilibrium != ZERO else ZERO
        )
        if self.sine_coefficient.negative:
            return formula - (-self.sine_coefficient) * Call("sin", angle)
        return formula + self.sine_coefficient * Call("sin", angle) if self.sine_coefficient != ZERO else formula

    def displacement(self, time: Symbol) -> Expression:
        """Return the displacement at a time: x₀ + A cos(ωt − φ), or sums of cos ωt and sin ωt if these are shorter."""
        if ZERO in (self.sine_coefficient, self.equilibrium):
            return self.displacement_at_phase(self.angular_frequency * time)
        return self.equilibrium + self.amplitude * Call("cos", self.angular_frequency * time - self._first_phase)

    @cached_property
    def mass(self) -> Expression:
        """Return the effective mass of all bodies that move with the free coordinate, in kg."""
        if self.like is not None:
            return self.like.mass
        effective_mass = self.motion.mass(self._free, self._free)
        if len(effective_mass.terms) == 1:
            return effective_mass.expression()
        text = f"The kinetic energy is that of one body with the displacement ${self.name.name}$ and the effective mass"
        return self.book.add_step("inertia", text, self._fresh("M"), effective_mass.factored(), KILOGRAMS)

    @cached_property
    def stiffness(self) -> Expression:
        """Return the effective stiffness, in N/m: the decrease of the net force per unit displacement."""
        if self.like is not None:
            return self.like.stiffness
        total_stiffness = self.motion.stiffness(self._free, self._free)
        if len(total_stiffness.terms) == 1:
            return total_stiffness.expression()
        text = "Together the springs act like a single spring of stiffness"
        return self.book.add_step("stiffness", text, self._fresh("k"), total_stiffness.factored(), STIFFNESS)

    def _fresh(self, base: str) -> Symbol:
        return self.book.fresh(base, r"\text{eff}")

    @cached_property
    def angular_frequency(self) -> Symbol:
        """Return the symbol of the angular frequency ω = √(k/M), rad/s."""
        if self.like is not None:
            return self.like.angular_frequency
        formula = Root(self.stiffness / self.mass)
        whence = "the point where it is zero" if self._rubs else "equilibrium"
        text = f"The net force is proportional to the displacement from {whence}, so the angular frequency is"
        return self.book.add_step("oscillation", text, self.book.fresh(r"\omega"), formula, ANGULAR_SPEED)

    @cached_property
    def equilibrium(self) -> Expression:
        """Return the equilibrium displacement x₀, m; zero if the motion begins there."""
        load = self.motion.load(self._free)
        if not load:
            return ZERO
        base, mark = split_name(self.name.name)
        name = self.book.fresh(base, rf"\text{{eq}},{mark}" if mark.isdecimal() else "0")
        step = self.book.begin_step("balance")
        total_stiffness = self.motion.stiffness(self._free, self._free)
        gathered = collect_stiffness(load, total_stiffness)
        law = step.law(self.stiffness * name, gathered)
        what = "The net force is zero" if self._rubs else "The equilibrium is"
        step.add_text(f"{what} at ${name.name}$, where {law},")
        formula = (
            reduced_quotient(load, total_stiffness)
            if len(total_stiffness.terms) == 1
            else load.factored() / self.stiffness
        )
        formula = gathered / self.stiffness if gathered != load.expression() else formula
        step.add_text(f"so {step.result(name, formula, METRES)}.")
        step.close()
        return name

    @property
    def _rubs(self) -> bool:
        """Return whether kinetic friction acts, so that no body would stay at rest where the net force is zero."""
        return isinstance(self.motion, LinearMotion) and bool(self.motion.friction(self._free))

    @property
    def balance(self) -> str:
        """Return the phrase for the position of zero net force."""
        return "the point at which the net force is zero" if self._rubs else "the equilibrium position"

    @cached_property
    def sine_coefficient(self) -> Expression:
        """Return the coefficient v₀/ω of sin ωt in the displacement, m; zero if the motion begins at rest."""
        return self.first.expression() / self.angular_frequency if self.first else ZERO

    def speed_at(self, place: Expression) -> Expression:
        """Return the speed, m/s, at a position."""
        if place == self.equilibrium:
            return self.angular_frequency * self.amplitude
        return self.angular_frequency * Root(Power(self.amplitude, 2) - Power(place - self.equilibrium, 2))

    @cached_property
    def amplitude(self) -> Expression:
        """Return the amplitude, in m, from the position of zero net force."""
        if ZERO in (self.sine_coefficient, self.equilibrium):
            only = self.equilibrium if self.sine_coefficient == ZERO else self.sine_coefficient
            return only if self.book.value(only) >= 0.0 else -only
        formula = Root(Power(self.equilibrium, 2) + Power(self.sine_coefficient, 2))
        taken = any(name.endswith("_A") for name in self.book.values)  # A is a body
        name = self.book.fresh(*((split_name(self.name.name)[0], r"\text{max}") if taken else ("A",)))
        return self.book.add_step("amplitude", "The amplitude is", name, formula, METRES)

    def turning(self, time: float) -> Expression:
        """Return the position, m, of the turning point at a time, s."""
        beyond = self.state_at(time)[0] > self.numbers[1]
        formula = self.equilibrium + self.amplitude if beyond else self.equilibrium - self.amplitude
        collected = fraction(formula)
        return formula if collected.below else collected.above.expression()

    def angle_of_turning(self, time: float) -> Expression:
        """Return the phase ωt of the turning point at a time, s."""
        if ZERO in (self.sine_coefficient, self.equilibrium):
            formula: Expression = ZERO
            shift = 0.0 if self.sine_coefficient == ZERO else 0.5
        else:
            formula, shift = Call("arctan", self.sine_coefficient / -self.equilibrium), 0.0
        turns = round(self.numbers[0] * time / pi - shift - (self.book.value(formula) / pi))
        return formula + Number(turns + shift) * PI if turns + shift else formula

    def angle_of(self, place: Expression, time: float) -> Expression:
        """Return the phase ωt at which a position is reached near a time, s."""
        omega = self.numbers[0]
        deviation = place - self.equilibrium
        if self.equilibrium == place == ZERO:
            return Number(round(omega * time / pi)) * PI
        if self.equilibrium == ZERO:
            base: Expression = ZERO
            plain: Expression = Call("arcsin", self._share(place, self.sine_coefficient))
            options = [(plain, 0.0, 1.0), (plain, 1.0, -1.0)]
        elif self.sine_coefficient == ZERO:
            share = self._share(place, self.equilibrium)
            base, plain = ZERO, Call("arccos", ONE + -share if share.negative else ONE - share)
            options = [(plain, 0.0, 1.0), (plain, 0.0, -1.0)]
        else:
            level = abs(self.book.value(deviation)) <= AMPLITUDE_RTOL * self.amplitude_value
            plain = HALF * PI if level else Call("arccos", deviation / self.amplitude)
            base = self._first_phase
            options = [(plain, 0.0, 1.0), (plain, 0.0, -1.0)]
        start = self.book.value(base) if base != ZERO else 0.0
        best = (float("inf"), ZERO, 0.0)
        for option, shift, sign in options:
            value = start + sign * self.book.value(option) + shift * pi
            rounds = round((omega * time - value) / (2.0 * pi))
            off = abs(value + 2.0 * pi * rounds - omega * time)
            if off < best[0]:
                best = (off, option if sign > 0.0 else -option, 2.0 * rounds + shift)
        angle = base + best[1]
        return angle + Number(best[2]) * PI if best[2] else angle

    def _share(self, one: Expression, other: Expression) -> Expression:
        """Return the quotient of two formulas, with at most one minus sign."""
        sizes = [part if self.book.value(part) >= 0.0 else -part for part in (one, other)]
        quotient = sizes[0] / sizes[1]
        return quotient if self.book.value(one) * self.book.value(other) >= 0.0 else -quotient

    @cached_property
    def _first_phase(self) -> Symbol:
        """Return the symbol of the phase φ in x = x₀ + A cos(ωt − φ)."""
        formula: Expression = Call("arctan", self.sine_coefficient / -self.equilibrium)
        if self.numbers[1] > 0.0:
            formula = formula + PI
        whence = self.balance if self._rubs else "equilibrium"
        text = f"The displacement from {whence} is ${self.amplitude.latex()} \\cos(\\omega t - \\varphi)$ with"
        return self.book.add_step("phase", text, self.book.fresh(r"\varphi"), formula, RADIANS)
