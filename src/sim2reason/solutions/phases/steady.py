"""Phases of constant acceleration: solved in closed form instead of integrated."""

from collections.abc import Sequence

from sim2reason.solutions.algebra.evaluated import NumericRoot
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol, added, multiplied
from sim2reason.solutions.algebra.functions import Power
from sim2reason.solutions.algebra.inverse import put, solved_for
from sim2reason.solutions.laws.equations_of_motion import Names
from sim2reason.solutions.phases.contacts import tell_contacts
from sim2reason.solutions.phases.equations import PhaseEquations
from sim2reason.solutions.phases.explicit import explicit
from sim2reason.solutions.phases.pruning import LAWS, STATE, laws_text, state_text
from sim2reason.solutions.setting import capital
from sim2reason.solutions.solution import Relation
from sim2reason.solutions.writing.steps import Book, UnsolvedError
from sim2reason.solutions.writing.unit_latex import SECONDS

Start = tuple[Expression, Sequence[Expression], Sequence[Expression]]
"""The time at which a phase begins, the coordinates and the rates there."""
HALF = Number(0.5)
LONG = 200  # characters of a duration that is written as a formula


class SteadyPhase:
    """One phase in which all accelerations and forces are constant."""

    def __init__(
        self, inner: PhaseEquations, start: tuple[Expression, Sequence[Expression], Sequence[Expression]]
    ) -> None:
        """Take the equations of the phase, and its initial time, coordinates and rates."""
        self._inner, self._names = inner, inner.names
        self._begin, self._places, self._rates = start

    def write(self, book: Book, names: Names, forces: dict[str, Symbol], formula: Expression, said: str) -> None:
        """Write the accelerations, the duration until a formula vanishes, and the state at the end.

        The book knows the values of the end, in `names` and `forces`, already.

        Raises:
            UnsolvedError: the formula contains a force or an acceleration.
        """
        tell_contacts(self._inner, book, forces)
        self._accelerate(book, names, forces)
        span = self._last(book, names, formula, said)
        step = book.open(STATE)
        if span != names.time:
            step.defined(names.time, added(self._begin, span))
        for k in range(len(names.places)):
            step.defined(names.places[k], self._place(k, names, span))
            step.defined(names.rates[k], self._rate(k, names, span))
        step.say(state_text(step.relations, book.values))
        step.close()

    def _accelerate(self, book: Book, names: Names, forces: dict[str, Symbol]) -> None:
        """Write the laws, which determine the constant accelerations and forces."""
        step, inner = book.open(LAWS), self._inner
        own = {old.name: new for old, new in zip(self._names.accelerations, names.accelerations, strict=True)}
        own |= {inner.forces[key].name: symbol for key, symbol in forces.items()}
        for law in inner.laws:
            step.law(_renamed(law.left, own), _renamed(law.right, own))
        found = [symbol for symbol in own.values() if symbol.name in book.values]
        for symbol in found:
            step.label(symbol.name)
        plain = all(isinstance(relation.left, Symbol) for relation in step.relations)
        formulas = explicit(step.relations, [symbol.name for symbol in found], book.values) if not plain else {}
        for symbol in found if not plain else ():
            if symbol.name in formulas and book.values[symbol.name]:
                step.relations.append(Relation(symbol, formulas[symbol.name], "derived", book.units[symbol.name]))
            elif book.values[symbol.name]:
                step.stated(symbol, book.units[symbol.name])
        step.say(laws_text(step.relations, book.values))
        step.close()

    def _last(self, book: Book, names: Names, formula: Expression, said: str) -> Symbol:
        """Write how long the phase lasts."""
        first = self._begin == ZERO  # what lasts until an instant is its time
        span = names.time if first else book.fresh(r"\tau")
        near = book.values[names.time.name] - book.value(self._begin)
        for k, (place, rate) in enumerate(zip(self._names.places, self._names.rates, strict=True)):
            formula = put(put(formula, rate.name, self._rate(k, names, span)), place.name, self._place(k, names, span))
        formula = put(formula, self._names.time.name, added(self._begin, span))
        if not {*formula.symbols()} <= {*book.values, span.name}:
            raise UnsolvedError("the end of a phase of constant acceleration depends on a force")
        found = solved_for(span.name, formula, ZERO, {**book.values, span.name: near})
        if not isinstance(found, NumericRoot) and len(found.latex()) > LONG:
            found = NumericRoot(formula, span.name, near)
        step = book.open("duration")
        law = step.law(formula, ZERO)
        step.say(f"{self._how()} for a time ${span.name}$, until {said}: {law},")
        step.say(f"so that {step.closed(span, found) if first else step.result(span, found, SECONDS)}.")
        step.close()
        return span

    def _how(self) -> str:
        """Return how the phase goes on, in words: at constant velocities, where nothing accelerates in it."""
        inner = self._inner
        if not all(inner.is_still(k) for k in range(len(inner.mechanism.coordinates))):
            return "This goes on"
        rolls = [face for face, side in inner.rough.items() if side == 0 and len(inner.mechanism.faces[face].slip) > 1]
        if not rolls:
            return "All velocities remain constant"
        who = capital(inner.setting.called(inner.mechanism.faces[rolls[0]].subject))
        return f"{who} now rolls, which on level ground needs no friction, so all velocities remain constant"

    def _place(self, k: int, names: Names, span: Symbol) -> Expression:
        gained = added(multiplied(self._rates[k], span), self._bent(k, names, multiplied(HALF, Power(span, 2))))
        return added(self._places[k], gained)

    def _rate(self, k: int, names: Names, span: Symbol) -> Expression:
        return added(self._rates[k], self._bent(k, names, span))

    def _bent(self, k: int, names: Names, factor: Expression) -> Expression:
        """Return the acceleration times a factor; zero where it is zero."""
        zero = self._inner.is_still(k)
        return ZERO if zero else multiplied(names.accelerations[k], factor)


def _renamed(formula: Expression, names: dict[str, Symbol]) -> Expression:
    for old, new in names.items():
        formula = put(formula, old, new)
    return formula
