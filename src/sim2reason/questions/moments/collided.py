"""A collision of two bodies, just before or just after it."""

from dataclasses import dataclass

import numpy as np

from sim2reason.quantities.kinematics import Velocity
from sim2reason.quantities.subjects.pairs import AND, Pairs, members
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.free_motion import meets_once
from sim2reason.questions.moments.parts.occurrence import VelocityJump
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Event, Trace

SAME = 1e-9  # of a speed: what has changed by less has not


@MOMENTS.register("collided")
@dataclass(frozen=True, slots=True)
class Collided(VelocityJump):
    """The first collision of two bodies, or a later one, just before or just after it."""

    label = "collision"
    kinds = ("collision",)
    of = Pairs()
    most = 3
    pronoun = "they"
    verb = Verb("collide", "collide", "do")

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Those that may meet."""
        met = {AND.join(meeting.names) for meeting in words.mechanism.meetings}
        return {name: said for name, said in words.called(cls.of).items() if name in met}

    @classmethod
    def seen_as(cls, name: str, words: Words) -> set[str]:
        """Each of the two."""
        del words
        return set(members(name))

    @property
    def subjects(self) -> tuple[str, ...]:
        """The two bodies."""
        return members(self.name)

    def count(self, words: Words) -> int | None:
        """Return no number where they can collide only once."""
        return None if self.number == 1 and meets_once(words.mechanism) else self.number

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Whether the two collide."""
        del trace
        return event.kind == "collision" and set(event.subjects) == set(self.subjects)

    def is_plain(self, study: Study) -> bool:
        """Whether the two come together in free flight, so that no collision, force or field has a part in it."""
        time = study.time(self)
        if time is None:
            return False
        times = np.array([0.0, 0.5 * time, np.nextafter(time, 0.0)])
        one, other = (Velocity.evaluate(study.trace.sample(times), body) for body in self.subjects)
        apart = one - other
        return bool(np.abs(apart - apart[0]).max() <= SAME * np.abs(apart).max())
