"""Which of two: the values of two bodies or events, and their difference or ratio, show which is first or greater."""

from dataclasses import replace

from sim2reason.questions import KINDS, Query
from sim2reason.questions.kinds.nested import WhichKind, WhichQuery
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.multipart.one_text import enter, merge_into_one_text
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.solution import Solution
from sim2reason.solutions.solve import solve
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.writing.comparing import record_inequality
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError


@strategy
class WhichOfTwo(Strategy):
    """The strategy that solves two queries in one text and states which value is reached first or is greater."""

    name = "which of two"
    cost = 1.0
    kinds = frozenset({"which_first", "which_greater"})
    nested = True
    finished = True

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: none, as a choice between two has no formula."""
        del mechanism
        return frozenset()

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        if not isinstance(setting.query, WhichQuery):
            return "it asks for none of two"
        found = KINDS[setting.query.kind].answer(setting.query, setting.study)
        return "" if found is not None and found > 0.0 else "the first of the two is not the one"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write both answers in the shorter order and the comparison, and return the answer's symbol."""
        query = setting.query
        assert isinstance(query, WhichQuery)
        settings = [_inner(each, setting) for each in sorted(query.both, key=lambda each: (each.subject, repr(each)))]
        pairs = [(each, _solved(each)) for each in settings]
        orders = [merge_into_one_text(*zip(*order, strict=True)) for order in (pairs, pairs[::-1])]
        told = [(parts, steps) for parts, steps in orders if steps]
        if not told:
            raise UnsolvedError(orders[0][0][0].reason)
        parts, steps = min(told, key=lambda each: sum(len(step.text.split()) for step in each[1]))
        for part in parts:
            enter(part, book)
        book.rewrite(0, steps)
        book.phases = [*max((part.phases for part in parts), key=len)]
        asked = [each.query for each in settings]
        goals = dict(zip(asked if parts is orders[0][0] else asked[::-1], parts, strict=True))
        return _concluded(query, setting, book, *(Symbol(goals[each].goal) for each in query.both))


def _inner(query: Query, setting: ProblemContext) -> ProblemContext:
    return replace(setting, query=query, unknown="", stated=None, sought=None)


def _solved(inner: ProblemContext) -> Solution:
    found = solve(inner, checked=False)
    if found.answer is None or not found.derived:
        raise UnsolvedError(found.reason or "only an integration leads to it")
    return found


def _concluded(query: WhichQuery, setting: ProblemContext, book: SolutionBuilder, one: Symbol, other: Symbol) -> str:
    """Write which of the two is first or greater, and return the symbol of the difference or ratio."""
    kind = KINDS[query.kind]
    assert isinstance(kind, WhichKind)
    greater, less = (other, one) if kind.is_least else (one, other)
    step = book.begin_step("comparison")
    record_inequality(book, step, greater, less)
    formula, unit = (greater - less, book.units[one.name]) if kind.is_least else (greater / less, "")
    goal = book.fresh(r"\tau" if kind.is_least else "r")
    number = step.result(goal, formula, unit, law=True)
    said = f"${less.latex()} < {greater.latex()}$" if kind.is_least else f"${greater.latex()} > {less.latex()}$"
    step.add_text(f"Since {said}, {kind.conclusion(query, setting.words)} {number}.")
    step.close()
    return goal.name
