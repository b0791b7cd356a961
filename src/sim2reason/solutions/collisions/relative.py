"""The relative motion of two bodies that do not collide, in the named numbers that show why."""

from dataclasses import dataclass, field

from sim2reason.solutions.algebra.expressions import ZERO, Expression, ratio
from sim2reason.solutions.writing.steps import Book, UnsolvedError, Writing

LONG = 160  # characters of a formula whose number alone is written


@dataclass(frozen=True)
class RelativeMotion:
    """Named numbers of the relative motion of two bodies, which only the argument that they do not collide uses."""

    book: Book
    step: Writing
    letters: str
    told: list[str] = field(default_factory=list[str])
    names: list[Expression] = field(default_factory=list[Expression])

    def named(self, base: str, formula: Expression, unit: str, axis: str = "") -> Expression:
        """Return a name for a number that is told before the argument; what is zero needs none."""
        if not self.book.value(formula):
            return ZERO
        self.names.append(self._verified(base, formula, unit, axis, self.told))
        return self.names[-1]

    def quotient(self) -> Expression:
        """Return the first named number divided by the second; UnsolvedError if one of the two was zero, as a gap."""
        if len(self.names) != 2:
            raise UnsolvedError("two that touch collide as soon as they approach each other")
        return ratio(*self.names)

    def concluded(self, base: str, formula: Expression, unit: str) -> str:
        """Return the equation of the number on which the argument ends."""
        said: list[str] = []
        self._verified(base, formula, unit, "", said)
        return said[0]

    def _verified(self, base: str, formula: Expression, unit: str, axis: str, told: list[str]) -> Expression:
        name = self.book.fresh(base, f"{axis},{self.letters}" if axis else self.letters)
        self.book.know(name.name, self.book.value(formula), self.book.unit_in_text(unit))
        short = len(formula.latex()) <= LONG
        told.append(self.step.verified(name, formula if short else self.book.worked(formula), unit))
        return name
