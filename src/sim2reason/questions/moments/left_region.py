"""The first time that a body leaves the region where a field acts."""

from dataclasses import dataclass

from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.occurrence import Occurrence
from sim2reason.questions.moments.parts.verbs import Verb


@MOMENTS.register("left_region")
@dataclass(frozen=True, slots=True)
class LeftRegion(Occurrence):
    """The first time that a body leaves the region of a field."""

    label = "exit"
    own = True
    kinds = ("exit",)
    of = Bodies()
    verb = Verb("leaves the field", "leave the field")
