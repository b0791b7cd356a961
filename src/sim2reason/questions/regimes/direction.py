"""Which way a body moves."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.dsl.constancy import changing
from sim2reason.dsl.state import Array
from sim2reason.dsl.vectors import Vector
from sim2reason.quantities.kinematics import Acceleration, Velocity
from sim2reason.quantities.subjects import Sense
from sim2reason.quantities.subjects.bodies import OPPOSITE, RIGHT, Bodies
from sim2reason.quantities.subjects.paths import center_path
from sim2reason.questions.regimes import REGIMES, Regime
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words

STILL = 1e-9  # of the greatest speed: less is none
LASTING = 1e-9  # of the time that is asked about: what turns back stands still for less


@REGIMES.register("direction")
@dataclass(frozen=True, slots=True)
class MovesOneWay(Regime):
    """A body moves one way along a line, or is about to, where no force that changes may turn it back."""

    of = Bodies()

    positive: str  # the sense of the line, as the text has it
    ahead: bool

    @classmethod
    def possible(cls, study: Study, words: Words) -> Sequence[Self]:
        """Either way, of every body whose line has a sense in words."""
        senses = [(name, sense) for name in words.called(cls.of) for sense in _senses(study, name)]
        return [cls(name, sense.positive, ahead) for name, sense in senses for ahead in (True, False)]

    def holds(self, study: Study, until: float) -> bool:
        """Whether it moves that way there."""
        return (until > 0.0 or not changing(study.mechanism)) and self.begins(study, until)

    def begins(self, study: Study, until: float = 0.0) -> bool:
        """Whether it moves that way up to a time, s, whatever it does later."""
        sense = next((s for s in _senses(study, self.name) if s.positive == self.positive), None)
        return sense is not None and _side(study, self.name, sense.vector, until) == (1 if self.ahead else -1)

    def margin(self, study: Study, until: float) -> float | None:
        """The velocity that way then, or the acceleration at the start, as a share of what free fall has."""
        sense = next((s for s in _senses(study, self.name) if s.positive == self.positive), None)
        if sense is None:
            return None
        rate = (Velocity if until else Acceleration).evaluate(study.trace.at(until), self.name)[0] @ np.array(
            sense.vector
        )
        return (1.0 if self.ahead else -1.0) * float(rate) / _of_free_fall(study, until)

    def clause(self, words: Words) -> str:
        """As in: block A moves down the slope; where it may turn or stop, it keeps moving that way.

        What a collision may send off, too, moves only that way.
        """
        kept = "moves only" if words.mechanism.meetings else "keeps moving" if words.turns_back else "moves"
        return f"{words.called(self.of)[self.name]} {self.motion.replace('moves', kept, 1)}"

    @property
    def motion(self) -> str:
        """As in: moves down the slope."""
        first, space, rest = self.positive.partition(" ")
        way = first if self.ahead else OPPOSITE[first]
        towards = f"to the {way}" if first == RIGHT else way
        return f"moves {towards}{space}{rest}"


def _of_free_fall(study: Study, until: float) -> float:
    """The velocity of free fall at a time, s, its acceleration at the start, or 1 if there is no gravity."""
    return float(np.linalg.norm(study.mechanism.gravity)) * (until or 1.0) or 1.0


def _senses(study: Study, name: str) -> list[Sense]:
    """That of the line along which a body moves, if the text has words for it."""
    if not center_path(study.mechanism, name).straight:
        return []
    senses = Bodies().senses(study.mechanism, name)
    return [sense for sense in senses if sense.positive.partition(" ")[0] in OPPOSITE and not sense.axis]


def _side(study: Study, name: str, way: Vector, until: float) -> int:
    """1 or -1 if the velocity is along or against a way once it moves, 0 if it is both, or none for a while later.

    What starts from rest moves the way in which it is accelerated.
    """
    scan = study.trace.scan
    within = scan.times < until
    times = np.append(scan.times[within], until)
    last = Velocity.evaluate(study.trace.at(until), name)
    speeds: Array = np.concatenate([Velocity.evaluate(scan, name)[within], last]) @ np.array(way)
    fastest = float(np.abs(speeds).max(initial=0.0))
    if fastest <= STILL:
        begins = float((Acceleration.evaluate(study.trace.at(0.0), name) @ np.array(way))[0])
        return int(begins > STILL) - int(begins < -STILL)
    idle = np.abs(speeds) <= STILL * fastest
    rests = idle[1:] & idle[:-1] & (np.diff(times) > LASTING * until)
    if rests[int(np.argmin(idle)) :].any():
        return 0
    ahead, back = bool((speeds[~idle] > 0.0).any()), bool((speeds[~idle] < 0.0).any())
    return int(ahead) - int(back)
