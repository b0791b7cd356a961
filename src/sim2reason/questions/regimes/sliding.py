"""Whether a body slides on what it lies on."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.quantities.subjects.contacts import Contacts
from sim2reason.questions.choices import at
from sim2reason.questions.moments.parts.slip_change import slip
from sim2reason.questions.regimes import REGIMES, Regime
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words

STILL = 1e-9  # m/s
LASTING = 1e-9  # of that time
SOON = 1e-3  # of the time that is asked about, or s: by when what is released has begun to slide


@REGIMES.register("sliding")
@dataclass(frozen=True, slots=True)
class SlidesThroughout(Regime):
    """A body slides on a rough face from the start on, or never does."""

    of = Contacts()

    slides: bool

    @classmethod
    def possible(cls, study: Study, words: Words) -> Sequence[Self]:
        """Either, of every body on a rough face."""
        rough = [name for name in words.called(cls.of) if study.mechanism.contacts[name].friction > 0.0]
        return [cls(name, slides) for name in rough for slides in (True, False)]

    def holds(self, study: Study, until: float) -> bool:
        """Whether it is so there."""
        return _slides(study, self.name, until) is self.slides

    def clause(self, words: Words) -> str:
        """As in: block A slides on the plank throughout."""
        surface, called = words.fills(self.of, self.name)["surface"], words.called(self.of)[self.name]
        if len(words.mechanism.contacts[self.name].slip) > 1:
            return f"{called} slips on {surface}" if self.slides else f"{called} rolls without slipping"
        return f"{called} slides on {surface}" if self.slides else f"{called} does not slide on {surface}"


def _slides(study: Study, name: str, until: float) -> bool | None:
    """Whether it slides throughout, if only to and fro; None if it does for a while."""
    soon = min(SOON * (until or 1.0), float(study.trace.state.times[-1]))
    scan = study.trace.scan
    within = (scan.times > soon) & (scan.times < until)
    times = np.concatenate([[soon], scan.times[within]])
    still = np.abs(np.concatenate([slip(at(study.trace, soon), name), slip(scan, name)[within]])) <= STILL
    if still.all():
        return False
    stays = still[1:] & still[:-1] & (np.diff(times) > LASTING * until)  # what turns back is still for no time
    return None if still[0] or stays.any() else True
