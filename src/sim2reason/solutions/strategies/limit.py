"""Limit: the leading terms of the answer as one mass grows without bound or vanishes."""

from sim2reason.questions.kinds.limit import LimitKind, LimitQuery
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.asymptotics import CancelledError, limit
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.closed_forms import ClosedFormError, simplified_form
from sim2reason.solutions.laws.nested import inner_setting, inserted, lone_symbol, short_formula, write_inner_answer
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, deriving_strategies, strategy
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError


@strategy
class Limit(Strategy):
    """The strategy that keeps the dominant power of a mass that grows without bound or vanishes."""

    name = "limit"
    cost = 1.0
    kinds = frozenset({"limit"})
    nested = True

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: ``limit`` if the formula before the limit is known."""
        return self.kinds if any(deriving_strategies(kind, mechanism) for kind in LimitKind.inner) else frozenset()

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        if not isinstance(setting.query, LimitQuery):
            return "no limit is asked for"
        inner = inner_setting(setting)
        offered = any(
            not held.why_not_applicable(inner) for held in deriving_strategies(inner.query.kind, inner.mechanism)
        )
        return "" if offered else f"no formula for the kind {inner.query.kind}"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the formula and its limit, and return the symbol of the limit."""
        query = setting.query
        assert isinstance(query, LimitQuery)
        symbol, inner = lone_symbol(setting, query.path), inner_setting(setting)
        goal = write_inner_answer(inner, book, deriving_strategies(inner.query.kind, inner.mechanism))
        whole = short_formula(inner, book, goal)
        if whole is None or symbol not in whole.symbols():
            raise UnsolvedError("the formula for it is too long, or does not hang on that mass")
        try:
            left = limit(whole, symbol, book.values, large=query.large)
            found = simplified_form(left).expression if left is not None else None
        except (CancelledError, TypeError, ClosedFormError) as error:
            raise UnsolvedError(str(error)) from error
        if found is None:
            raise UnsolvedError("it vanishes, or grows without bound")
        step, end = book.begin_step("limit"), r"\infty" if query.large else "0"
        step.rest_on(goal)
        which = "highest" if query.large else "lowest"
        name = book.fresh(goal, end)
        step.add_text(inserted(book, goal, step.derived(Symbol(goal), whole)))
        step.add_text(
            f"For ${symbol} \\to {end}$ only the terms with the {which} power of ${symbol}$ are left in each sum:"
        )
        step.add_text(f"{step.result(name, found, book.units.get(goal, ''), law=True)}.")
        step.close()
        return name.name
