"""Quantities and moments that questions about swings ask for."""

from collections.abc import Collection

from sim2reason.questions.kinds.parts.stretch_kind import StretchQuery
from sim2reason.questions.moments.at_start import AtStart
from sim2reason.questions.moments.at_time import AtTime
from sim2reason.questions.moments.deflected import Deflected
from sim2reason.questions.moments.highest_point import HighestPoint
from sim2reason.questions.moments.lowest_point import LowestPoint
from sim2reason.questions.moments.stopped import Stopped
from sim2reason.questions.moments.turned_through import TurnedThrough
from sim2reason.questions.moments.went_slack import WentSlack
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.setting import Setting

MOMENTS = (AtStart, AtTime, Deflected, HighestPoint, LowestPoint, Stopped, TurnedThrough, WentSlack)
EXTREMES = {  # of what is asked over a stretch: the quantity, and whether it is extreme at rest or where it is fastest
    "greatest speed": ("velocity", "fastest"),
    "greatest angular speed": ("angular velocity", "fastest"),
    "greatest kinetic energy": ("kinetic energy", "fastest"),
    "greatest tension": ("tension", "fastest"),
    "greatest rod force": ("rod force", "fastest"),
    "greatest acceleration": ("acceleration", "fastest"),
    "least tension": ("tension", "slowest"),
    "least speed": ("velocity", "slowest"),
    "greatest deflection": ("deflection", "slowest"),
    "greatest height": ("height", "slowest"),
    "greatest displacement": ("displacement", "slowest"),
}
PLACES = frozenset({"deflection", "height", "displacement"})  # what says by itself where it is greatest


def quantity_of(setting: Setting) -> str:
    """Return the name of the quantity asked about; of an extreme value, that of which it is one."""
    query = setting.query
    if isinstance(query, StretchQuery):
        return EXTREMES[query.functional][0] if query.functional in EXTREMES else query.functional
    return query.target.quantity if query.target is not None else ""


def by_energy(setting: Setting, noun: str, name: Symbol, *, extreme: bool, one_point: bool = True) -> str:
    """Return the beginning of a sentence that gives how fast something is at the moment, by conservation of energy.

    With `extreme` it is said before where that is; `one_point` that what swings is a single small body.
    """
    if extreme and quantity_of(setting) not in PLACES:
        return f"There the {noun} ${name.latex()}$ is given by"
    at, moment = "at that moment", setting.query.moment
    if one_point and isinstance(moment, LowestPoint | HighestPoint):
        at = f"at the {'lowest' if isinstance(moment, LowestPoint) else 'highest'} point"
    return f"By conservation of energy, the {noun} ${name.latex()}$ {at} is given by"


def unasked(setting: Setting, quantities: Collection[str]) -> str:
    """Return the part of a query that no formula leads to, in words; empty if there is none."""
    query = setting.query
    if isinstance(query, StretchQuery):
        if quantity_of(setting) not in quantities:
            return f"no way to the {query.functional}"
        if query.kind != "sum":
            return ""
    if not isinstance(query.moment, MOMENTS):
        return "only integration gives the time"
    known = query.target is None or quantity_of(setting) in quantities
    return "" if known else f"no way to the quantity {quantity_of(setting)}"
