"""Changes between sticking and slipping on a face."""

from dataclasses import dataclass

import numpy as np

from sim2reason.questions.choices import STILL, still
from sim2reason.questions.moments.parts.occurrence import Occurrence
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.quantities.subjects.contacts import Contacts
from sim2reason.simulation.trace import Event, Trace


@dataclass(frozen=True, slots=True)
class SlipChange(Occurrence):
    """A change between sticking and slipping on a face."""

    own = True
    of = Contacts()

    def slipped(self, event: Event, trace: Trace) -> bool:
        """Return whether the body slips until shortly before an event; what only turns back does, too."""
        slips = np.abs(slip(trace.scan, self.name))
        before = slips[trace.scan.times < event.time - STILL * trace.scan.times[-1]]
        return len(before) > 0 and float(before[-1]) > still(trace, slips)


def slip(state: State, name: str) -> Array:
    """Return the velocity with which a body slips on its face, m/s, (n,)."""
    mechanism = state.mechanism
    total = np.zeros(len(state.times))
    for coordinate, factor in mechanism.contacts[name].slip:
        total = total + factor * state.v[:, mechanism.number[coordinate]]
    return total


def rolls(words: Words, name: str) -> bool:
    """Return whether a body rolls on its face rather than slides: it may turn there."""
    return len(words.mechanism.contacts[name].slip) > 1
