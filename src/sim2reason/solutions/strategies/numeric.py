"""Numerical integration: the initial-value problem of each phase, and the answer from its solution."""

from sim2reason.solutions.phases.integrated import IntegratedPhases
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.writing.steps import SolutionBuilder


@strategy
class NumericalIntegration(Strategy):
    """The strategy for any motion with equations in the numbers of the text, integrated phase by phase."""

    name = "integration"
    cost = 100.0
    kinds = frozenset({"state", "event", "time_to_event", "sum", "extremum"})
    integrates = True

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        if setting.formula is not None:
            return "integration gives no formula"
        return "" if setting.answer is not None else "there is no answer"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the phases in order and the answer, and return the answer's symbol."""
        return IntegratedPhases(setting, book).write()
