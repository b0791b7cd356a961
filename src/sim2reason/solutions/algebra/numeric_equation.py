"""Linear equations whose coefficients are written as numbers."""

from collections.abc import Mapping
from dataclasses import dataclass

from sim2reason.solutions.algebra.evaluated import Worked
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol, added, multiplied


@dataclass(frozen=True, slots=True)
class NumericEquation:
    """A linear equation in numbers: Σ coefficient · unknown = `right`."""

    label: str
    left: Mapping[str, Expression]
    right: Expression

    @property
    def sum(self) -> Expression:
        """Return the left side as one formula."""
        found: Expression = ZERO
        for name, part in self.left.items():
            found = added(found, term(part, name, 1.0))
        return found


def term(part: Expression, name: str, sign: float) -> Expression:
    """Return a number times a symbol as a term with its sign in front."""
    negative = isinstance(part, Worked) and part.comes_to < 0.0
    size = -part if negative else part
    return multiplied(Number(-sign if negative else sign), multiplied(size, Symbol(name)))
