"""What does a quantity add up to over a stretch of the motion?"""

from sim2reason.questions.kinds import kind
from sim2reason.questions.kinds.parts.stretch_kind import StretchKind


@kind
class SumKind(StretchKind):
    """What does a quantity add up to over a stretch of the motion?"""

    name = "sum"
    share = 0.25
