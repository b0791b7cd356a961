"""The work of a hand that draws a string in."""

from sim2reason.dsl.mechanism import ConstantTension, Mechanism
from sim2reason.quantities.subjects.hands import Hands
from sim2reason.quantities.tension import StringLength
from sim2reason.questions.functionals import Functional, functional
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.parts.distance import DistanceThreshold
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace


@functional
class PullWork(Functional):
    """The work that a hand does as it draws a string in with a constant force."""

    name, unit, kind, least = "work of a hand", "J", "sum", 1e-3
    of = Hands()
    phrase = "the work that {hand} does"
    how = "how much work does {hand} do {when}?"
    indirect = "how much work {hand} does"
    weight = 1.5

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Not until something has moved by a stated distance: force times distance is no question."""
        return () if isinstance(moment, DistanceThreshold) else super().when(moment, words, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Its force times what it has drawn in; None where it has let out more."""
        line = trace.mechanism.line[name]
        assert isinstance(line.law, ConstantTension)
        start, here = (float(trace.at(time).free_length(line)[0][0]) for time in (0.0, end))
        work = line.law.force * (start - here)
        return work if work > 0.0 else None

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """How the string's length changes."""
        del mechanism
        return (Channel(name, StringLength.name),)
