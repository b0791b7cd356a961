"""The first time that a string goes slack."""

from dataclasses import dataclass

from sim2reason.quantities.subjects.strings import Strings
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.occurrence import Occurrence
from sim2reason.questions.moments.parts.verbs import Verb


@MOMENTS.register("went_slack")
@dataclass(frozen=True, slots=True)
class WentSlack(Occurrence):
    """The first time that a string goes slack."""

    label = "slack"
    kinds = ("slack",)
    of = Strings()
    verb = Verb("goes slack", "go slack")
