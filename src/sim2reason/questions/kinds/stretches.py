"""Kinds for extreme values, sums and counts over an interval of the motion."""

from sim2reason.questions.kinds import kind
from sim2reason.questions.kinds.parts.stretch_kind import StretchKind


@kind
class CountKind(StretchKind):
    """The kind that asks how many events of one type occur in an interval of the motion."""

    name = "count"
    of_symbols = False
    share = 0.12
    whole = True


@kind
class ExtremumKind(StretchKind):
    """The kind that asks for the greatest or least value of a quantity in an interval of the motion."""

    name = "extremum"
    share = 0.3
    ends_matter = False


@kind
class SumKind(StretchKind):
    """The kind that asks for the total of a quantity, such as a distance travelled, in an interval of the motion."""

    name = "sum"
    share = 0.25
