"""Greatest range: the launch angle at which a body thrown from a height lands farthest away."""

from math import hypot, inf

from sim2reason.questions.choices import only_falls
from sim2reason.questions.kinds.optimum import OptimumQuery
from sim2reason.questions.moments.bounces import Landed
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Call, Power, Root
from sim2reason.solutions.laws.nested import lone_symbol
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.writing.steps import SolutionBuilder
from sim2reason.solutions.writing.unit_latex import METRES

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
        level = target is None or target.sense is None or abs(target.way(setting.mechanism)[2]) < DIRECTION_TOLERANCE
        return "" if far and level and angle else "it is not about how far a body is thrown"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the trajectory, its derivative and the solution of both, and return the symbol of the answer."""
        query = setting.query
        assert isinstance(query, OptimumQuery)
        theta, lexicon = Symbol(lone_symbol(setting, query.path)), setting.lexicon
        speed = lexicon.of(lambda m: hypot(*(c.speed for c in m.coordinates))).expression()
        height = lexicon.of(lambda m: -max(c.lower for c in m.coordinates if c.lower > -inf)).expression()
        gravity = lexicon.of(lambda m: -m.gravity[2]).expression()
        way = book.fresh("x")
        step = book.begin_step("path")
        tangent, bent = Call("tan", theta), gravity * Power(way, 2) / (TWO * Power(speed, 2))
        fallen = step.law(height + way * tangent - bent / Power(Call("cos", theta), 2), ZERO)
        far = Root(Power(speed, 2) + TWO * gravity * height)
        book.set_value(way.name, book.value(speed * far / gravity), METRES)
        step.add_text(f"The body lands at the horizontal distance ${way.name}$ where it has come down to the ground:")
        step.add_text(f"{fallen}.")
        step.close()
        step = book.begin_step("derivative")
        rest = step.law(way - gravity * Power(way, 2) * tangent / Power(speed, 2), ZERO)
        step.add_text(
            f"Where ${way.name}$ is greatest, it does not change to first order as ${theta.name}$ grows. So there"
        )
        step.add_text(
            f"the derivative of this equation by ${theta.name}$, with ${way.name}$ constant, vanishes. Multiplied by"
        )
        step.add_text(f"$\\cos^2{theta.name}$, that is {rest}.")
        step.close()
        step = book.begin_step("solve for the unknown")
        angle = Call("arctan", speed / far)
        step.add_text(f"With $1 + \\tan^2{theta.name}$ for $1/\\cos^2{theta.name}$, both equations lead to")
        step.add_text(f"{step.closed(way, speed * far / gravity)} and {step.closed(theta, angle)}.")
        step.close()
        return theta.name if query.asks_place else self._farthest(setting, book, way, height)

    @staticmethod
    def _farthest(setting: ProblemContext, book: SolutionBuilder, way: Symbol, height: Expression) -> str:
        """Return the symbol of the greatest distance: along the ground, or straight from the starting point."""
        target = setting.query.target
        if target is not None and target.sense is not None:
            return way.name
        away = Root(Power(way, 2) + Power(height, 2))
        return book.add_step("distance", "From the starting point it is", book.fresh("s"), away, METRES).name
