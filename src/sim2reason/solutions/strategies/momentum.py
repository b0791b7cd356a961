"""Momentum: conserved along a direction without external forces, with energy for the relative motion."""

from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.expressions import ZERO, Symbol
from sim2reason.solutions.algebra.fractions import reduced_quotient
from sim2reason.solutions.algebra.polynomials import NIL
from sim2reason.solutions.oscillations.single_way import TwoBodyModel
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import strategy
from sim2reason.solutions.strategies.energy import EnergyModel, WorkAndEnergy
from sim2reason.solutions.writing.comparing import record_inequality
from sim2reason.solutions.writing.steps import SolutionBuilder
from sim2reason.solutions.writing.unit_latex import SPEED


@strategy
class MomentumKept(WorkAndEnergy):
    """The strategy for two free coordinates with a conserved momentum."""

    name = "momentum"
    cost = 0.95
    kinds = frozenset({"event", "extremum"})
    free = 2

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason that a mechanism is unsuitable: a single moving body, or as for energy; else empty."""
        alone = len({coordinate.body for coordinate in mechanism.coordinates}) < self.free
        return "a single body moves" if alone else super().why_unsuitable(mechanism)

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the reduced mass, the work, the momentum and the answer, and return the answer's symbol."""
        return _Pair(setting, book).write().name


class _Pair(TwoBodyModel, EnergyModel):
    """A motion model of two bodies with relative speeds from energy."""

    def _turning(self) -> Symbol:
        """Write the turning point, and that a body that stops later still moves there; return its symbol."""
        found, moment, book = super()._turning(), self.query.moment, self.book
        if not self.greatest or not isinstance(moment, Stopped) or not self.kept:
            return found
        both = reduced_quotient(self.kept, self._relative.masses[0])
        own = self.moving([moment.name])
        first = self.first_speeds.get(own[0], NIL).expression() if len(own) == 1 else ZERO
        alike = self._relative.ratio(own[0], self._relative.other) == 1.0
        if not alike or book.is_hidden(both) or not 0.0 < book.value(both) < book.value(first):
            return found
        step, name, who = book.begin_step("verify"), book.fresh("V"), self.setting.display_name(moment.name)
        record_inequality(book, step, both, ZERO)
        record_inequality(book, step, first, both)
        told = step.verified(name, both, SPEED)
        step.add_text(
            f"The common velocity is then {told}. Until then {who} is faster, so it has not come to rest before."
        )
        step.close()
        return found
