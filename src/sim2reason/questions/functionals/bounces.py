"""How often a body bounces."""

from collections.abc import Sequence

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.kinematics import Velocity
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.event_count import EventCount
from sim2reason.questions.moments.bounced import struck
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace


@functional
class Bounces(EventCount):
    """How often a body hits the ground, a wall or walls."""

    name = "number of bounces"
    of = Bodies()
    phrase = "the number of times that {body} hits {what}"
    how = "how many times does {body} hit {what} {when}?"
    fewest = 2  # a ball that is thrown is not followed for much longer
    indirect = "how many times {body} hits {what}"

    def own(self, words: Words, name: str) -> dict[str, str]:
        """What it hits."""
        return {"what": struck(words, name)}

    def present(self, words: Words, name: str) -> bool:
        """What can hit something fixed."""
        return bool(struck(words, name))

    def times(self, trace: Trace, name: str) -> Sequence[float]:
        """Those of its collisions with what is fixed."""
        return [event.time for event in trace.events if event.kind == "collision" and event.subjects == (name,)]

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Its velocity."""
        del mechanism
        return (Channel(name, Velocity.name),)
