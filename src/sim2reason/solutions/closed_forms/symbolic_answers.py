"""Symbolic answers: intermediate quantities and their substitution, and signs that depend on the symbols."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import isclose

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.grading.formula import compile_formula
from sim2reason.questions.regimes.directions import MovesOneWay
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Quotient, Sum, Symbol
from sim2reason.solutions.algebra.functions import Absolute
from sim2reason.solutions.algebra.root_finding import substitute
from sim2reason.solutions.closed_forms import (
    ClosedForm,
    ClosedFormError,
    Substitution,
    defined_by,
    definitions,
    simplified_form,
)
from sim2reason.solutions.closed_forms.tidying import tidy
from sim2reason.solutions.setting import ProblemContext, join_words
from sim2reason.solutions.solution import ANSWER_RTOL, Relation, Solution, Step
from sim2reason.solutions.writing.steps import SolutionBuilder

MAX_QUANTITIES, MAX_FORMULA_LENGTH = (
    4,
    120,
)  # most quantities that are stated; characters of the longest of their formulas
MAX_INSERTED_LENGTH = 240  # characters of a formula that is written before it is simplified, at most
SIMPLIFIED_RATIO = 0.9  # of its characters: only a shorter result counts as simplified


def with_final_algebra(solution: Solution) -> Solution:
    """Return a symbolic solution with a final step that leads to the formula of the answer.

    The step gives intermediate quantities in terms of given ones, and names those inserted into the last formula. It
    omits quantities that are given, that a single formula gives in terms of given ones, or that the text contains.
    """
    algebra = _FinalAlgebra(solution)
    relations, insertion, inserted = algebra.intermediate_relations, *algebra.insertion()
    if not relations and not insertion:
        return solution
    used = {name for relation in (*relations, *inserted) for name in relation.left.symbols()}
    text = (
        f"In terms of the given quantities, {join_words([equation.latex() for equation in relations])}."
        if relations
        else ""
    )
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
class _FinalAlgebra:
    """The intermediate quantities of a solution, between the given ones and the answer, and their formulas."""

    solution: Solution

    @cached_property
    def _formulas(self) -> Mapping[str, Expression]:
        return definitions(self.solution)

    @cached_property
    def _given(self) -> set[str]:
        given = {relation.left.latex() for relation in self.solution.relations if relation.role == "given"}
        return given - self.solution.constants.keys()

    @cached_property
    def _solution_text(self) -> str:
        return " ".join(step.text for step in self.solution.steps)

    @cached_property
    def _put_in(self) -> Substitution:
        return Substitution(self._formulas, {name: name for name in self._given})

    @cached_property
    def _whole(self) -> str:
        """Return the symbol of the goal, or of the quantity whose absolute value, negative or copy is the goal."""
        symbol = self.solution.goal
        while (inner := _inside(self._formulas[symbol])) in self._formulas and inner not in self._given:
            symbol = inner
        return symbol

    def _parts(self, name: str) -> list[str]:
        """Return the symbols in the formula of a quantity that are themselves derived, not given."""
        names = dict.fromkeys(self._formulas[name].symbols())
        return [other for other in names if other in self._formulas and other not in self._given]

    @cached_property
    def intermediate_relations(self) -> list[Relation]:
        """Return equations of intermediate quantities in given ones, such as a = F/m; of many, the last ones."""
        last = [*self._last()]
        quantities = (
            last
            if any(not isinstance(expression, Symbol) for expression in last)
            else [*map(Symbol, self._on_the_way())]
        )
        relations = [*self._in_given(quantities)]
        return relations if len(relations) <= MAX_QUANTITIES else [*self._in_given(last)][:MAX_QUANTITIES]

    def _last(self) -> Iterator[Expression]:
        """Yield derived quantities in the answer's last formula with several; their sum if it is the denominator."""
        symbol, names = self._whole, self._parts(self._whole)
        while len(names) == 1 and (deeper := self._parts(names[0])):
            symbol, names = names[0], deeper
        yield from _summands(self._formulas[symbol], names) or [Symbol(name) for name in names]

    def _on_the_way(self) -> list[str]:
        """Return the symbols of quantities on which the answer depends, in order of definition.

        The search stops at names that the text gives in terms of given quantities.
        """
        visited, waiting = set[str](), [self._whole]
        while waiting:
            name = waiting.pop()
            if name != self._whole and self._is_said(name):
                continue
            new = {*self._parts(name)} - visited
            visited |= new
            waiting += new
        return [name for name in self._formulas if name in visited]

    def _in_given(self, parts: Sequence[Expression]) -> Iterator[Relation]:
        """Yield equations, not yet in the text, that give quantities in terms of given quantities."""
        for part in parts:
            if isinstance(part, Symbol) and self._is_plain(part.name):
                continue
            closed_form = self._closed(part)
            if closed_form is None or len(closed_form.latex) > MAX_FORMULA_LENGTH:
                continue
            relation = Relation(part, closed_form.expression, "derived")
            if relation.latex() not in self._solution_text and self._holds(relation):
                yield relation

    def _is_said(self, name: str) -> bool:
        """Return whether the text contains the formula of a quantity in given ones."""
        closed_form = self._closed(Symbol(name))
        return (
            closed_form is not None
            and Relation(Symbol(name), closed_form.expression, "derived").latex() in self._solution_text
        )

    def _is_plain(self, name: str) -> bool:
        """Return whether a single formula gives a quantity in given quantities and constants."""
        known = self._formulas[name].symbols()
        return all(other in self._given or not {*self._formulas[other].symbols()} for other in known)

    def _closed(self, part: Expression) -> ClosedForm | None:
        """Return the closed form of a formula in terms of given quantities; None if it has none."""
        try:
            return simplified_form(self._put_in.substitute(part))
        except ClosedFormError:
            return None

    def _holds(self, relation: Relation) -> bool:
        """Return whether a relation holds for the values of the solution."""
        values = self.solution.values
        if not {*relation.symbols()} <= values.keys():
            return True
        left, right = (side.value(values).real for side in (relation.left, relation.right))
        return isclose(left, right, rel_tol=ANSWER_RTOL)

    def insertion(self) -> tuple[str, list[Relation]]:
        """Return a sentence that inserts quantities into the last formula, and the resulting equation in a list."""
        names = self._parts(self._whole)
        closed = {name: closed_form for name in names if (closed_form := self._closed(Symbol(name))) is not None}
        if not names or len(closed) < len(names):
            return "", []
        inserted = self._formulas[self._whole]
        for name, closed_form in closed.items():
            inserted = substitute(inserted, name, closed_form.expression)
        relation = Relation(Symbol(self._whole), tidy(inserted), "derived")
        simple, size = self._simplified(), len(relation.right.latex())
        if (
            not simple
            or len(simple) > SIMPLIFIED_RATIO * size
            or relation.latex() in self._solution_text
            or not self._holds(relation)
        ):
            return "", []
        lead = f"Inserting {join_words([f'${name}$' for name in names])} into the formula for ${self._whole}$"
        end = "the result" if self._whole == self.solution.goal else f"${simple}$"
        if size > MAX_INSERTED_LENGTH:
            return f"{lead} and simplifying gives {end}.", []
        return f"{lead} gives {relation.latex()}, which simplifies to {end}.", [relation]

    def _simplified(self) -> str:
        """Return the simplified last formula in LaTeX; empty if there is none."""
        if self._whole == self.solution.goal:
            return self.solution.formula
        closed_form = self._closed(Symbol(self._whole))
        return closed_form.latex if closed_form is not None else ""


def _inside(expression: Expression) -> str:
    """Return the name of which a formula is the absolute value, the negative or a copy; empty for other formulas."""
    inner = (
        expression.inside if isinstance(expression, Absolute) else -expression if expression.negative else expression
    )
    return inner.name if isinstance(inner, Symbol) else ""


def _summands(formula: Expression, names: Sequence[str]) -> list[Expression]:
    """Return the denominator of a fraction if it is a sum of exactly the given names; else an empty list."""
    below = formula.below if isinstance(formula, Quotient) else formula
    alone = isinstance(below, Sum) and isinstance(formula, Quotient) and [*below.symbols()] == [*names]
    return [below] if alone else []


SAMPLES = 40
BAR = r"\left|"
FACTOR_DECADES = 1.0  # random factors range over this many decades up and down


def has_either_sign(
    setting: ProblemContext, book: SolutionBuilder, quantity: Expression, bodies: Collection[str]
) -> bool:
    """Return whether the numbers decide the sign of a symbolic quantity, for bodies without an assumed direction."""
    if not book.in_symbols or any(isinstance(each, MovesOneWay) and each.name in bodies for each in setting.assumed):
        return False
    return len({positive for positive, _ in _signs(setting, book, quantity)}) > 1


def acceleration_over_distance(
    setting: ProblemContext, book: SolutionBuilder, begun: Expression, a: Symbol, bodies: Sequence[str]
) -> tuple[Expression, str]:
    """Return the acceleration for d = ½ a t², or its magnitude for motion either way, and a clause with the reason.

    The magnitude is returned for bodies that may start in either direction, unless an assumption excludes one.
    """
    if begun != ZERO or not has_either_sign(setting, book, a, bodies):
        return a, ""
    if book.value(a) > 0.0 and _is_assumed_positive(setting, book, a):
        return a, f", as ${a.latex()} > 0$ under the assumption made"
    return Absolute(a), f", whichever way {setting.display_name(bodies[0])} moves"


def needs_modulus(setting: ProblemContext, book: SolutionBuilder, quantity: Expression, body: str) -> bool:
    """Return whether the symbolic answer for a quantity of either sign is written as an absolute value."""
    return (
        setting.formula is not None
        and BAR in setting.formula.latex
        and has_either_sign(setting, book, quantity, [body])
    )


def reason_for_negative(setting: ProblemContext, book: SolutionBuilder, quantity: Expression, body: str) -> str:
    """Return a clause that a quantity is negative; empty for a numerical answer or an absolute value."""
    if not book.in_symbols or setting.formula is None or BAR in setting.formula.latex:
        return ""
    why = " under the assumption made" if has_either_sign(setting, book, quantity, [body]) else ""
    return f"${quantity.latex()}$ is negative{why}"


def _is_assumed_positive(setting: ProblemContext, book: SolutionBuilder, quantity: Expression) -> bool:
    """Return whether the answer is negative or undefined for all sampled numbers for which a quantity is negative.

    An answer that holds under an assumption is positive, so this quantity is positive under that assumption.
    """
    if not setting.assumed or setting.formula is None:
        return False
    try:
        answer = compile_formula(setting.formula.latex, setting.formula.symbols)
        values = [answer.value(at) for positive, at in _signs(setting, book, quantity) if not positive]
    except (KeyError, ValueError):  # contains a number defined later
        return False
    return all(value is None or value < 0.0 for value in values)


def _signs(
    setting: ProblemContext, book: SolutionBuilder, quantity: Expression
) -> Iterator[tuple[bool, Mapping[str, float]]]:
    """Yield whether a quantity is positive for one random set of the given numbers, with these numbers by symbol."""
    formulas = defined_by(book.steps)
    angles = {given.symbol for given in setting.lexicon.givens.values() if given.angle}
    random = np.random.default_rng(0)
    for _ in range(SAMPLES):
        at = {
            name: random.uniform(0.1, 1.5)
            if name in angles
            else value * 10.0 ** random.uniform(-FACTOR_DECADES, FACTOR_DECADES)
            for name, value in book.values.items()
            if name not in formulas
        }
        try:
            for name, formula in formulas.items():
                at[name] = float(formula.value(at).real)
            yield float(quantity.value(at).real) > 0.0, at
        except (KeyError, ValueError, ArithmeticError):  # no motion with these numbers
            continue
