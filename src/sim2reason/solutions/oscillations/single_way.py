"""The way to one answer where one coordinate is free: all else comes as far as it does, in proportion."""

from abc import abstractmethod

import numpy as np

from sim2reason.dsl.state import Array
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.fractions import over
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.oscillations.linear_way import LinearWay
from sim2reason.solutions.setting import capital
from sim2reason.solutions.writing.steps import UnsolvedError
from sim2reason.solutions.writing.unit_latex import METRES


def signed(held: Expression) -> Polynomial:
    """Return a symbol, its negative, or zero as a polynomial."""
    return NIL if held == ZERO else Polynomial.of(-held).scaled(-1.0) if held.negative else Polynomial.of(held)


class SingleWay(LinearWay):
    """Goals in terms of the only free coordinate."""

    _given_distance = ""  # the name of the distance that a moment states

    @property
    @abstractmethod
    def name(self) -> Symbol:
        """What the free coordinate is called."""

    @property
    def mover(self) -> str:
        """Return what moves with the only free coordinate, in words."""
        return self.who(self.motion.free[0])

    @property
    def at_rest(self) -> str:
        """Return the clause that it is at rest for an instant."""
        return f"{self.mover} is at rest"

    def fastest(self, where: str) -> str:
        """Return the clause that its speed is greatest at a place; the speed follows."""
        return f"{self.mover} is fastest at {where}, where its speed is"

    @property
    def standing(self) -> str:
        """Begin a sentence with where, or when, it is at rest for an instant."""
        return f"{capital(self.mover)} turns back"

    @abstractmethod
    def along(self, kind: str) -> Polynomial:
        """Place ``s``, speed ``v`` or acceleration ``a`` of the free coordinate at the moment."""

    def place(self, i: int) -> Polynomial:
        """How far it has come."""
        del i
        return self.along("s")

    def speed(self, i: int) -> Polynomial:
        """How fast it changes."""
        del i
        return self.along("v")

    def acceleration(self, i: int) -> Polynomial:
        """How fast that does."""
        del i
        return self.along("a")

    def share(self, k: int) -> tuple[Polynomial, Polynomial] | None:
        """How far a coordinate comes as the only free one does, a fraction; None where that hangs on the time, too."""
        return Polynomial.of(self.motion.ratio(k, self.motion.free[0])), Polynomial.of(1.0)

    def moved_to(self, moment: Moved) -> Expression:
        """Where the only free coordinate is when a body has moved a stated distance."""
        k, *_ = self.moving([moment.name])
        share, name = self.share(k), self.book.fresh("d")
        if share is None:
            raise UnsolvedError("the moment is not about the relative motion")
        self.book.say_given(name.name, moment.value, METRES)
        self._given_distance = name.name
        there = self.setting.motion.state(np.array([self.setting.time])).q[0, k]
        return over(share[1] * Polynomial.of(name).scaled(1.0 if there > 0.0 else -1.0), share[0])

    def relaxed_place(self, spring: str) -> Expression:
        """Where the only free coordinate is when a spring has its natural length."""
        part = self.motion.drawn(self._number(spring), self.motion.free[0])
        return self.spring("strain", spring).scaled(-1.0 / part).expression()

    def stops_alone(self) -> None:
        """UnsolvedError where a body comes to rest while the free coordinate goes on."""
        moment = self.query.moment
        if isinstance(moment, Stopped) and any(self.share(k) is None for k in self.moving([moment.name])):
            raise UnsolvedError("the moment is not about the relative motion")

    def seen(self, row: Array) -> float:
        """Of the engine's values of all coordinates, that of the only free one."""
        i = self.motion.free[0]
        return self.newton.scale[i].here * float(row[i])
