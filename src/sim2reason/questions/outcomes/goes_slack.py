"""Whether a string that swings goes slack."""

from dataclasses import dataclass

from sim2reason.dsl.mechanism import Inextensible
from sim2reason.quantities.subjects.swinging_lines import SwingingLines
from sim2reason.questions.outcomes import OUTCOMES, Swinging
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace

BOTH = 2  # sides at which what swings is when it no longer moves to the left or right


@OUTCOMES.register("goes_slack")
@dataclass(frozen=True, slots=True)
class GoesSlack(Swinging):
    """The string of a pendulum goes slack, in its first swings or never."""

    of = SwingingLines()
    tells = False

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Strings that swing."""
        lines = words.mechanism.line
        called = words.called(cls.of).items()
        return {n: said for n, said in called if n in lines and isinstance(lines[n].law, Inextensible)}

    def happens(self, trace: Trace) -> bool | None:
        """Whether there is such an event; no once it has swung to both sides, or gone round."""
        if any(event.kind == "slack" and event.subjects[0] == self.name for event in trace.events):
            return True
        level = {c.name for c in trace.mechanism.coordinates if c.axis[2] == 0.0}
        sides = sum(event.kind == "turn" and event.subjects[0] in level for event in trace.events)
        return False if sides >= BOTH else None

    def excess(self, trace: Trace) -> float:
        """The least tension."""
        return float(trace.scan.tension[self.name].min())

    def does(self, words: Words) -> tuple[str, ...]:
        """As in: the string goes slack."""
        subject = self.subject(words)
        return (f"{subject} goes slack at some time", f"{subject} goes slack on the way")

    def does_not(self, words: Words) -> tuple[str, ...]:
        """As in: the string stays taut."""
        subject = self.subject(words)
        return (f"{subject} stays taut throughout", f"{subject} never goes slack")
