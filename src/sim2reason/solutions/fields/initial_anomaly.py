"""Initial eccentric anomaly of an orbit, with the reason for its quadrant."""

from collections.abc import Callable

from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root
from sim2reason.solutions.writing.notation import RADIANS
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder, record_inequality


class InitialAnomaly:
    """The initial eccentric anomaly E₀ from p = e cos E₀ and q = e sin E₀, by the best-conditioned inverse function.

    `formula` is that of p; `radial` returns a clause that the body initially recedes or approaches.
    """

    def __init__(
        self, book: SolutionBuilder, p: Symbol, q: Expression, formula: Expression, radial: Callable[[StepBuilder], str]
    ) -> None:
        """Take p, q, the formula of p, and the function that returns the clause about the radial velocity."""
        self._book, self._p, self._q, self._formula, self._radial = book, p, q, formula, radial

    def write(self, name: Symbol, anomaly: Symbol) -> Symbol:
        """Write the value of the initial anomaly under its own name."""
        p, q = self._book.value(self._p), self._book.value(self._q)
        step = self._book.begin_step("anomaly")
        if abs(p) < abs(q):
            size = Call("arccos", self._p / Root(Power(self._p, 2) + Power(self._q, 2)))
            formula, reasons = size if q > 0.0 else -size, [self._radial(step)]
            limits = (0, 180) if q > 0.0 else (-180, 0)
        else:
            principal = Call("arctan", self._q / self._p)
            formula = principal if p > 0.0 else principal + PI if q > 0.0 else principal - PI
            reasons = [self._sign(step)] if p > 0.0 else [self._sign(step), self._radial(step)]
            limits = (-90, 90) if p > 0.0 else (90, 180) if q > 0.0 else (-180, -90)
        low, high = (rf"${limit}^\circ$" for limit in limits)
        text = f"As {' and '.join(reasons)}, the initial value ${name.latex()}$ of ${anomaly.latex()}$ lies between"
        step.add_text(f"{text} {low} and {high}: {step.result(name, formula, RADIANS, law=True)}.")
        step.close()
        return name

    def _sign(self, step: StepBuilder) -> str:
        """Return a clause about the sign of p; an unknown value is verified at the end."""
        positive = self._book.value(self._p) > 0.0
        sides: tuple[Expression, Expression] = (self._p, ZERO) if positive else (ZERO, self._p)
        if not self._book.is_hidden(self._p):
            record_inequality(self._book, step, *sides)
        elif not self._book.in_symbols:
            self._book.afterwards.append(lambda: self._verify(*sides))
        return f"${self._p.latex()} {'>' if positive else '<'} 0$"

    def _verify(self, larger: Expression, smaller: Expression) -> None:
        """Write at the end that the value of p has the assumed sign."""
        step = self._book.begin_step("verify")
        record_inequality(self._book, step, larger, smaller)
        step.add_text(f"Indeed {step.verified(self._p, self._formula, '')} has the sign that was assumed.")
        step.close()
