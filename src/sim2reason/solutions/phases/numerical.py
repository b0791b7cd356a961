"""Phases without a closed form: their initial-value problem, stated in full and integrated numerically."""

from collections import Counter
from collections.abc import Iterator
from functools import reduce

from sim2reason.solutions.algebra.digits import DIGITS
from sim2reason.solutions.algebra.expressions import Expression, Sum, Symbol, added
from sim2reason.solutions.algebra.functions import Root
from sim2reason.solutions.setting import joined
from sim2reason.solutions.solution import Integration, with_unit
from sim2reason.solutions.writing.steps import STATE_DIGITS, Book, UnsolvedError, Writing

LONG = 900  # characters of an equation: a longer one is not written
ORDINALS = ("", "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth")


def tell_problem(book: Book, step: Writing, integration: Integration, *, first: bool, letter: str) -> None:
    """Write the equations and initial values of a phase; roots that occur several times get a name."""
    sides = [side for law in integration.equations for side in (law.left, law.right)]
    count = Counter(root for side in sides for root in _roots(side))
    named = {root: book.fresh(letter) for root, times in count.items() if times > 1}
    laws = [f"${_with(law.left, named).latex()} = {_with(law.right, named).latex()}$" for law in integration.equations]
    if any(len(law) > LONG for law in laws):
        raise UnsolvedError("the equations of motion are too long to be written")
    where = [f"${name.name} = {root.latex()}$" for root, name in named.items()]
    equations = "equations of motion are" if len(laws) > 1 else "equation of motion is"
    step.say(f"The {equations} {joined(laws)}{f', where {joined(where)}' if where else ''}.")
    begun = [f"${c.place} = {c.initial_place.latex()}$" for c in integration.coordinates]
    begun += [f"${c.rate} = {c.initial_rate.latex()}$" for c in integration.coordinates]
    step.say(f"{'Initially' if first else 'The phase begins with'} {joined(begun)}.")
    if integration.accumulated:
        (held,) = integration.accumulated
        rate, begun = held.rate.latex(), held.initial.latex()
        step.say(rf"Along with them, $\dot{{{held.name}}} = {rate}$ from ${begun}$ is integrated.")


def tell_end(book: Book, integration: Integration, said: str, used: frozenset[str]) -> str:
    """Return the sentence about the end of a phase, with those values on which something later rests."""
    condition = integration.until
    kept = [name for _, name in integration.ends if name in used]
    begins = {name for step in book.steps if step.integration is not None for name in step.integration.symbols()}
    digits = {name: STATE_DIGITS if name in begins else DIGITS for name in kept}
    values = [f"${name} = {with_unit(book.values[name], book.units[name], digits[name])}$" for name in kept]
    if not values:
        raise UnsolvedError("nothing rests on the state to which the motion is integrated")
    later = 1 < condition.occurrence < len(ORDINALS)
    which = f" for the {ORDINALS[condition.occurrence]} time" if later else ""
    when = f"{said}, that is, until {_equation(condition.expression)}" if said else _equation(condition.expression)
    first = " for the first time" if not said and condition.occurrence == 1 and not condition.direction else ""
    return f"Numerical integration until {when}{which or first}{',' if said else ''} gives {joined(values)}."


def _equation(formula: Expression) -> str:
    """Return the equation that a formula is zero, in LaTeX with dollars; a symbol that is subtracted stands right."""
    if isinstance(formula, Sum) and isinstance(last := -formula.terms[-1], Symbol):
        return f"${reduce(added, formula.terms[:-1]).latex()} = {last.name}$"
    return f"${formula.latex()} = 0$"


def _roots(formula: Expression) -> Iterator[Root]:
    if isinstance(formula, Root):
        yield formula
    for part in formula.parts:
        yield from _roots(part)


def _with(formula: Expression, named: dict[Root, Symbol]) -> Expression:
    """Return a formula with names in place of roots."""
    if isinstance(formula, Root) and formula in named:
        return named[formula]
    return formula.built_of([_with(part, named) for part in formula.parts]) if formula.parts else formula
