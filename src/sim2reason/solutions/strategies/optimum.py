"""Optimum: the answer as a function of a free parameter, and the zero of its derivative."""

from sim2reason.questions.kinds.optimum import OptimumKind, OptimumQuery
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.closed_roots import fraction
from sim2reason.solutions.algebra.derivatives import derivative
from sim2reason.solutions.algebra.expressions import (
    ZERO,
    Expression,
    Product,
    Quotient,
    Symbol,
)
from sim2reason.solutions.algebra.functions import Root
from sim2reason.solutions.closed_forms import ClosedFormError, simplified_form
from sim2reason.solutions.laws.nested import (
    inner_setting,
    inserted,
    lone_symbol,
    short_formula,
    with_changed_scene,
    write_inner_answer,
)
from sim2reason.solutions.reverse import Inversion
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, deriving_strategies, strategy
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

MAX_NUMERATOR_LENGTH = 200  # maximum length of the LaTeX of the numerator of a derivative


@strategy
class Optimum(Strategy):
    """The strategy for the parameter value at which an answer is greatest or least."""

    name = "optimum"
    cost = 1.0
    kinds = frozenset({"optimum"})
    nested = True

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: those of optima if the optimised quantity has one."""
        return self.kinds if any(deriving_strategies(kind, mechanism) for kind in OptimumKind.inner) else frozenset()

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        query = setting.query
        if not isinstance(query, OptimumQuery) or setting.sought is None:
            return "there is no such value"
        inner = inner_setting(setting)
        offered = any(
            not held.why_not_applicable(inner) for held in deriving_strategies(inner.query.kind, inner.mechanism)
        )
        return "" if offered else f"no formula for the kind {inner.query.kind}"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the formula, its derivative, the optimal parameter and, if asked for, the extreme value."""
        query = setting.query
        assert isinstance(query, OptimumQuery)
        symbol, inner = lone_symbol(setting, query.path), inner_setting(setting)
        place = query.place(setting.study)
        there = setting.study.with_same_change({query.path: place}) if place is not None else None
        if there is None:
            raise UnsolvedError("there is no motion with that value")
        inner = with_changed_scene(inner, there, query.path, symbol)
        goal = write_inner_answer(inner, book, deriving_strategies(inner.query.kind, inner.mechanism))
        whole = short_formula(inner, book, goal)
        if whole is None or symbol not in whole.symbols():
            raise UnsolvedError("the formula for it is too long")
        _stationary(book, query, goal, whole, symbol)
        if query.asks_place:
            return symbol
        extreme = book.fresh(goal, r"\text{max}" if query.greatest else r"\text{min}")
        step = book.begin_step("extreme value")
        step.rest_on(symbol)
        step.add_text(f"With this value, {step.result(extreme, whole, book.units.get(goal, ''), law=True)}.")
        step.close()
        return extreme.name


def _stationary(book: SolutionBuilder, query: OptimumQuery, goal: str, whole: Expression, symbol: str) -> None:
    """Write the value of a symbol at which a formula is greatest or least."""
    core, turned = _core(whole, symbol)
    greatest = query.greatest is not turned
    try:
        slope = _numerator(derivative(core, symbol))
    except TypeError as error:
        raise UnsolvedError(str(error)) from error
    step, name = book.begin_step("derivative"), book.fresh("D")
    step.rest_on(goal)
    step.add_text(inserted(book, goal, step.derived(Symbol(goal), whole)))
    said = rf"\frac{{\mathrm{{d}}}}{{\mathrm{{d}} {symbol}}} \left({core.latex()}\right)"
    extreme = "greatest" if query.greatest else "least"
    where = "" if core == whole else f", just where ${core.latex()}$ is {'greatest' if greatest else 'least'}"
    step.add_text(f"It is {extreme}{where}. There the derivative ${said}$ vanishes; but for a factor that does not")
    step.add_text(f"vanish, it is {step.result(name, slope, '', law=True)}, so that {step.law(name, ZERO)}.")
    step.close()
    Inversion(book, name.name, 0.0, symbol).write()


def _core(held: Expression, symbol: str) -> tuple[Expression, bool]:
    """Return the part of a positive formula with the same extrema in a symbol, and whether maxima become minima."""
    match held:
        case Root():
            return _core(held.inside, symbol)
        case Product():
            kept = [factor for factor in held.factors if symbol in factor.symbols()]
            if len(kept) == 1:
                return _core(kept[0], symbol)
        case Quotient() if symbol not in held.below.symbols():
            return _core(held.above, symbol)
        case Quotient() if symbol not in held.above.symbols():
            found, turned = _core(held.below, symbol)
            return found, not turned
        case _:
            pass
    return held, False


def _numerator(slope: Expression) -> Expression:
    """Return the numerator of a derivative; raise UnsolvedError if it is too long."""
    try:
        found = simplified_form(fraction(slope).above.factored()).expression
    except (OverflowError, ClosedFormError) as error:
        raise UnsolvedError("its derivative is too long") from error
    if isinstance(found, Quotient):
        found = found.above
    if len(found.latex()) > MAX_NUMERATOR_LENGTH:
        raise UnsolvedError("its derivative is too long")
    return found
