"""The highest point that a body reaches between a bounce and the next one."""

from dataclasses import dataclass

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.kinematics import Velocity
from sim2reason.questions.crossing import crossings
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.bounced import GROUND, Bounced, struck
from sim2reason.questions.moments.parts.occurrence import Occurrence
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.spoken import ordinal
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace

HIGHEST = "the highest point after its {count} bounce"


@MOMENTS.register("top_after_bounce")
@dataclass(frozen=True, slots=True)
class TopAfterBounce(Occurrence):
    """The highest point that a body reaches after its first bounce from the ground, or a later one."""

    label = "highest point after a bounce"
    event = False
    drawn_by_recipes = False
    kinds = ("collision",)
    of = Bounced.of
    most = 3
    verb = Verb(
        "reaches the highest point after its {count} bounce", "reach the highest point after its {count} bounce"
    )

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the phrases of the bodies that bounce off the ground."""
        return {name: said for name, said in Bounced.candidates(words).items() if struck(words, name) == GROUND}

    @property
    def channels(self) -> tuple[Channel, ...]:
        """Return the one channel on which the moment depends: the body's velocity."""
        return (Channel(self.name, Velocity.name),)

    def time(self, trace: Trace) -> float | None:
        """Return when the body first stops rising after that bounce and before the next one, s; None if it does not."""
        bounce = Bounced(self.name, self.number).time(trace)
        following = Bounced(self.name, self.number + 1).time(trace)
        if bounce is None:
            return None

        def sinks(state: State) -> Array:
            return -Velocity.evaluate(state, self.name)[:, 2]

        found = next((time for time in crossings(trace, sinks) if time > bounce), None)
        return found if found is not None and (following is None or found < following) else None

    def does(self, words: Words) -> Verb:
        """Return the verb with the ordinal, as in *reaches the highest point after its second bounce*."""
        del words
        count = ordinal(self.number)
        return Verb(self.verb.told.format(count=count), self.verb.asked.format(count=count))

    @property
    def _count(self) -> int | None:
        return None
