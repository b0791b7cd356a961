"""A rebound of a body from the ground or from a wall, just before or just after it."""

from dataclasses import dataclass

from sim2reason.dsl.mechanism import Meeting
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import EVEN
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.occurrence import VelocityJump
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Event, Trace

GROUND, WALL, WALLS = "the ground", "the wall", "a wall"


@MOMENTS.register("bounced")
@dataclass(frozen=True, slots=True)
class Bounced(VelocityJump):
    """The first impact of a body on what is fixed, or a later one, just before or just after it."""

    label = "bounce"
    kinds = ("collision",)
    of = Bodies()
    most = 3
    verb = Verb("hits {what}", "hit {what}")

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Bodies that meet the ground alone, or walls alone."""
        called = words.called(cls.of).items()
        return {name: said for name, said in called if struck(words, name)}

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Whether the body alone is struck."""
        del trace
        return event.kind == "collision" and event.subjects == (self.name,)

    def does(self, words: Words) -> Verb:
        """As in: hits the ground."""
        what = struck(words, self.name)
        return Verb(self.verb.told.format(what=what), self.verb.asked.format(what=what))


def struck(words: Words, name: str) -> str:
    """What a body bounces from: the ground, the wall, a wall; empty for nothing, or for several kinds."""
    met = [meeting for meeting in words.mechanism.meetings if meeting.names == (name,)]
    if met and all(_is_upright(meeting) for meeting in met):
        return GROUND
    if met and not any(_is_upright(meeting) for meeting in met):
        return WALL if len(met) == 1 else WALLS
    return ""


def _is_upright(meeting: Meeting) -> bool:
    """Whether a body falls on what it meets."""
    return meeting.normal is not None and meeting.normal[2] > 1.0 - EVEN
