"""Extreme values, sums and counts over a stretch of the motion."""

from sim2reason.questions.kinds import kind
from sim2reason.questions.kinds.parts.stretch_kind import StretchKind


@kind
class CountKind(StretchKind):
    """How often does something happen in a stretch of the motion?"""

    name = "count"
    of_symbols = False
    share = 0.12
    whole = True


@kind
class ExtremumKind(StretchKind):
    """What is the greatest or least value of a quantity over a stretch of the motion?"""

    name = "extremum"
    share = 0.3
    ends_matter = False


@kind
class SumKind(StretchKind):
    """What does a quantity add up to over a stretch of the motion?"""

    name = "sum"
    share = 0.25
