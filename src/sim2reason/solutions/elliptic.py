"""Elliptic integrals of the first kind and their inverse, by the arithmetic-geometric mean, step by step.

Abramowitz and Stegun, Handbook of Mathematical Functions, 17.6 (complete: 17.6.3, incomplete: 17.6.8) and 16.4.
"""

from functools import cached_property
from itertools import pairwise
from math import pi, sqrt

from sim2reason.solutions.book import Book
from sim2reason.solutions.expressions import ONE, Expression, Number, Symbol
from sim2reason.solutions.functions import PI, Call, Power, Root
from sim2reason.solutions.setting import joined
from sim2reason.solutions.unit_latex import latex

CLOSE = 1e-9  # how far the two means are apart at last; what they are from their limit is the square of that
RADIANS = latex("rad")
TWO = Number(2.0)


class Elliptic:
    """F(θ, k) and its inverse for one modulus, written in a book as they are needed."""

    def __init__(self, book: Book, modulus: Expression) -> None:
        """`modulus` is k, between 0 and 1."""
        self.book, self.modulus = book, modulus

    @cached_property
    def means(self) -> list[tuple[Expression, Expression]]:
        """The arithmetic and the geometric means, from 1 and k′ = √(1 − k²) on."""
        step, other = self.book.open("means"), self.book.fresh("b", "0")
        step.say(
            "Such a time is an elliptic integral of the first kind, found by arithmetic and geometric means from 1"
        )
        step.say(f"and {step.result(other, Root(ONE - Power(self.modulus, 2)), '', law=True)} on.")
        step.close()
        found: list[tuple[Expression, Expression]] = [(ONE, other)]
        a, b = 1.0, self.book.value(other)
        while a - b > CLOSE:
            a, b = 0.5 * (a + b), sqrt(a * b)
            found.append(self._next(*found[-1], len(found), last=a - b <= CLOSE))
        return found

    def _next(self, a: Expression, b: Expression, number: int, *, last: bool) -> tuple[Expression, Expression]:
        step = self.book.open("means")
        arithmetic, geometric = self.book.fresh("a", str(number)), self.book.fresh("b", str(number))
        told = [step.result(arithmetic, (a + b) / TWO, "", law=True)]
        if not last:
            told.append(step.result(geometric, Root(b if a == ONE else a * b), "", law=True))
        step.say(f"{'Then' if number > 1 else 'First'} {joined(told)}.")
        step.close()
        return arithmetic, arithmetic if last else geometric

    @cached_property
    def complete(self) -> Symbol:
        """K = F(π/2) = π/(2 a)."""
        last = self.means[-1][0]
        said = "The means agree by then, so that for a quarter of the oscillation the integral is"
        return self.book.told("elliptic", said, self.book.fresh("K"), PI / (TWO * last), "")

    def integral(self, angle: Symbol) -> Symbol:
        """F(θ): tan(θ′ − θ) = (b/a) tan θ, step by step, then θ′/(2ⁿ a)."""
        held, value = angle, self.book.values[angle.name]
        means = self.means
        for number, (a, b) in enumerate(means[:-1]):
            turns = round(value / pi)
            turned = Call("arctan", (b if a == ONE else b / a) * Call("tan", held))
            formula = held + turned + Number(float(turns)) * PI if turns else held + turned
            said = "For its angle, Landen's transformation gives" if number == 0 else "Once more,"
            held = self.book.told("landen", said, self.book.fresh(r"\theta"), formula, RADIANS)
            value = self.book.values[held.name]
        count = 2.0 ** (len(means) - 1)
        below = means[-1][0] if count == 1.0 else Number(count) * means[-1][0]
        said = "The integral up to there is that over the mean and the power of two,"
        return self.book.told("elliptic", said, self.book.fresh("F"), held / below, "")

    def amplitude(self, integral: Expression) -> Symbol:
        """The angle θ up to which the integral is F: sin(2θ − θ′) = (c′/a′) sin θ′, from 2ⁿ a F back."""
        means = self.means
        count = 2.0 ** (len(means) - 1)
        said = "Landen's transformation leads back to its angle, from"
        held = self.book.told(
            "landen", said, self.book.fresh(r"\theta"), Number(count) * means[-1][0] * integral, RADIANS
        )
        for (a, b), (mean, _) in reversed(list(pairwise(means))):
            formula = (held + Call("arcsin", (a - b) / (TWO * mean) * Call("sin", held))) / TWO
            held = self.book.told("landen", "Then to", self.book.fresh(r"\theta"), formula, RADIANS)
        return held
