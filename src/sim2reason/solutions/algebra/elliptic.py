"""Elliptic integrals of the first kind and their inverse, by the arithmetic-geometric mean, step by step.

Abramowitz and Stegun, Handbook of Mathematical Functions, 17.6 (complete: 17.6.3, incomplete: 17.6.8) and 16.4.
"""

from itertools import pairwise
from math import pi, sqrt

from sim2reason.lazy import cached_property
from sim2reason.solutions.algebra.expressions import ONE, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root
from sim2reason.solutions.setting import joined
from sim2reason.solutions.writing.steps import Book, Writing
from sim2reason.solutions.writing.unit_latex import RADIANS

CLOSE = 1e-11  # how far the two means are apart at last: an angle errs by as much, a speed near a turn by more
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
        told = [step.result(other, Root(ONE - Power(self.modulus, 2)), "", law=True)]
        found: list[tuple[Expression, Expression]] = [(ONE, other)]
        a, b = 1.0, self.book.value(other)
        while a - b > CLOSE:
            a, b = 0.5 * (a + b), sqrt(a * b)
            pair, said = self._next(step, *found[-1], len(found), last=a - b <= CLOSE)
            found.append(pair)
            told += said
        step.say(f"Such a time is an elliptic integral. The arithmetic and geometric means from 1 and {told[0]} on:")
        step.say(f"{joined(told[1:])}.")
        step.close()
        return found

    def _next(
        self, step: Writing, a: Expression, b: Expression, number: int, *, last: bool
    ) -> tuple[tuple[Expression, Expression], list[str]]:
        arithmetic, geometric = self.book.fresh("a", str(number)), self.book.fresh("b", str(number))
        told = [step.result(arithmetic, (a + b) / TWO, "", law=True)]
        if not last:
            told.append(step.result(geometric, Root(b if a == ONE else a * b), "", law=True))
        return (arithmetic, arithmetic if last else geometric), told

    @cached_property
    def complete(self) -> Symbol:
        """K = F(π/2) = π/(2 a)."""
        last = self.means[-1][0]
        said = "For a quarter oscillation the integral is"
        return self.book.told("elliptic", said, self.book.fresh("K"), PI / (TWO * last), "")

    def integral(self, angle: Symbol) -> Symbol:
        """F(θ): tan(θ′ − θ) = (b/a) tan θ, step by step, then θ′/(2ⁿ a)."""
        held, value = angle, self.book.values[angle.name]
        means = self.means
        step, told = self.book.open("landen"), list[str]()
        for a, b in means[:-1]:
            turns = round(value / pi)
            turned = Call("arctan", (b if a == ONE else b / a) * Call("tan", held))
            formula = held + turned + Number(float(turns)) * PI if turns else held + turned
            held = self.book.fresh(r"\theta")
            told.append(step.result(held, formula, RADIANS, law=True))
            value = self.book.values[held.name]
        step.say(f"By Landen's transformation, {joined(told)}.")
        step.close()
        count = 2.0 ** (len(means) - 1)
        below = means[-1][0] if count == 1.0 else Number(count) * means[-1][0]
        said = "The integral up to there is"
        return self.book.told("elliptic", said, self.book.fresh("F"), held / below, "")

    def amplitude(self, integral: Expression) -> Symbol:
        """The angle θ up to which the integral is F: sin(2θ − θ′) = (c′/a′) sin θ′, from 2ⁿ a F back."""
        means = self.means
        count = 2.0 ** (len(means) - 1)
        step, held = self.book.open("landen"), self.book.fresh(r"\theta")
        told = [step.result(held, Number(count) * means[-1][0] * integral, RADIANS, law=True)]
        for (a, b), (mean, _) in reversed(list(pairwise(means))):
            formula = (held + Call("arcsin", (a - b) / (TWO * mean) * Call("sin", held))) / TWO
            held = self.book.fresh(r"\theta")
            told.append(step.result(held, formula, RADIANS, law=True))
        step.say(f"Landen's transformation leads back to its angle: {joined(told)}.")
        step.close()
        return held
