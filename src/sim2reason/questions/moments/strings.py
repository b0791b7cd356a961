"""Strings that go slack or become taut."""

from dataclasses import dataclass

from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.occurrence import Occurrence, VelocityJump
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Inextensible
from sim2reason.simulation.quantities.subjects.lines import Strings


@MOMENTS.register("went_slack")
@dataclass(frozen=True, slots=True)
class WentSlack(Occurrence):
    """The first time that a string goes slack."""

    label = "slack"
    kinds = ("slack",)
    of = Strings()
    verb = Verb("goes slack", "go slack")


@MOMENTS.register("went_taut")
@dataclass(frozen=True, slots=True)
class WentTaut(VelocityJump):
    """The first time that a string that was slack becomes taut, with a jerk; again, if it was taut at the start."""

    label = "taut"
    own = False
    kinds = ("taut",)
    of = Strings()
    verb = Verb("becomes taut", "become taut")

    def does(self, words: Words) -> Verb:
        """Return what it does, as a text says it of a string that it calls taut or slack at the start."""
        law = words.mechanism.line[self.name].law
        spare = isinstance(law, Inextensible) and law.slack > 0.0
        return self.verb if spare else Verb("becomes taut again", "become taut again")
