"""How often does something happen in a stretch of the motion?"""

from sim2reason.questions.kinds import kind
from sim2reason.questions.kinds.parts.stretch_kind import StretchKind


@kind
class CountKind(StretchKind):
    """How often does something happen in a stretch of the motion?"""

    name = "count"
    of_symbols = False
    share = 0.12
    whole = True
