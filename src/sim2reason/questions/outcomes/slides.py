"""Whether a body that is at rest on a rough face begins to slip."""

from dataclasses import dataclass

import numpy as np

from sim2reason.quantities.subjects.contacts import Contacts
from sim2reason.questions.moments.parts.slip_change import rolls, slip
from sim2reason.questions.outcomes import OUTCOMES, Onset, is_steady_release, rest_speed_noise
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace


@OUTCOMES.register("slides")
@dataclass(frozen=True, slots=True)
class Slides(Onset):
    """A body slips on the face on which it lies at rest."""

    of = Contacts()

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """What lies on a rough face and does not roll."""
        if not is_steady_release(words):
            return {}
        contacts = words.mechanism.contacts
        called = words.called(cls.of).items()
        return {n: said for n, said in called if contacts[n].friction > 0.0 and not rolls(words, n)}

    def happens(self, trace: Trace) -> bool:
        """Whether it has a velocity on its face."""
        return self.excess(trace) > 0.0

    def excess(self, trace: Trace) -> float:
        """The fastest that it slips, but for what is none."""
        return float(np.abs(slip(trace.state, self.name)).max()) - rest_speed_noise(trace)

    def does(self, words: Words) -> tuple[str, ...]:
        """As in: block A slips on the plane."""
        return tuple(f"{self.subject(words)} {verb}" for verb in self._verbs(words, "slips", "begins to slip"))

    def does_not(self, words: Words) -> tuple[str, ...]:
        """As in: block A does not slip on the plane."""
        subject = self.subject(words)
        rests = () if words.mechanism.body[self.name].parent is not None else (f"{subject} stays at rest",)
        return (*rests, *(f"{subject} {verb}" for verb in self._verbs(words, "does not slip")))

    def _verbs(self, words: Words, *verbs: str) -> tuple[str, ...]:
        surface = words.fills(self.of, self.name)["surface"]
        return tuple(f"{verb} on {surface}" for verb in verbs)
