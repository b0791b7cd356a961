"""Answers to inner questions, derived by the strategies that give a formula."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import reduce
from math import radians
from typing import Protocol

from sim2reason.questions import SimulatedScene
from sim2reason.questions.kinds.nested import NestedQuery
from sim2reason.solutions.algebra.evaluated import NumericFormula
from sim2reason.solutions.algebra.expressions import Expression, Number, Product, Symbol, multiply_factors
from sim2reason.solutions.algebra.functions import Power, simplify_inverse
from sim2reason.solutions.algebra.root_finding import substitute, substitute_all
from sim2reason.solutions.algebra.rounded_numbers import simple_fraction
from sim2reason.solutions.closed_forms import ClosedFormError, combined_formula, defined_by, simplified_form
from sim2reason.solutions.closed_forms.tidying import tidy
from sim2reason.solutions.setting import ProblemContext, join_words
from sim2reason.solutions.solution import Relation, Solution, Step
from sim2reason.solutions.writing.lexicon import UnreadError
from sim2reason.solutions.writing.notation import DEGREES, with_subscript
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder, UnsolvedError, record_inequality

MAX_WRITTEN_LENGTH = 200  # characters: longer formulas are checked, but not written
MAX_SUBSTITUTED_LENGTH = 1000  # characters: no substitution into longer formulas

NEW_SUBSCRIPT = r"\text{new}"
REPEATED_CHECK_PREFIX = "still holds"  # begins the labels of comparisons that also hold for another value of a number
MAX_SHORTENED_LENGTH = 200  # characters: longer formulas hardly become short
MAX_INSERTION_LENGTH = 130  # characters of a formula into which another value is substituted, at most


class AnswerStrategy(Protocol):
    """The part of a strategy's interface that derives the answer to a question nested in another question."""

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        ...

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write all steps and return the symbol of the answer."""
        ...


def inner_setting(setting: ProblemContext) -> ProblemContext:
    """Return the problem of the inner question, which is nested in the question, about the same scene."""
    assert isinstance(setting.query, NestedQuery)
    return replace(setting, query=setting.query.inner, unknown="", stated=None, sought=None)


def write_inner_answer(inner: ProblemContext, book: SolutionBuilder, offered: Iterable[AnswerStrategy]) -> str:
    """Write the answer to a nested question by the first strategy that succeeds; return the answer's symbol.

    Raises:
        UnsolvedError: no strategy succeeds.
    """
    reasons = ["no strategy has a way to what is asked about"]
    for strategy in offered:
        if strategy.why_not_applicable(inner):
            continue
        saved = book.saved()
        try:
            return strategy.write(inner, book)
        except (UnsolvedError, UnreadError) as error:
            reasons.append(str(error))
            vars(book).update(saved)
    raise UnsolvedError(reasons[-1])


def with_changed_scene(inner: ProblemContext, changed: SimulatedScene, path: str, symbol: str) -> ProblemContext:
    """Return the nested question about a scene with another value of one number, which gets its own symbol."""
    words = replace(inner.words, mechanism=changed.mechanism)
    symbols = {**inner.symbols, path: symbol}
    return replace(inner, scene=changed.scene, study=changed, words=words, symbols=symbols)


def with_other_value(
    inner: ProblemContext, book: SolutionBuilder, goal: str, symbol: str, changed: Expression, lead: str
) -> Symbol:
    """Write a known result with a symbol replaced by the expression `changed`; return the new result's name.

    If all steps combine to a short formula, that formula is used; else each step is repeated.
    """
    goal_formula = short_formula(inner, book, goal)
    other = tidy(_put(goal_formula, {symbol: changed})) if goal_formula is not None else None
    step = book.begin_step("other value")
    for label in (
        goal,
        *(name for earlier_step in book.steps for name in earlier_step.gives if name.startswith(REPEATED_CHECK_PREFIX)),
    ):
        step.rest_on(label)
    if goal_formula is not None and other is not None and len(other.latex()) <= MAX_INSERTION_LENGTH:
        after = book.fresh(goal, NEW_SUBSCRIPT)
        step.add_text(insertion_sentence(book, goal, step.derived(Symbol(goal), goal_formula)))
        step.add_text(f"{lead}, this becomes {step.result(after, other, book.units.get(goal, ''), law=True)}.")
    else:
        equations: list[str] = []
        renamed: dict[str, Expression] = {symbol: changed}
        for name, formula in _leading(book, goal):
            if renamed.keys().isdisjoint(formula.symbols()):
                continue
            if _is_in_numbers(formula):
                raise UnsolvedError("the equations on the way were solved in numbers")
            after = book.fresh(name, NEW_SUBSCRIPT)
            equations.append(step.result(after, _put(formula, renamed), book.units.get(name, ""), law=True))
            renamed[name] = after
        step.add_text(f"{lead}, the same equations give {join_words(equations)}.")
    step.close()
    return Symbol(book.last)


def insertion_sentence(book: SolutionBuilder, goal: str, equation: str) -> str:
    """Return the sentence that states the equation of a result after all quantities have been inserted."""
    names = [f"${name}$" for name, _ in reversed(_leading(book, goal)) if name != goal]
    lead = f"Inserting {join_words(names)} into the equation for ${goal}$ gives" if names else "In short,"
    return f"{lead} {equation}."


def short_formula(inner: ProblemContext, book: SolutionBuilder, goal: str) -> Expression | None:
    """Return the formula of a result in given quantities, if a short one exists; else None."""
    try:
        return _shortened(_whole(inner, book, goal))
    except ClosedFormError:
        return None


def _shortened(formula: Expression) -> Expression | None:
    """Return a formula in simplified form; None if the simplified form is still long."""
    if len(formula.latex()) > MAX_SHORTENED_LENGTH:
        return None
    try:
        simplified = simplified_form(formula)
    except ClosedFormError:
        return None
    return simplified.expression if len(simplified.latex) <= MAX_INSERTION_LENGTH else None


def _put(formula: Expression, renamed: Mapping[str, Expression]) -> Expression:
    """Substitute expressions for symbols; UnsolvedError if a numerical root depends on these symbols."""
    try:
        formula = substitute_all(formula, renamed)
    except TypeError as error:
        raise UnsolvedError("a root on the way was found numerically") from error
    return _multiplied_out(formula)


def _multiplied_out(formula: Expression) -> Expression:
    """Expand powers of multiples: 4 v² for (2 v)²."""
    if not formula.parts:
        return formula
    expanded = formula.built_of([_multiplied_out(part) for part in formula.parts])
    match expanded:
        case Power(Product((Number(x), *others)), exponent):
            return multiply_factors(Number(x**exponent), Power(reduce(multiply_factors, others), exponent))
        case _:
            return simplify_inverse(expanded)


def _is_in_numbers(formula: Expression) -> bool:
    """Return whether a formula contains a rounded number."""
    if isinstance(formula, NumericFormula) or (isinstance(formula, Number) and simple_fraction(formula.x) is None):
        return True
    return any(map(_is_in_numbers, formula.parts))


def _leading(book: SolutionBuilder, goal: str) -> list[tuple[str, Expression]]:
    """Return the names on which a result depends, in order of definition, with their formulas."""
    formulas = {
        relation.left.latex(): relation.right
        for step in book.steps
        for relation in step.relations
        if relation.left.latex() in step.gives and relation.role in ("result", "law")
    }
    needed, waiting = set[str](), [goal]
    while waiting:
        name = waiting.pop()
        if name in formulas and name not in needed:
            needed.add(name)
            waiting += formulas[name].symbols()
    return [(name, formula) for name, formula in formulas.items() if name in needed]


def _whole(inner: ProblemContext, book: SolutionBuilder, goal: str) -> Expression:
    """Return the formula of a result in the quantities that scene and question give."""
    stated = {given.symbol for given in inner.lexicon.givens.values()} | book.stated.keys()
    given = tuple(Relation(Symbol(name), Number(book.values[name]), "given") for name in stated if name in book.values)
    steps = (Step(-1, "givens", "", given, (), ()), *book.steps)
    return combined_formula(Solution("", steps, book.values, goal, answer=book.values[goal], constants=book.constants))


def independent_symbol(setting: ProblemContext, path: str) -> str:
    """Return the symbol of the number at an address; UnsolvedError if another number shares it."""
    given = setting.lexicon.givens.get(path)
    alike = [other for other in setting.lexicon.givens.values() if given is not None and other.symbol == given.symbol]
    if given is None or len(alike) > 1:
        raise UnsolvedError("the number has no symbol of its own")
    return given.symbol


def in_formula_units(value: float, unit: str) -> float:
    """Convert an answer to the unit of formulas: degrees to radians."""
    return radians(value) if unit == DEGREES else value


def verify_again(book: SolutionBuilder, symbol: str, changed: Expression, lead: str) -> None:
    """Write that each comparison that depends on a symbol still holds with `changed` in its place.

    Raises:
        UnsolvedError: a comparison does not hold.
    """
    formulas = {name: formula for name, formula in defined_by(book.steps).items() if name not in book.stated}
    hanging = _hanging(formulas, symbol)
    for step in [*book.steps]:
        for relation in step.relations:
            if relation.role == "exceeds" and not {symbol, *hanging}.isdisjoint(relation.symbols()):
                sides = [_changed(side, symbol, changed, hanging) for side in (relation.left, relation.right)]
                left, right = sides
                if left is not None and right is not None:
                    _verify(book, step, relation, (left, right), lead)
                else:
                    _exceeds_still(book, relation, {symbol: changed, **dict(reversed(hanging.items()))})


def _hanging(formulas: Mapping[str, Expression], symbol: str) -> dict[str, Expression]:
    """Return the formulas of names that depend on a symbol, the last defined first."""
    found: dict[str, Expression] = {}
    for name, formula in formulas.items():
        if not {symbol, *found}.isdisjoint(formula.symbols()):
            found = {name: formula, **found}
    return found


def _changed(
    side: Expression, symbol: str, changed: Expression, hanging: Mapping[str, Expression]
) -> Expression | None:
    """Return a formula with `changed` in place of a symbol, also in names that depend on it; None if it gets long."""
    for name, formula in {**hanging, symbol: changed}.items():
        side = substitute(side, name, formula)
        if len(side.latex()) > MAX_SUBSTITUTED_LENGTH:
            return None
    return side


def _exceeds_still(book: SolutionBuilder, relation: Relation, formulas: Mapping[str, Expression]) -> None:
    """Check numerically that an inequality of the solution still holds with other formulas for names.

    Raises:
        UnsolvedError: the comparison does not hold.
    """
    at = dict(book.values)
    for name, formula in formulas.items():
        at[name] = book.value(formula, at)
    if not book.value(relation.left, at) > book.value(relation.right, at):
        raise UnsolvedError(f"{relation.left.latex()} no longer exceeds {relation.right.latex()}")


def _verify(book: SolutionBuilder, step: Step, relation: Relation, sides: Sequence[Expression], lead: str) -> None:
    """Write that an inequality from an earlier step still holds for the new values of both sides."""
    writing, (left, right) = book.begin_step("verify"), sides
    record_inequality(book, writing, left, right)
    if max(len(side.latex()) for side in sides) > MAX_WRITTEN_LENGTH:
        return
    side_texts = [_write_side(writing, step, pair) for pair in ((relation.left, left), (relation.right, right))]
    writing.add_text(f"{lead}, {side_texts[0]} still exceeds {side_texts[1]}.")
    writing.label(f"{REPEATED_CHECK_PREFIX} {len(book.steps)}")
    writing.close()


def _write_side(writing: StepBuilder, step: Step, sides: tuple[Expression, Expression]) -> str:
    """Return one side of an inequality as LaTeX: its new value by a new name, or the old name if it is unchanged."""
    before, after = sides
    named = next((r for r in step.relations if r.role == "verified" and before in (r.left, r.right)), None)
    if named is None or before == after:
        return f"${(after if named is None else named.left).latex()}$"
    name = Symbol(with_subscript(named.left.latex(), NEW_SUBSCRIPT))
    return writing.verified(name, after, named.unit)
