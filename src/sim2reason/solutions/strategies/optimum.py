"""Optimum of an answer as a function of a parameter, the angle of greatest range, and the limit for a mass."""

from math import hypot, inf

from sim2reason.questions.choices import only_falls
from sim2reason.questions.kinds.limit import LimitKind, LimitQuery
from sim2reason.questions.kinds.optimum import OptimumKind, OptimumQuery
from sim2reason.questions.moments.bounces import Landed
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.closed_roots import fraction
from sim2reason.solutions.algebra.expressions import (
    ZERO,
    Expression,
    Number,
    Product,
    Quotient,
    Symbol,
)
from sim2reason.solutions.algebra.functions import Call, Power, Root
from sim2reason.solutions.algebra.transformations import CancelledError, derivative, limit
from sim2reason.solutions.closed_forms import ClosedFormError, simplified_form
from sim2reason.solutions.laws.nested import (
    independent_symbol,
    inner_setting,
    insertion_sentence,
    short_formula,
    with_changed_scene,
    write_inner_answer,
)
from sim2reason.solutions.reverse import Inversion
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, deriving_strategies, strategy
from sim2reason.solutions.writing.notation import METRES
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
            not candidate.why_not_applicable(inner)
            for candidate in deriving_strategies(inner.query.kind, inner.mechanism)
        )
        return "" if offered else f"no formula for the kind {inner.query.kind}"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the formula, its derivative, the optimal parameter and, if asked for, the extreme value."""
        query = setting.query
        assert isinstance(query, OptimumQuery)
        symbol, inner = independent_symbol(setting, query.path), inner_setting(setting)
        optimum = query.place(setting.study)
        there = setting.study.with_same_change({query.path: optimum}) if optimum is not None else None
        if there is None:
            raise UnsolvedError("there is no motion with that value")
        inner = with_changed_scene(inner, there, query.path, symbol)
        goal = write_inner_answer(inner, book, deriving_strategies(inner.query.kind, inner.mechanism))
        expression = short_formula(inner, book, goal)
        if expression is None or symbol not in expression.symbols():
            raise UnsolvedError("the formula for it is too long")
        _stationary(book, query, goal, expression, symbol)
        if query.asks_place:
            return symbol
        extreme = book.fresh(goal, r"\text{max}" if query.greatest else r"\text{min}")
        step = book.begin_step("extreme value")
        step.rest_on(symbol)
        step.add_text(f"With this value, {step.result(extreme, expression, book.units.get(goal, ''), law=True)}.")
        step.close()
        return extreme.name


def _stationary(book: SolutionBuilder, query: OptimumQuery, goal: str, expression: Expression, symbol: str) -> None:
    """Write the value of a symbol at which a formula is greatest or least."""
    core, turned = _core(expression, symbol)
    greatest = query.greatest is not turned
    try:
        slope = _numerator(derivative(core, symbol))
    except TypeError as error:
        raise UnsolvedError(str(error)) from error
    step, name = book.begin_step("derivative"), book.fresh("D")
    step.rest_on(goal)
    step.add_text(insertion_sentence(book, goal, step.derived(Symbol(goal), expression)))
    derivative_latex = rf"\frac{{\mathrm{{d}}}}{{\mathrm{{d}} {symbol}}} \left({core.latex()}\right)"
    extreme = "greatest" if query.greatest else "least"
    where = "" if core == expression else f", just where ${core.latex()}$ is {'greatest' if greatest else 'least'}"
    step.add_text(
        f"It is {extreme}{where}. There the derivative ${derivative_latex}$ vanishes; but for a factor that does not"
    )
    step.add_text(f"vanish, it is {step.result(name, slope, '', law=True)}, so that {step.law(name, ZERO)}.")
    step.close()
    Inversion(book, name.name, 0.0, symbol).write()


def _core(expression: Expression, symbol: str) -> tuple[Expression, bool]:
    """Return the part of a positive formula with the same extrema in a symbol, and whether maxima become minima."""
    match expression:
        case Root():
            return _core(expression.inside, symbol)
        case Product():
            kept = [factor for factor in expression.factors if symbol in factor.symbols()]
            if len(kept) == 1:
                return _core(kept[0], symbol)
        case Quotient() if symbol not in expression.below.symbols():
            return _core(expression.above, symbol)
        case Quotient() if symbol not in expression.above.symbols():
            core, turned = _core(expression.below, symbol)
            return core, not turned
        case _:
            pass
    return expression, False


def _numerator(slope: Expression) -> Expression:
    """Return the numerator of a derivative; raise UnsolvedError if it is too long."""
    try:
        numerator = simplified_form(fraction(slope).above.factored()).expression
    except (OverflowError, ClosedFormError) as error:
        raise UnsolvedError("its derivative is too long") from error
    if isinstance(numerator, Quotient):
        numerator = numerator.above
    if len(numerator.latex()) > MAX_NUMERATOR_LENGTH:
        raise UnsolvedError("its derivative is too long")
    return numerator


TWO = Number(2.0)
DIRECTION_TOLERANCE = 1e-9  # largest vertical component of a horizontal unit vector


@strategy
class GreatestRange(Strategy):
    """The strategy for the angle of greatest range from a height, by the derivative of the trajectory."""

    name = "greatest range"
    cost = 0.5
    kinds = frozenset({"optimum"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason that a mechanism is not one body in free fall in a vertical plane; empty if it is one."""
        alone = len(mechanism.bodies) == 1 and len(mechanism.coordinates) == len(("x", "z"))
        return "" if alone and only_falls(mechanism) and not mechanism.meetings else "it is no body thrown in a plane"

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        query = setting.query
        if not isinstance(query, OptimumQuery) or setting.sought is None or not query.greatest:
            return "no greatest value is asked for"
        target, angle = query.target, setting.lexicon.givens[query.path].angle
        far = target is not None and target.quantity == "displacement" and isinstance(query.moment, Landed)
        level = (
            target is None or target.sense is None or abs(target.direction(setting.mechanism)[2]) < DIRECTION_TOLERANCE
        )
        return "" if far and level and angle else "it is not about how far a body is thrown"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the trajectory, its derivative and the solution of both, and return the symbol of the answer."""
        query = setting.query
        assert isinstance(query, OptimumQuery)
        theta, lexicon = Symbol(independent_symbol(setting, query.path)), setting.lexicon
        speed = lexicon.formula_for(lambda m: hypot(*(c.speed for c in m.coordinates))).expression()
        height = lexicon.formula_for(lambda m: -max(c.lower for c in m.coordinates if c.lower > -inf)).expression()
        gravity = lexicon.formula_for(lambda m: -m.gravity[2]).expression()
        horizontal_range = book.fresh("x")
        step = book.begin_step("path")
        tangent, bent = Call("tan", theta), gravity * Power(horizontal_range, 2) / (TWO * Power(speed, 2))
        fallen = step.law(height + horizontal_range * tangent - bent / Power(Call("cos", theta), 2), ZERO)
        far = Root(Power(speed, 2) + TWO * gravity * height)
        book.set_value(horizontal_range.name, book.value(speed * far / gravity), METRES)
        step.add_text(
            f"The body lands at the horizontal distance ${horizontal_range.name}$ where it has come down to the ground:"
        )
        step.add_text(f"{fallen}.")
        step.close()
        step = book.begin_step("derivative")
        rest = step.law(horizontal_range - gravity * Power(horizontal_range, 2) * tangent / Power(speed, 2), ZERO)
        step.add_text(
            f"Where ${horizontal_range.name}$ is greatest, it does not change to first order as ${theta.name}$ grows. "
            "So there"
        )
        step.add_text(
            f"the derivative of this equation by ${theta.name}$, with ${horizontal_range.name}$ constant, vanishes. "
            "Multiplied by"
        )
        step.add_text(f"$\\cos^2{theta.name}$, that is {rest}.")
        step.close()
        step = book.begin_step("solve for the unknown")
        angle = Call("arctan", speed / far)
        step.add_text(f"With $1 + \\tan^2{theta.name}$ for $1/\\cos^2{theta.name}$, both equations lead to")
        step.add_text(f"{step.closed(horizontal_range, speed * far / gravity)} and {step.closed(theta, angle)}.")
        step.close()
        return theta.name if query.asks_place else self._farthest(setting, book, horizontal_range, height)

    @staticmethod
    def _farthest(setting: ProblemContext, book: SolutionBuilder, way: Symbol, height: Expression) -> str:
        """Return the symbol of the greatest distance: along the ground, or straight from the starting point."""
        target = setting.query.target
        if target is not None and target.sense is not None:
            return way.name
        away = Root(Power(way, 2) + Power(height, 2))
        return book.add_step("distance", "From the starting point it is", book.fresh("s"), away, METRES).name


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
            not candidate.why_not_applicable(inner)
            for candidate in deriving_strategies(inner.query.kind, inner.mechanism)
        )
        return "" if offered else f"no formula for the kind {inner.query.kind}"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the formula and its limit, and return the symbol of the limit."""
        query = setting.query
        assert isinstance(query, LimitQuery)
        symbol, inner = independent_symbol(setting, query.path), inner_setting(setting)
        goal = write_inner_answer(inner, book, deriving_strategies(inner.query.kind, inner.mechanism))
        expression = short_formula(inner, book, goal)
        if expression is None or symbol not in expression.symbols():
            raise UnsolvedError("the formula for it is too long, or does not hang on that mass")
        try:
            left = limit(expression, symbol, book.values, large=query.large)
            simplified = simplified_form(left).expression if left is not None else None
        except (CancelledError, TypeError, ClosedFormError) as error:
            raise UnsolvedError(str(error)) from error
        if simplified is None:
            raise UnsolvedError("it vanishes, or grows without bound")
        step, end = book.begin_step("limit"), r"\infty" if query.large else "0"
        step.rest_on(goal)
        which = "highest" if query.large else "lowest"
        name = book.fresh(goal, end)
        step.add_text(insertion_sentence(book, goal, step.derived(Symbol(goal), expression)))
        step.add_text(
            f"For ${symbol} \\to {end}$ only the terms with the {which} power of ${symbol}$ are left in each sum:"
        )
        step.add_text(f"{step.result(name, simplified, book.units.get(goal, ''), law=True)}.")
        step.close()
        return name.name
