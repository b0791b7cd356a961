"""The first time that a body enters the region where a field acts."""

from dataclasses import dataclass

from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.occurrence import Occurrence
from sim2reason.questions.moments.parts.verbs import Verb


@MOMENTS.register("entered_region")
@dataclass(frozen=True, slots=True)
class EnteredRegion(Occurrence):
    """The first time that a body enters the region of a field."""

    label = "entry"
    own = True
    kinds = ("enter",)
    of = Bodies()
    verb = Verb("enters the field", "enter the field")
