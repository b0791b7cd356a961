"""The kinetic energy that is lost as a string becomes taut."""

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.subjects.strings import Strings
from sim2reason.questions.functionals import Functional, functional
from sim2reason.questions.functionals.parts.jump import energies, energy_lost
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.went_taut import WentTaut
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace


@functional
class JerkLoss(Functional):
    """The kinetic energy that is lost in the jerk with which a string becomes taut."""

    name, unit, kind, least = "energy lost in a jerk", "J", "sum", 1e-3
    of, needs = Strings(), ("mass",)
    phrase = "the total kinetic energy lost"
    how = "how much kinetic energy is lost {when}?"
    weight = 5.0

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """As in: when the string first becomes taut again."""
        if not (isinstance(moment, WentTaut) and moment.after and moment.name == name):
            return ()
        return moment.does(words).phrases(moment.subject(words), moment.number)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """The loss of all bodies."""
        del name
        return energy_lost(trace, [end])

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """All kinetic energies."""
        del name
        return energies(mechanism)
