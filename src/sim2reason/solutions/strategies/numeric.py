"""Numerical integration: the equations of motion of each phase with their initial values, and the answer read off."""

from sim2reason.solutions.phases.integrated import IntegratedPhases
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.writing.steps import Book


@strategy
class NumericalIntegration(Strategy):
    """Any motion whose equations can be written in the numbers of the text, integrated phase by phase."""

    name = "integration"
    cost = 100.0
    kinds = frozenset({"state", "event", "time_to_event", "sum", "extremum"})
    integrates = True

    def refusal(self, setting: Setting) -> str:
        """Return why it does not apply."""
        if setting.formula is not None:
            return "integration gives no formula"
        return "" if setting.answer is not None else "there is no answer"

    def write(self, setting: Setting, book: Book) -> str:
        """Write the phases in order, then the answer."""
        return IntegratedPhases(setting, book).write()
