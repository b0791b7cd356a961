"""Comparison: the answers for two values of a parameter, and their ratio or difference."""

from collections.abc import Sequence

from sim2reason.questions.kinds.comparison import ComparisonQuery
from sim2reason.questions.kinds.nested import INNER, usable_answer
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.laws.nested import (
    NEW,
    in_formula_units,
    inner_setting,
    lone_symbol,
    with_changed_scene,
    with_other_value,
    write_inner_answer,
)
from sim2reason.solutions.laws.second_case import reuse_first_case, shorten_second_case, verify_again
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, closed_form_strategies, deriving_strategies, strategy
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError
from sim2reason.solutions.writing.subscripts import with_subscript

ANSWER_RTOL = 1e-6  # relative tolerance of the formula to the engine's answer for the other value
WORDS = {2.0: "doubled", 0.5: "halved", 3.0: "tripled"}


@strategy
class Comparison(Strategy):
    """The strategy that evaluates one formula for two values of a parameter and compares the results."""

    name = "comparison"
    cost = 1.0
    kinds = frozenset({"comparison"})
    nested = True

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: ``comparison`` if the compared question has one."""
        return self.kinds if any(deriving_strategies(kind, mechanism) for kind in INNER) else frozenset()

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        if not isinstance(setting.query, ComparisonQuery):
            return "it compares nothing"
        inner = inner_setting(setting)
        offered = any(not held.why_not_applicable(inner) for held in _deriving(inner))
        return "" if offered else f"no formula for the kind {inner.query.kind}"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the formula of the answer, its value with the changed parameter, and their ratio or difference."""
        query = setting.query
        assert isinstance(query, ComparisonQuery)
        symbol, inner = lone_symbol(setting, query.path), inner_setting(setting)
        goal = write_inner_answer(inner, book, _deriving(inner))
        changed = Number(query.factor) * Symbol(symbol)
        lead = f"With ${symbol}$ {WORDS[query.factor]}"
        verify_again(book, symbol, changed, lead)
        after = with_other_value(inner, book, goal, symbol, changed, lead)
        unit, found = book.units.get(goal, ""), book.values[after.name]
        wanted = usable_answer(query.inner, query.changed(setting.study))
        if wanted is None or abs(found - in_formula_units(wanted, unit)) > ANSWER_RTOL * abs(found):
            raise UnsolvedError("with the other value the formula is another one")
        return compared(book, query, goal, after.name)


@strategy
class TwoCases(Strategy):
    """The strategy that solves the question for two values of a parameter in turn and compares the answers."""

    name = "comparison of two cases"
    cost = 2.0
    kinds = frozenset({"comparison"})
    nested = True

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: none, since two cases are solved separately."""
        del mechanism
        return frozenset()

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        if not isinstance(setting.query, ComparisonQuery):
            return "it compares nothing"
        return "" if setting.query.changed(setting.study) is not None else "there is no motion with the other value"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the solutions for the given and the changed parameter, and the ratio or difference of the answers."""
        query = setting.query
        assert isinstance(query, ComparisonQuery)
        changed, symbol, inner = query.changed(setting.study), lone_symbol(setting, query.path), inner_setting(setting)
        assert changed is not None
        goal = write_inner_answer(inner, book, _closed(inner))
        step, new = book.begin_step("other value"), Symbol(with_subscript(symbol, NEW))
        unit = setting.lexicon.givens[query.path].counted_unit
        becomes = step.result(new, Number(query.factor) * Symbol(symbol), unit, law=True)
        step.add_text(f"With ${symbol}$ {WORDS[query.factor]}, {becomes}.")
        step.close()
        other, begun = with_changed_scene(inner, changed, query.path, new.name), len(book.steps)
        checks, stated, late = {**book.checks}, {*book.stated}, len(book.afterwards)
        after = write_inner_answer(other, book, _closed(other))
        book.checks = checks  # strings are told to stay taut in the first case alone
        if len(book.afterwards) == late:  # what is written in the end has names of its own
            after = reuse_first_case(book, begun, stated).get(after, after)
        shorten_second_case(book, begun, {new.name: symbol})
        return compared(book, query, goal, after)


def compared(book: SolutionBuilder, query: ComparisonQuery, before: str, after: str) -> str:
    """Write the ratio or the difference of two results and return its symbol."""
    old, new = Symbol(before), Symbol(after)
    if query.ratio:
        return book.add_step(
            "comparison", "The ratio of the new value to the original one is", book.fresh("r"), new / old
        ).name
    greater, less = (new, old) if query.grows else (old, new)
    unit = book.units.get(before, "")
    return book.add_step("comparison", "The difference is", book.fresh(r"\Delta"), greater - less, unit).name


def _deriving(inner: ProblemContext) -> Sequence[Strategy]:
    """Return the strategies that may derive a formula for the question that is compared."""
    return deriving_strategies(inner.query.kind, inner.mechanism)


def _closed(inner: ProblemContext) -> Sequence[Strategy]:
    """Return the strategies that answer the compared question without integration, those of lowest cost first."""
    return [held for held in closed_form_strategies(inner.query.kind, inner.mechanism) if not held.nested]
