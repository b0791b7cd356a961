"""A rocket that burns its fuel: its engine, its mass, gravity, and when it begins to rise and has none left."""

from collections.abc import Callable

import numpy as np

from sim2reason.dsl.frames import start
from sim2reason.dsl.mechanism import Attraction, Burn, Mechanism
from sim2reason.dsl.vectors import Vector
from sim2reason.lazy import cached_property
from sim2reason.questions.kinds.parts.stretch_kind import StretchQuery
from sim2reason.solutions.algebra.expressions import Expression, Symbol
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.laws.newton import Newton
from sim2reason.solutions.laws.straight_way import Way
from sim2reason.solutions.setting import capital
from sim2reason.solutions.writing.comparing import exceeds
from sim2reason.solutions.writing.steps import UnsolvedError
from sim2reason.solutions.writing.unit_latex import KILOGRAMS, NEWTONS, SECONDS


class Burning(Way):
    """The numbers of a rocket, and the times at which something changes, written as they are needed."""

    @property
    def newton(self) -> Newton:
        """None is needed."""
        raise UnsolvedError("a rocket has no law of constant mass")

    def force(self, kind: str, name: str) -> Symbol:
        """None."""
        raise UnsolvedError(f"no {kind} of {name}")

    # ---- numbers

    def _read(self, number: Callable[[Mechanism], float]) -> Polynomial:
        return self.setting.lexicon.of(number)

    @property
    def burn(self) -> Burn:
        """The engine."""
        return self.setting.lexicon.mechanism.burns[0]

    @cached_property
    def rate_of_burning(self) -> Expression:
        """µ."""
        return self._read(lambda m: m.burns[0].rate).expression()

    @cached_property
    def exhaust(self) -> Expression:
        """U."""
        return self._read(lambda m: m.burns[0].exhaust).expression()

    @cached_property
    def first(self) -> Expression:
        """The mass with all fuel."""
        return self._read(lambda m: m.body[m.burns[0].body].mass).expression()

    @cached_property
    def dry(self) -> Expression:
        """The empty mass of the rocket, kg."""
        return self._read(lambda m: m.body[m.burns[0].body].mass - m.burns[0].rate * m.burns[0].until).expression()

    @property
    def gravity(self) -> Polynomial:
        """Of the ground, or of the planet at its surface."""
        return self._read(_pull)

    # ---- the moment

    @property
    def waits(self) -> bool:
        """Whether it stands on the ground until it is light enough."""
        return self.setting.motion.segments[0].a[0] <= 0.0

    @property
    def out(self) -> bool:
        """Whether its engine is off by then."""
        return self.setting.time > self.burn.until * (1.0 + 1e-9) or isinstance(self.query, StretchQuery)

    @cached_property
    def full(self) -> Expression:
        """The mass with which it begins to rise."""
        if not self.waits:
            self._tell_rising()
            return self.first
        thrust = self.rate_of_burning * self.exhaust
        said = f"{self.who} stays on the ground until the thrust equals its weight, at the mass"
        return self.book.told(
            "wait", said, self.book.fresh("m", r"\text{lift}"), thrust / self.gravity.expression(), KILOGRAMS
        )

    def _risen(self, time: Expression) -> Expression:
        """For how long it has risen by a time."""
        return time - self._wait if self.waits else time

    @cached_property
    def _wait(self) -> Symbol:
        formula = (self.first - self.full) / self.rate_of_burning
        return self.book.told(
            "wait", "Its mass has fallen to this value after", self.book.fresh("t", r"\text{lift}"), formula, SECONDS
        )

    @cached_property
    def rising(self) -> Symbol:
        """Return the time for which it rises with its engine on."""
        if not self.waits:
            return self.burned
        said, formula = "From then on its fuel lasts for", (self.full - self.dry) / self.rate_of_burning
        return self.book.told("time", said, self.book.fresh("t", r"\text{up}"), formula, SECONDS)

    @cached_property
    def burned(self) -> Symbol:
        """When the fuel is spent."""
        formula = (self.first - self.dry) / self.rate_of_burning
        base = self.book.fresh("t", r"\text{out}") if self.out else self.book.fresh("t")
        return self.book.told("time", "The fuel lasts for", base, formula, SECONDS)

    @property
    def who(self) -> str:
        """The rocket, as a sentence begins with it."""
        return capital(self.name)

    @property
    def name(self) -> str:
        """The rocket, within a sentence."""
        return self.setting.called(self.burn.body)

    def told_when_known(self, write: Callable[[], None], *held: Expression) -> bool:
        """Call `write` now if the numbers are known, else after the answer; return whether it was called now."""
        if not any(map(self.book.is_hidden, held)):
            write()
            return True
        if not self.book.in_symbols:
            self.book.afterwards.append(write)
        return False

    def _tell_rising(self) -> None:
        """Say that the thrust exceeds the weight from the start; nothing rests on it."""
        if self.gravity and not self.mechanism.attractions:
            thrust, weight = self.rate_of_burning * self.exhaust, self.first * self.gravity.expression()
            self.told_when_known(lambda: self._verify_rising(thrust, weight), thrust, weight)

    def _verify_rising(self, thrust: Expression, weight: Expression) -> None:
        step = self.book.open("verify")
        names = [self.book.fresh("F", mark) for mark in (r"\text{thrust}", r"\text{weight}")]
        pairs = [*zip(names, (thrust, weight), strict=True)]
        self.book.observed |= {name.name: self.book.value(held) for name, held in pairs}
        told = [step.verified(name, held, NEWTONS) for name, held in pairs]
        exceeds(self.book, step, thrust, weight)
        step.say(f"{self.who} rises from the start, since the thrust {told[0]} exceeds the weight {told[1]}.")
        step.close()

    def assumed_at(self, time: Symbol) -> str:
        """Return a sentence about a time, what is verified in the end or what the problem assumes."""
        if self.book.in_symbols:
            return f"By assumption, no fuel is left at ${time.latex()}$. "
        rises = self.setting.motion.state(np.array([self.setting.time])).v[0, 0] > 0.0
        moving = f"{self.name} is moving {'up' if rises else 'down'}"
        return f"Assume that at ${time.latex()}$ no fuel is left and that {moving}. "

    def tell_spent(self, time: Symbol) -> bool:
        """Say that no fuel is left at a time, on which nothing rests; return whether it can be said already."""
        formula = (self.first - self.dry) / self.rate_of_burning
        return self.told_when_known(lambda: self._verify_spent(time, formula), formula, time)

    def _verify_spent(self, time: Symbol, formula: Expression) -> None:
        step, name = self.book.open("verify"), self.book.fresh("t", r"\text{out}")
        exceeds(self.book, step, time, formula)
        self.book.observed[name.name] = self.book.value(formula)
        told = step.verified(name, formula, SECONDS)
        step.say(f"The fuel lasts for {told}, so at ${time.name}$ the engine is off.")
        step.close()

    def verify_burning(self, time: Symbol, spent: Expression) -> None:
        """Write that the fuel lasts for longer than a time."""
        step, name = self.book.open("verify"), self.book.fresh("t", r"\text{out}")
        exceeds(self.book, step, spent, time)
        self.book.observed[name.name] = self.book.value(spent)
        step.say(f"The fuel lasts for {step.verified(name, spent, SECONDS)}, so the engine is still on at this time.")
        step.close()

    def verify_farther(self, distance: Symbol, high: Expression) -> None:
        """Write that a distance is covered only after burnout."""
        step = self.book.open("verify")
        exceeds(self.book, step, distance, high)
        step.say(f"As ${distance.latex()} > {high.latex()}$, {self.name} covers this distance")
        step.say("only after burnout.")
        step.close()


def _pull(mechanism: Mechanism) -> float:
    """The acceleration of free fall along the rocket's way, at the start."""
    axis = mechanism.coordinates[0].axis
    found = -sum(a * b for a, b in zip(axis, mechanism.gravity, strict=True))
    frames = start(mechanism)
    for pull in mechanism.attractions:
        found += _attracted(mechanism, pull, frames.center(pull.a).place, frames.center(pull.b).place)
    return found


def _attracted(mechanism: Mechanism, pull: Attraction, one: Vector, other: Vector) -> float:
    apart = sum((a - b) ** 2 for a, b in zip(one, other, strict=True)) ** 0.5
    heavy = max(mechanism.body[pull.a].mass, mechanism.body[pull.b].mass)
    return pull.constant * heavy / apart**pull.power
