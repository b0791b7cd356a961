"""Answers about motions with one free coordinate, or with two that momentum ties together."""

from abc import abstractmethod

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.scenes.dsl.state import Array
from sim2reason.solutions.algebra.elimination import solve_linear
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.fractions import reduced_quotient
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.oscillations.linear_way import LinearMotionModel
from sim2reason.solutions.oscillations.relative_motion import RelativeMotion
from sim2reason.solutions.setting import capitalized
from sim2reason.solutions.writing.notation import ACCELERATION, METRES, SPEED
from sim2reason.solutions.writing.steps import UnsolvedError


def signed_polynomial(formula: Expression) -> Polynomial:
    """Convert a formula that is a symbol, its negative, or zero to a polynomial."""
    return (
        NIL
        if formula == ZERO
        else Polynomial.from_expression(-formula).scale(-1.0)
        if formula.negative
        else Polynomial.from_expression(formula)
    )


class OneCoordinateModel(LinearMotionModel):
    """A motion model that expresses all quantities by the only free coordinate."""

    _given_distance = ""  # symbol of the distance that a moment states

    @property
    @abstractmethod
    def name(self) -> Symbol:
        """Return the symbol of the free coordinate."""

    @property
    def mover(self) -> str:
        """Return the phrase for the body that moves with the only free coordinate."""
        return self.mover_phrase(self.motion.free[0])

    @property
    def at_rest(self) -> str:
        """Return the clause that the body is at rest for an instant."""
        return f"{self.mover} is at rest"

    def fastest(self, where: str) -> str:
        """Return a clause such as *block A is fastest at the position x, where its speed is*, before the value."""
        return f"{self.mover} is fastest at {where}, where its speed is"

    @property
    def standing(self) -> str:
        """Return the words such as *Block A turns back*, which begin a sentence about a turning point."""
        return f"{capitalized(self.mover)} turns back"

    @abstractmethod
    def along(self, kind: str) -> Polynomial:
        """Return the displacement ``s``, velocity ``v`` or acceleration ``a`` of the free coordinate."""

    def place(self, i: int) -> Polynomial:
        """Return the displacement of the free coordinate."""
        del i
        return self.along("s")

    def speed(self, i: int) -> Polynomial:
        """Return the velocity of the free coordinate."""
        del i
        return self.along("v")

    def acceleration(self, i: int) -> Polynomial:
        """Return the acceleration of the free coordinate."""
        del i
        return self.along("a")

    def share(self, k: int) -> tuple[Polynomial, Polynomial] | None:
        """Return displacement k over the free coordinate, as (numerator, denominator); None if the quotient varies."""
        return Polynomial.from_expression(self.motion.ratio(k, self.motion.free[0])), Polynomial.from_expression(1.0)

    def moved_to(self, moment: Moved) -> Expression:
        """Return the value of the free coordinate when a body has moved a stated distance, m."""
        k, *_ = self.moving([moment.name])
        share, name = self.share(k), self.book.fresh("d")
        if share is None:
            raise UnsolvedError("the moment is not about the relative motion")
        self.book.state_given(name.name, moment.value, METRES)
        self._given_distance = name.name
        there = self.setting.motion.state(np.array([self.setting.time])).q[0, k]
        return reduced_quotient(
            share[1] * Polynomial.from_expression(name).scale(1.0 if there > 0.0 else -1.0), share[0]
        )

    def relaxed_place(self, spring: str) -> Expression:
        """Return the value of the free coordinate at which a spring has its natural length, m."""
        part = self.motion.extension_ratio(self._number(spring), self.motion.free[0])
        return self.spring("strain", spring).scale(-1.0 / part).expression()

    def stops_alone(self) -> None:
        """Raise UnsolvedError if a body comes to rest while the free coordinate still changes."""
        moment = self.query.moment
        if isinstance(moment, Stopped) and any(self.share(k) is None for k in self.moving([moment.name])):
            raise UnsolvedError("the moment is not about the relative motion")

    def engine_value(self, row: Array) -> float:
        """Return the engine's value of the free coordinate, from the values of all coordinates."""
        i = self.motion.free[0]
        return self.newton.scale[i].value * float(row[i])


class TwoBodyModel(OneCoordinateModel):
    """A motion model of two bodies: the relative motion, and the shared motion from conserved momentum."""

    @property
    def at_rest(self) -> str:
        """Return the clause that the bodies do not move relative to each other."""
        return "the relative velocity is zero"

    def fastest(self, where: str) -> str:
        """Return a clause that the relative velocity is greatest at the position `where`, before its value."""
        return f"the relative velocity is greatest at {where}, where it is"

    @property
    def standing(self) -> str:
        """Return the words *The relative motion turns back*, which begin a sentence about a turning point."""
        return "The relative motion turns back"

    @property
    def motion(self) -> RelativeMotion:
        """Return the equations of the relative motion."""
        return self._relative

    @cached_property
    def _relative(self) -> RelativeMotion:
        return RelativeMotion(self.linear, self.book)

    def share(self, k: int) -> tuple[Polynomial, Polynomial] | None:
        """Return displacement k over the relative displacement, as (numerator, denominator); None if it varies."""
        relative = self._relative
        if {*relative.ratios[k]} == {*relative.free}:
            return super().share(k)
        if self.conserved_momentum:
            return None
        shared, both, _ = relative.masses
        own, other = relative.ratio(k, relative.free[0]), relative.ratio(k, relative.other)
        numerator = shared.scale(own) - both.scale(other)
        return (
            (numerator, shared)
            if numerator.value(relative.givens) > 0.0
            else (numerator.scale(-1.0), shared.scale(-1.0))
        )

    def moved_to(self, moment: Moved) -> Expression:
        """Return the relative displacement at which a body has moved a stated distance; written if momentum is used."""
        formula = super().moved_to(moment)
        if {*self._relative.ratios[self.moving([moment.name])[0]]} == {*self._relative.free}:
            return formula
        text = f"{self._relative.words.zero_momentum_sentence}. The relative displacement is then"
        return self.book.add_step("momentum", text, self.name, formula, METRES)

    def initial_rate(self, i: int) -> Polynomial:
        """Return the initial rate of a coordinate: of the relative motion, or of the motion common to both bodies."""
        relative = self._relative
        mine = self.first_speeds.get(i, NIL)
        if i == relative.other:
            return mine
        return mine - self.first_speeds.get(relative.other, NIL).scale(relative.shared)

    def engine_value(self, row: Array) -> float:
        """Return the relative rate, in SI units, from the rates of all coordinates."""
        relative, scale = self._relative, self.newton.scale
        i, j = relative.free[0], relative.other
        return scale[i].value * float(row[i]) - relative.shared * scale[j].value * float(row[j])

    def introduce(self, names: dict[int, Symbol], origin: str = "") -> None:
        """Write the name of the relative displacement."""
        relative, step = self._relative, self.book.begin_step("names")
        ((i, name),) = names.items()
        who, other = (self.setting.display_name(self.mechanism.coordinates[k].body) for k in (i, relative.other))
        reference_phrase = f" relative to {other}" if relative.shared or self.mechanism.coordinates[i].body else ""
        step.add_text(f"Let ${name.name}$ be the displacement of {who} {self.towards(i)}{reference_phrase}{origin}.")
        step.close()
        frame = relative.words.frame if self.conserved_momentum else f"{relative.words.zero}, so"
        relative.coordinate_name = name.name
        relative.recoils = f"{frame} the velocity of {other} {self.towards(relative.other)} is"

    @property
    def conserved_momentum(self) -> Polynomial:
        """Return the conserved momentum of the two bodies, from the initial rates."""
        relative = self._relative
        return relative.momentum({i: self.initial_rate(i) for i in (relative.other, *relative.free)})

    # ---- what both share

    def _balanced(self, kind: str, unit: str, total: Polynomial, said: str) -> Polynomial:
        """Write a displacement, velocity or acceleration common to both bodies, from the momentum, and return it."""
        if kind in self._written_quantities:
            return self._written_quantities[kind]
        shared, both, _ = self._relative.masses
        mark = self.setting.subscript_of(self.mechanism.coordinates[self._relative.other].body)
        step, name = self.book.begin_step("momentum"), self.book.fresh(kind, mark)
        left = shared * Polynomial.from_expression(name) + both * self.along(kind)
        law = step.law(left.collected([name.name]), total.expression())
        equation = step.result(name, solve_linear(left - total, name.name), unit)
        whose = f"of {self._partner()} {self.towards(self._relative.other)}"
        step.add_text(f"{said} ${name.latex()}$ {whose}: {law}, so {equation}.")
        step.close()
        self._written_quantities[kind] = Polynomial.from_expression(name)
        return self._written_quantities[kind]

    @cached_property
    def _written_quantities(self) -> dict[str, Polynomial]:
        return {}

    def _partner(self) -> str:
        return self.setting.display_name(self.mechanism.coordinates[self._relative.other].body)

    def place(self, i: int) -> Polynomial:
        """Return the displacement of a coordinate, m: the relative one, or that of both bodies, from momentum."""
        if i != self._relative.other:
            return self.along("s")
        total = self.conserved_momentum
        if total:
            total = total * Polynomial.from_expression(self.moment_time())
        if not total and not self.along("s"):
            return NIL
        text = self._relative.words.drifts if self.conserved_momentum else self._relative.words.zero_momentum_sentence
        text = f"{text}; with the displacement"
        return self._balanced("s", METRES, total, text)

    def speed(self, i: int) -> Polynomial:
        """Return the velocity of a coordinate, m/s: the relative one, or that common to both bodies, from momentum."""
        if i != self._relative.other:
            return self.along("v")
        if not self.conserved_momentum and not self.along("v"):
            return NIL
        return self._balanced(
            "v", SPEED, self.conserved_momentum, f"{self._relative.words.conserved}; with the velocity"
        )

    def acceleration(self, i: int) -> Polynomial:
        """Return the acceleration of a coordinate, m/s²: the relative one, or that common to both bodies."""
        if i != self._relative.other:
            return self.along("a")
        text = f"{self._relative.words.unaccelerated}; with the acceleration"
        return self._balanced("a", ACCELERATION, NIL, text)
