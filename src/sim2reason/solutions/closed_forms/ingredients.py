"""The last algebra of an answer in symbols: what the quantities on the way come to, and what is inserted into what."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import isclose

from sim2reason.base.lazy import cached_property
from sim2reason.solutions.algebra.expressions import Expression, Quotient, Sum, Symbol
from sim2reason.solutions.algebra.functions import Absolute
from sim2reason.solutions.algebra.inverse import put
from sim2reason.solutions.closed_forms.closed_form import (
    ClosedForm,
    ClosedFormError,
    Substitution,
    definitions,
    shortened,
)
from sim2reason.solutions.closed_forms.tidying import tidied
from sim2reason.solutions.setting import joined
from sim2reason.solutions.solution import SAME, Relation, Solution, Step

MOST, LONG = 4, 120  # quantities that are told; characters of a formula that no longer helps
LONGEST = 240  # characters of a formula that is written before it is simplified
SHORTER = 0.9  # of its characters: a formula that was simplified, not only written in another order


def with_ingredients(solution: Solution) -> Solution:
    """Return a solution in symbols with a last step that leads to the formula of the answer.

    It says what the quantities on the way come to in terms of what is given, and which are inserted into the last
    formula. Those that are given, that one formula gives in terms of what is given, or that the text has, are not
    repeated.
    """
    algebra = _LastAlgebra(solution)
    relations, insertion, inserted = algebra.told, *algebra.insertion()
    if not relations and not insertion:
        return solution
    used = {name for relation in (*relations, *inserted) for name in relation.left.symbols()}
    text = f"In terms of the given quantities, {joined([held.latex() for held in relations])}." if relations else ""
    needs = tuple(step.id for step in solution.steps if used.intersection(step.gives))
    step = Step(
        len(solution.steps),
        "ingredients",
        " ".join(filter(None, (text, insertion))),
        (*relations, *inserted),
        (),
        needs,
        solution.steps[-1].phase,
    )
    return replace(solution, steps=(*solution.steps, step))


@dataclass(frozen=True)
class _LastAlgebra:
    """The quantities between what is given and the answer, and their formulas."""

    solution: Solution

    @cached_property
    def _formulas(self) -> Mapping[str, Expression]:
        return definitions(self.solution)

    @cached_property
    def _given(self) -> set[str]:
        given = {relation.left.latex() for relation in self.solution.relations if relation.role == "given"}
        return given - self.solution.constants.keys()

    @cached_property
    def _said(self) -> str:
        return " ".join(step.text for step in self.solution.steps)

    @cached_property
    def _put_in(self) -> Substitution:
        return Substitution(self._formulas, {name: name for name in self._given})

    @cached_property
    def _whole(self) -> str:
        """Return the goal's symbol, or the one whose modulus or negative the goal is."""
        whole = self.solution.goal
        while (inner := _inside(self._formulas[whole])) in self._formulas and inner not in self._given:
            whole = inner
        return whole

    def _parts(self, name: str) -> list[str]:
        """Return the names in a formula that the solution defines itself."""
        names = dict.fromkeys(self._formulas[name].symbols())
        return [other for other in names if other in self._formulas and other not in self._given]

    @cached_property
    def told(self) -> list[Relation]:
        """Return equations that give intermediate quantities by given ones, such as a = F/m; of many, the last ones."""
        last = [*self._last()]
        whole = last if any(not isinstance(held, Symbol) for held in last) else [*map(Symbol, self._on_the_way())]
        relations = [*self._in_given(whole)]
        return relations if len(relations) <= MOST else [*self._in_given(last)][:MOST]

    def _last(self) -> Iterator[Expression]:
        """Yield what the last formula with more than one name that the solution defines itself is made of."""
        whole, names = self._whole, self._parts(self._whole)
        while len(names) == 1 and (deeper := self._parts(names[0])):
            whole, names = names[0], deeper
        yield from _summands(self._formulas[whole], names) or [Symbol(name) for name in names]

    def _on_the_way(self) -> list[str]:
        """Return the names on which the formula of the answer hangs, in the order in which they are defined.

        Names behind one that the text has in terms of given quantities are left out.
        """
        found, waiting = set[str](), [self._whole]
        while waiting:
            name = waiting.pop()
            if name != self._whole and self._is_said(name):
                continue
            new = {*self._parts(name)} - found
            found |= new
            waiting += new
        return [name for name in self._formulas if name in found]

    def _in_given(self, parts: Sequence[Expression]) -> Iterator[Relation]:
        """Yield the formulas of quantities that the text does not have yet."""
        for part in parts:
            if isinstance(part, Symbol) and self._is_plain(part.name):
                continue
            found = self._closed(part)
            if found is None or len(found.latex) > LONG:
                continue
            relation = Relation(part, found.expression, "derived")
            if relation.latex() not in self._said and self._holds(relation):
                yield relation

    def _is_said(self, name: str) -> bool:
        """Return whether the text contains a quantity in terms of given ones."""
        found = self._closed(Symbol(name))
        return found is not None and Relation(Symbol(name), found.expression, "derived").latex() in self._said

    def _is_plain(self, name: str) -> bool:
        """Return whether one formula gives a quantity in terms of what is given, or of constants."""
        known = self._formulas[name].symbols()
        return all(other in self._given or not {*self._formulas[other].symbols()} for other in known)

    def _closed(self, part: Expression) -> ClosedForm | None:
        try:
            return shortened(self._put_in.of(part))
        except ClosedFormError:
            return None

    def _holds(self, relation: Relation) -> bool:
        values = self.solution.values
        if not {*relation.symbols()} <= values.keys():
            return True
        left, right = (side.value(values).real for side in (relation.left, relation.right))
        return isclose(left, right, rel_tol=SAME)

    def insertion(self) -> tuple[str, list[Relation]]:
        """Return which quantities are inserted into the last formula, and that formula before it is simplified."""
        names = self._parts(self._whole)
        closed = {name: found for name in names if (found := self._closed(Symbol(name))) is not None}
        if not names or len(closed) < len(names):
            return "", []
        inserted = self._formulas[self._whole]
        for name, found in closed.items():
            inserted = put(inserted, name, found.expression)
        relation = Relation(Symbol(self._whole), tidied(inserted), "derived")
        simple, size = self._simplified(), len(relation.right.latex())
        if not simple or len(simple) > SHORTER * size or relation.latex() in self._said or not self._holds(relation):
            return "", []
        lead = f"Inserting {joined([f'${name}$' for name in names])} into the formula for ${self._whole}$"
        end = "the result" if self._whole == self.solution.goal else f"${simple}$"
        if size > LONGEST:
            return f"{lead} and simplifying gives {end}.", []
        return f"{lead} gives {relation.latex()}, which simplifies to {end}.", [relation]

    def _simplified(self) -> str:
        """Return what the last formula comes to in the end, in LaTeX."""
        if self._whole == self.solution.goal:
            return self.solution.formula
        found = self._closed(Symbol(self._whole))
        return found.latex if found is not None else ""


def _inside(held: Expression) -> str:
    """Return the name of which a formula is the modulus or the negative, or which it is; empty for any other."""
    inner = held.inside if isinstance(held, Absolute) else -held if held.negative else held
    return inner.name if isinstance(inner, Symbol) else ""


def _summands(formula: Expression, names: Sequence[str]) -> list[Expression]:
    """Return the denominator of a fraction if it is a sum of exactly the quantities to be told; else nothing."""
    below = formula.below if isinstance(formula, Quotient) else formula
    alone = isinstance(below, Sum) and isinstance(formula, Quotient) and [*below.symbols()] == [*names]
    return [below] if alone else []
