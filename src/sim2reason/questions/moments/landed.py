"""The instant at which a body that flies reaches the ground, where the description ends."""

from dataclasses import dataclass
from math import inf

from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import EVEN
from sim2reason.questions.moments import MOMENTS, Clause
from sim2reason.questions.moments.parts.occurrence import Occurrence
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Event, Trace


@MOMENTS.register("landed")
@dataclass(frozen=True, slots=True)
class Landed(Occurrence):
    """The instant at which a body that flies reaches the ground."""

    label = "landing"
    own = True
    kinds = ("limit",)
    of = Bodies()
    most = 0
    verb = Verb("reaches the ground", "reach the ground")

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """What flies, and can't go below the ground."""
        found: dict[str, str] = {}
        for name, said in words.called(cls.of).items():
            body = words.mechanism.body[name]
            down = any(c.axis[2] > 1.0 - EVEN and c.lower > -inf for c in body.coordinates)
            if down and len(body.coordinates) > 1 and body.parent is None and name not in words.mechanism.contacts:
                found[name] = said
        return found

    @classmethod
    def seen_as(cls, name: str, words: Words) -> set[str]:
        """Its coordinates."""
        return {c.name for c in words.mechanism.body[name].coordinates}

    @property
    def sided(self) -> bool | None:
        """Just before it."""
        return False

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Whether it is the end of the way down."""
        return event.kind == "limit" and any(
            c.name == event.subjects[0] for c in trace.mechanism.body[self.name].coordinates
        )

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: just before the ball reaches the ground."""
        lands = f"{self.subject(words)} {self.verb.told}"
        return (f"just before {lands}", f"immediately before {lands}", f"at the moment just before {lands}")

    def clause(self, words: Words) -> Clause | None:
        """As in: the ball reaches the ground."""
        return self.verb.clause(self.subject(words), None)
