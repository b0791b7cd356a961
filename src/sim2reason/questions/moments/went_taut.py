"""The first time that a string becomes taut, just before or just after it."""

from dataclasses import dataclass

from sim2reason.quantities.subjects.strings import Strings
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.occurrence import VelocityJump
from sim2reason.questions.moments.parts.verbs import Verb


@MOMENTS.register("went_taut")
@dataclass(frozen=True, slots=True)
class WentTaut(VelocityJump):
    """The first time that a string that was slack becomes taut, with a jerk."""

    label = "taut"
    own = False
    kinds = ("taut",)
    of = Strings()
    verb = Verb("becomes taut", "become taut")
