"""How many collisions there are."""

from collections.abc import Sequence

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.kinematics import Velocity
from sim2reason.quantities.subjects.whole import Whole
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.event_count import EventCount
from sim2reason.questions.functionals.parts.jump import massive
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.last_collision import LastCollision
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace


@functional
class Collisions(EventCount):
    """The number of all collisions, of bodies with one another and with walls."""

    name = "number of collisions"
    of = Whole()
    phrase = "the number of collisions{walls} that take place"
    how = "how many collisions{walls} take place {when}?"
    indirect = "how many collisions{walls} take place"
    weight = 3.0

    def own(self, words: Words, name: str) -> dict[str, str]:
        """That walls count, where there are any."""
        del name
        walls = sum(meeting.a is None for meeting in words.mechanism.meetings)
        return {"walls": f", those with the wall{'s' if walls > 1 else ''} included," if walls else ""}

    def present(self, words: Words, name: str) -> bool:
        """Where several things may meet, and no buffer makes it doubtful what a collision is."""
        del name
        pairs = any(len(meeting.names) == 2 for meeting in words.mechanism.meetings)
        return pairs and not words.mechanism.half_springs

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Also of all that ever happen."""
        if isinstance(moment, LastCollision):
            return ("in all", "altogether", f"from {words.since} on")
        return super().when(moment, words, name)

    def times(self, trace: Trace, name: str) -> Sequence[float]:
        """Those of collisions."""
        del name
        return [event.time for event in trace.events if event.kind == "collision"]

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """All velocities."""
        del name
        return tuple(Channel(body, Velocity.name) for body in massive(mechanism))
