"""Linear equations whose coefficients are symbols: unknowns eliminated by multiplying crosswise, without fractions."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from sim2reason.solutions.algebra.expressions import Expression, Symbol, parenthesized
from sim2reason.solutions.algebra.fractions import over
from sim2reason.solutions.algebra.polynomials import Polynomial, total
from sim2reason.solutions.writing.steps import Book, Writing


@dataclass(frozen=True, slots=True)
class SymbolicEquation:
    """A linear equation in symbols: `rest` = Σ coefficient · unknown."""

    label: str
    left: Mapping[str, Polynomial]
    rest: Polynomial

    @property
    def turned(self) -> "SymbolicEquation":
        """The same with all signs turned."""
        left = {name: part.scaled(-1.0) for name, part in self.left.items()}
        return SymbolicEquation(self.label, left, self.rest.scaled(-1.0))

    @property
    def sides(self) -> tuple[Expression, Expression]:
        """Both as formulas, with the unknowns on the right, as in the laws that are added up."""
        whole = total(part * Polynomial.of(Symbol(name)) for name, part in self.left.items())
        return self.rest.expression(), whole.collected(self.left)


class CrossElimination:
    """Solves such equations, and writes down how."""

    def __init__(self, book: Book, units: Mapping[str, str], opened: Callable[[str], Writing]) -> None:
        """Take the `units`, in LaTeX, of every unknown, and the function `opened` that begins a step."""
        self.book, self.units, self._opened = book, units, opened

    def reduce(self, equations: Sequence[SymbolicEquation], names: Sequence[str]) -> None:
        """Give all names their values, the first one first."""
        last = names[-1]
        having = [held for held in equations if last in held.left]
        pivot = min(having, key=lambda held: (len(held.left[last].terms), len(held.left)))
        if len(names) > 1:
            rest = [held for held in equations if held is not pivot]
            reduced = [self._without(held, pivot, last) if last in held.left else held for held in rest]
            self.reduce(reduced, names[:-1])
        step = self._opened("solve")
        step.rest_on(pivot.label)
        above, below = pivot.rest, pivot.left[last]
        for name, part in pivot.left.items():
            above = above - part * Polynomial.of(Symbol(name)) if name != last else above
        if sum(below.terms.values()) < 0.0:
            above, below = above.scaled(-1.0), below.scaled(-1.0)
        where = f"From {pivot.label}, " if len(names) > 1 else "So "
        step.say(f"{where}{step.result(Symbol(last), over(above, below), self.units[last])}.")
        step.close()

    def _without(self, held: SymbolicEquation, pivot: SymbolicEquation, last: str) -> SymbolicEquation:
        """Each times what stands before the unknown in the other, the difference told."""
        mine, other = _signed(pivot.left[last]), _signed(held.left[last])
        sign = -mine[0] * other[0]
        names = dict.fromkeys((*held.left, *pivot.left))
        none = Polynomial({})
        left = {
            name: held.left.get(name, none) * mine[1] + (pivot.left.get(name, none) * other[1]).scaled(sign)
            for name in names
            if name != last
        }
        rest = held.rest * mine[1] + (pivot.rest * other[1]).scaled(sign)
        found = SymbolicEquation(self.book.labels.next(), {n: part for n, part in left.items() if part}, rest)
        step = self._opened("combine")
        step.rest_on(held.label)
        step.rest_on(pivot.label)
        step.label(found.label)
        told = [_times(mine[1], held.label), _times(other[1], pivot.label)]
        if sign < 0.0 and sum(part for held in found.left.values() for part in held.terms.values()) < 0.0:
            found = found.turned
            told.reverse()
        step.say(f"{(' + ' if sign > 0.0 else ' − ').join(told)}: {found.label} {step.derived(*found.sides)}.")
        step.close()
        return found


def _signed(held: Polynomial) -> tuple[float, Polynomial]:
    """With its sign taken out where all terms share it."""
    negative = all(part < 0.0 for part in held.terms.values())
    return (-1.0, held.scaled(-1.0)) if negative else (1.0, held)


def _times(weight: Polynomial, label: str) -> str:
    return label if weight.number == 1.0 else f"${parenthesized(weight.expression(), 1)}$·{label}"
