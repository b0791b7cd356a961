"""Initial value: a speed or a kinetic energy at the start, where it is the extreme one of a stretch of motion."""

from sim2reason.base.records import cached_property
from sim2reason.questions.moments.times import AtStart
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.goals import GOALS
from sim2reason.solutions.laws.newton import Newton
from sim2reason.solutions.laws.straight_way import StraightMotion
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

QUANTITIES = frozenset({"velocity", "kinetic energy"})


@strategy
class InitialValue(Strategy):
    """The strategy for an extreme speed or kinetic energy that is the value at the start, from given velocities."""

    name = "initial value"
    cost = 0.5
    drawn = False
    kinds = frozenset({"start"})

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: none, as no generated question asks for this value."""
        del mechanism
        return frozenset()

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason that a question is about no extreme speed or kinetic energy at the start; else empty."""
        target = setting.target
        if setting.extreme is None or not isinstance(setting.query.moment, AtStart) or target is None:
            return "it is about no extreme value at the start"
        return "" if target.quantity in QUANTITIES else f"no way to the quantity {target.quantity}"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the speed or kinetic energy at the start from the components of the velocity; return its symbol."""
        way = _AtStart(setting, book)
        assert way.target is not None
        return GOALS[way.target.quantity].write(way.target, way).name


class _AtStart(StraightMotion):
    """Velocities at t = 0."""

    @property
    def newton(self) -> Newton:
        """Return the laws of the first segment, for masses and directions alone."""
        return self._newton

    @cached_property
    def _newton(self) -> Newton:
        return Newton(self.setting.lexicon, self.setting.motion.segments[0])

    def force(self, kind: str, name: str) -> Symbol:
        """Raise UnsolvedError, since a force would need the accelerations."""
        raise UnsolvedError(f"no {kind} of {name}")

    def rate(self, kind: str, k: int) -> Polynomial:
        """Return the initial velocity along a coordinate."""
        if kind != "v":
            raise UnsolvedError("only velocities are known at the start")
        return self.first_speeds.get(k, NIL)
