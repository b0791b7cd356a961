"""Phase by phase: constant accelerations between events, each phase from the final state of the one before."""

from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.phases.integrated import IntegratedPhases
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, strategy, varying_acceleration
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError


@strategy
class PhaseByPhase(Strategy):
    """The strategy for motions that stick, slip or collide in any order, at constant accelerations."""

    name = "phase by phase"
    cost = 50.0
    kinds = frozenset({"state", "event", "time_to_event", "extremum"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that accelerations vary between events; empty if the strategy may apply."""
        return varying_acceleration(mechanism)

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: none, since several phases give no single formula."""
        del mechanism
        return frozenset()

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        if setting.formula is not None or setting.unknown:
            return "equations of phases lead to numbers, and to no unknown"
        return "" if setting.answer is not None else "there is no answer"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the phases in order and the answer, and return its symbol; UnsolvedError if `book` is not empty."""
        if book.steps:
            raise UnsolvedError("phases begin a solution")
        return IntegratedPhases(setting, book, integrates=False).write()
