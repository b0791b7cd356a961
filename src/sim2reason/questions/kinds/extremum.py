"""What is the greatest or least value of a quantity over a stretch of the motion?"""

from sim2reason.questions.kinds import kind
from sim2reason.questions.kinds.parts.stretch_kind import StretchKind


@kind
class ExtremumKind(StretchKind):
    """What is the greatest or least value of a quantity over a stretch of the motion?"""

    name = "extremum"
    share = 0.3
    ends_matter = False
