"""Motion of a rocket that burns its fuel: thrust, mass, gravity, lift-off and burnout, with checks."""

from collections.abc import Callable

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Attraction, MassEjection, Mechanism
from sim2reason.scenes.dsl.vectors import Vector
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol, ratio
from sim2reason.solutions.algebra.functions import Call, Power
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.laws.newton import Newton
from sim2reason.solutions.laws.straight_way import StraightMotion
from sim2reason.solutions.setting import capitalized
from sim2reason.solutions.writing.notation import KILOGRAMS, METRES, NEWTONS, SECONDS
from sim2reason.solutions.writing.steps import StepBuilder, UnsolvedError, record_inequality, verify_assumed

HALF = Number(0.5)


class Burning(StraightMotion):
    """The quantities of a rocket, and the times of lift-off and burnout, written as they are needed."""

    @property
    def newton(self) -> Newton:
        """Raise UnsolvedError: a rocket has no law of constant mass."""
        raise UnsolvedError("a rocket has no law of constant mass")

    def force(self, kind: str, name: str) -> Symbol:
        """Raise UnsolvedError: a rocket has no tension, normal force or friction."""
        raise UnsolvedError(f"no {kind} of {name}")

    # ---- numbers

    def _read(self, number: Callable[[Mechanism], float]) -> Polynomial:
        """Return a number of the mechanism in the symbols of the text."""
        return self.setting.lexicon.formula_for(number)

    @property
    def burn(self) -> MassEjection:
        """Return the rocket's engine."""
        return self.setting.lexicon.mechanism.burns[0]

    @cached_property
    def rate_of_burning(self) -> Expression:
        """Return µ, the burning rate, kg/s."""
        return self._read(lambda m: m.burns[0].rate).expression()

    @cached_property
    def exhaust(self) -> Expression:
        """Return u, the exhaust velocity, m/s."""
        return self._read(lambda m: m.burns[0].exhaust).expression()

    @cached_property
    def initial_mass(self) -> Expression:
        """Return the initial mass with all fuel, kg."""
        return self._read(lambda m: m.body[m.burns[0].body].mass).expression()

    @cached_property
    def dry_mass(self) -> Expression:
        """Return the mass without fuel, kg."""
        return self._read(lambda m: m.body[m.burns[0].body].mass - m.burns[0].rate * m.burns[0].until).expression()

    @property
    def gravity(self) -> Polynomial:
        """Return the gravitational acceleration at the ground, or at the surface of a planet."""
        return self._read(_pull)

    # ---- the moment

    @property
    def waits_on_ground(self) -> bool:
        """Return whether the rocket stays on the ground until it is light enough."""
        return self.setting.motion.segments[0].a[0] <= 0.0

    @property
    def is_burned_out(self) -> bool:
        """Return whether the engine is off at the moment of the question."""
        return self.setting.time > self.burn.until * (1.0 + 1e-9) or isinstance(self.query, StretchQuery)

    @cached_property
    def lift_off_mass(self) -> Expression:
        """Write the mass at lift-off with the reason, and return it."""
        if not self.waits_on_ground:
            self._write_rising()
            return self.initial_mass
        formula = self.rate_of_burning * self.exhaust / self.gravity.expression()
        step, name = self.book.begin_step("wait"), self.book.fresh("m", r"\text{lift}")
        equal = step.result(name, formula, KILOGRAMS, law=True)
        step.add_text(f"The thrust equals the weight of {self.name} at the mass {equal}.")
        step.add_text(f"{self._heavier(step, name)} the thrust is less than the weight at first,")
        step.add_text(f"and {self.name} stays on the ground until its mass has fallen to this value.")
        step.close()
        return name

    def _heavier(self, step: StepBuilder, lift: Symbol) -> str:
        """Return a clause that the thrust is at first too small: as shown, assumed, or to be verified at the end."""
        larger = f"{self.initial_mass.latex()} > {lift.latex()}"
        if self.book.in_symbols:
            return f"By assumption ${larger}$, so"
        if self.book.is_hidden(self.initial_mass - lift):
            self.book.afterwards.append(lambda: verify_assumed(self.book, self.initial_mass, lift, larger))
            return f"Assume that ${larger}$; then"
        record_inequality(self.book, step, self.initial_mass, lift)
        return f"As ${larger}$,"

    def exclude_rising(self, time: Symbol, longest: Expression) -> None:
        """Write that a rocket that rose from the start would come to rest before the given time."""
        step = self.book.begin_step("verify")
        record_inequality(self.book, step, time, longest)
        equation = self._observed(step, r"\text{max}", longest)
        full, lift = self.initial_mass.latex(), self.lift_off_mass.latex()
        step.add_text(f"If {self.name} rose from the start, ${full}$ would be at most ${lift}$,")
        step.add_text(
            f"and {self.name} would come to rest at the latest after {equation}, which is before the given time."
        )
        step.close()

    def _risen(self, time: Expression) -> Expression:
        """Return how long the rocket has risen at a given time."""
        return time - self._wait if self.waits_on_ground else time

    @cached_property
    def _wait(self) -> Symbol:
        """Return the time until lift-off."""
        text = f"The mass of {self.name} has fallen to this value after"
        formula = self.initial_mass - self.lift_off_mass
        name = self.book.fresh("t", r"\text{lift}")
        return self.book.add_step("wait", text, name, formula / self.rate_of_burning, SECONDS)

    @cached_property
    def ascent_duration(self) -> Symbol:
        """Return the duration of the ascent with the engine on."""
        if not self.waits_on_ground:
            return self.burned
        formula = (self.lift_off_mass - self.dry_mass) / self.rate_of_burning
        text = "From lift-off on, the fuel lasts for"
        return self.book.add_step("time", text, self.book.fresh("t", r"\text{up}"), formula, SECONDS)

    @cached_property
    def burned(self) -> Symbol:
        """Return the time of burnout, when no fuel is left."""
        formula = (self.initial_mass - self.dry_mass) / self.rate_of_burning
        base = self.book.fresh("t", r"\text{out}") if self.is_burned_out else self.book.fresh("t")
        return self.book.add_step("time", "The fuel lasts for", base, formula, SECONDS)

    @property
    def rocket_equation(self) -> str:
        """Return the words for the velocity law while the engine is on."""
        return "By the rocket equation, with gravity" if self.gravity else "By the rocket equation"

    @cached_property
    def time_since_lift_off(self) -> Symbol:
        """Return the symbol of the time since lift-off as a variable."""
        return self.book.fresh(r"\tau")

    @property
    def course(self) -> str:
        """Return a clause with the velocity as a function of the time since lift-off."""
        since = "lift-off" if self.waits_on_ground else "the start"
        text = f"{self.rocket_equation}, the velocity of {self.name} with the engine on is ${self._velocity.latex()}$"
        return f"{text} at the time ${self.time_since_lift_off.latex()}$ after {since}"

    @property
    def _velocity(self) -> Expression:
        """Return the velocity as a function of the time since lift-off."""
        exhaust, full = self.exhaust, self.lift_off_mass
        velocity_gain = exhaust * Call("ln", ratio(full, full - self.rate_of_burning * self.time_since_lift_off))
        return velocity_gain - self.gravity.expression() * self.time_since_lift_off if self.gravity else velocity_gain

    def integrated(self, left: Expression, risen: Expression) -> str:
        """Return words that integrate the velocity over time, with the mass as the variable of integration."""
        since, name = self.time_since_lift_off, self.book.fresh("x")
        full, rate = self.lift_off_mass, self.rate_of_burning
        x, time, speed, fallen = name.latex(), since.latex(), self._velocity.latex(), ""
        if self.gravity:
            fallen = f" - {(HALF * self.gravity.expression() * Power(risen, 2)).latex()}"
            speed = rf"\left({speed}\right)"
        log = Call("ln", ratio(full, name))
        masses = rf"\int_{{{left.latex()}}}^{{{full.latex()}}} {log.latex()}\,\mathrm{{d}}{x}"
        return (
            rf"With ${x}$ for ${(full - rate * since).latex()}$, and so $-\mathrm{{d}}{x}/{rate.latex()}$ for "
            rf"$\mathrm{{d}}{time}$, its integral $\int_0^{{{risen.latex()}}} {speed}\,\mathrm{{d}}{time}$ becomes "
            rf"${ratio(self.exhaust, rate).latex()} {masses}{fallen}$; the antiderivative of ${log.latex()}$ is "
            rf"${(name * log + name).latex()}$."
        )

    @property
    def capitalized_name(self) -> str:
        """Return the name of the rocket, capitalized."""
        return capitalized(self.name)

    @property
    def name(self) -> str:
        """Return the name of the rocket within a sentence."""
        return self.setting.display_name(self.burn.body)

    def write_when_known(self, write: Callable[[], None], *held: Expression) -> bool:
        """Call `write` now if the given formulas have known values, else after the answer; return whether now."""
        if not any(map(self.book.is_hidden, held)):
            write()
            return True
        if not self.book.in_symbols:
            self.book.afterwards.append(write)
        return False

    def _write_rising(self) -> None:
        """Write that the thrust exceeds the weight from the start."""
        if self.gravity and not self.mechanism.attractions:
            thrust, weight = self.rate_of_burning * self.exhaust, self.initial_mass * self.gravity.expression()
            self.write_when_known(lambda: self._verify_rising(thrust, weight), thrust, weight)

    def _verify_rising(self, thrust: Expression, weight: Expression) -> None:
        """Write the comparison of thrust and weight."""
        step = self.book.begin_step("verify")
        names = [self.book.fresh("F", mark) for mark in (r"\text{thrust}", r"\text{weight}")]
        pairs = [*zip(names, (thrust, weight), strict=True)]
        self.book.observed |= {name.name: self.book.value(force) for name, force in pairs}
        one, two = (step.verified(name, force, NEWTONS) for name, force in pairs)
        record_inequality(self.book, step, thrust, weight)
        step.add_text(f"{self.capitalized_name} rises from the start, since the thrust {one} exceeds the weight {two}.")
        step.close()

    def assumed_at(self, time: Symbol) -> str:
        """Return the sentence that assumes that no fuel is left at a time; the end of the text may verify this."""
        if self.book.in_symbols:
            return f"By assumption, no fuel is left at ${time.latex()}$. "
        rises = self.setting.motion.state(np.array([self.setting.time])).v[0, 0] > 0.0
        moving = f"{self.name} is moving {'up' if rises else 'down'}"
        return f"Assume that at ${time.latex()}$ no fuel is left and that {moving}. "

    def write_burnout(self, time: Symbol) -> bool:
        """Write that no fuel is left at a time, now or after the answer; return whether the text is written now."""
        formula = (self.initial_mass - self.dry_mass) / self.rate_of_burning
        return self.write_when_known(lambda: self._verify_spent(time, formula), formula, time)

    def _verify_spent(self, time: Symbol, formula: Expression) -> None:
        """Write the comparison of a time with the time of burnout."""
        step = self.book.begin_step("verify")
        record_inequality(self.book, step, time, formula)
        equation = self._observed(step, r"\text{out}", formula)
        step.add_text(f"The fuel lasts for {equation}, so at ${time.name}$ the engine is off.")
        step.close()

    def verify_burning(self, time: Symbol, spent: Expression) -> None:
        """Write that the fuel lasts longer than a given time."""
        step = self.book.begin_step("verify")
        record_inequality(self.book, step, spent, time)
        equation = self._observed(step, r"\text{out}", spent)
        step.add_text(f"The fuel lasts for {equation}, so the engine is still on at this time.")
        step.close()

    def _observed(self, step: StepBuilder, mark: str, formula: Expression) -> str:
        """Name a time that only a verification uses, and return the equation that gives this time."""
        return step.verified(self.book.fresh("t", mark), formula, SECONDS)

    def verify_farther(self, distance: Symbol, high: Expression) -> None:
        """Write that a distance is covered only after burnout."""
        step = self.book.begin_step("verify")
        record_inequality(self.book, step, distance, high)
        step.add_text(f"As ${distance.latex()} > {high.latex()}$, {self.name} covers this distance")
        step.add_text("only after burnout.")
        step.close()


def _pull(mechanism: Mechanism) -> float:
    """Return the initial gravitational acceleration along the rocket's line, m/s²."""
    axis = mechanism.coordinates[0].axis
    acceleration = -sum(a * b for a, b in zip(axis, mechanism.gravity, strict=True))
    frames = initial_frames(mechanism)
    for pull in mechanism.attractions:
        acceleration += _attracted(mechanism, pull, frames.center(pull.a).place, frames.center(pull.b).place)
    return acceleration


def _attracted(mechanism: Mechanism, pull: Attraction, one: Vector, other: Vector) -> float:
    """Return the magnitude of the gravitational acceleration by one attraction at given positions, m/s²."""
    distance = sum((a - b) ** 2 for a, b in zip(one, other, strict=True)) ** 0.5
    heavy = max(mechanism.body[pull.a].mass, mechanism.body[pull.b].mass)
    return pull.constant * heavy / distance**pull.power


def tell_in_the_air(rocket: Burning, velocity: Symbol, risen: Expression) -> None:
    """Write that a falling rocket with its engine off is still in the air, or that it cannot be falling.

    The latter is written if the empty mass is unknown: with that velocity, the rocket would never have lifted off.
    """
    book, u, g = rocket.book, rocket.exhaust, rocket.gravity.expression()
    if book.value(velocity) > 0.0:
        _exclude_falling(rocket, velocity, risen)
        return
    full, dry, rate = rocket.lift_off_mass, rocket.dry_mass, rocket.rate_of_burning
    log, burning = Call("ln", ratio(full, dry)), (full - dry) / rate
    height = u * log * risen - u * (full / rate) * log + u * burning - HALF * g * Power(risen, 2)
    step, name = book.begin_step("verify"), book.fresh("h")
    record_inequality(book, step, height, ZERO)
    equation = step.verified(name, height, METRES)
    text = f"{rocket.capitalized_name} is falling then, but it is still in the air: by integration of its velocity,"
    step.add_text(f"{text} its height is", f"{equation}.")
    step.close()


def _exclude_falling(rocket: Burning, velocity: Symbol, risen: Expression) -> None:
    """Write that a rocket cannot have turned back."""
    book, dry, g = rocket.book, rocket.dry_mass, rocket.gravity.expression()
    if not isinstance(dry, Symbol) or book.sought != dry.name or velocity.name not in book.stated:
        return
    would = rocket.lift_off_mass / Call("exp", (g * risen - velocity) / rocket.exhaust)
    if book.value(would) <= book.value(rocket.lift_off_mass):
        return
    step, name = book.begin_step("verify"), book.fresh(dry.name, r"\text{down}")
    record_inequality(book, step, would, rocket.lift_off_mass)
    equation = step.verified(name, would, KILOGRAMS)
    step.add_text(f"If {rocket.name} moved down at this speed, its empty mass would be {equation}, more than the mass")
    step.add_text(f"${rocket.lift_off_mass.latex()}$ at which it begins to rise.")
    step.close()


def exclude_burning(rocket: Burning, time: Symbol) -> None:
    """Write that a rocket with its engine still on would not be at the given distance.

    It applies to an unknown burning rate; the distance increases with this rate.
    """
    book, rate, query = rocket.book, rocket.rate_of_burning, rocket.query
    far = next((name for name, unit in book.units.items() if name in book.stated and unit == METRES), "")
    target = query.target.quantity if query.target is not None else ""
    unknown = isinstance(rate, Symbol) and book.sought == rate.name
    if not unknown or rocket.waits_on_ground or not far or target not in ("displacement", "distance from start"):
        return
    log, fuel = Call("ln", ratio(rocket.initial_mass, rocket.dry_mass)), rocket.initial_mass - rocket.dry_mass
    most = rocket.exhaust * time - rocket.exhaust * rocket.dry_mass * time / fuel * log
    if rocket.gravity:
        most = most - HALF * rocket.gravity.expression() * Power(time, 2)
    if book.value(most) >= book.values[far]:
        return
    step, name = book.begin_step("verify"), book.fresh("s", r"\text{max}")
    record_inequality(book, step, Symbol(far), most)
    equation = step.verified(name, most, METRES)
    step.add_text(f"If the engine were still on at ${time.latex()}$, ${rate.latex()}$ would be at most")
    step.add_text(f"${(fuel / time).latex()}$, and {rocket.name} at most {equation} from its start, less than ${far}$.")
    step.close()
