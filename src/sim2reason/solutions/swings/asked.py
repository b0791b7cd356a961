"""Quantities and moments that questions about swings ask for."""

from collections.abc import Collection

from sim2reason.questions.kinds.parts.stretch_kind import StretchQuery
from sim2reason.questions.moments.angles import Deflected, TurnedThrough
from sim2reason.questions.moments.strings import WentSlack
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.questions.moments.turning_points import HighestPoint, LowestPoint, Stopped
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.setting import Setting, capital

MOMENTS = (AtStart, AtTime, Deflected, HighestPoint, LowestPoint, Stopped, TurnedThrough, WentSlack)
EXTREMES = {  # of what is asked over a stretch: the quantity, and whether it is extreme at rest or where it is fastest
    "greatest speed": ("velocity", "fastest"),
    "greatest angular speed": ("angular velocity", "fastest"),
    "greatest kinetic energy": ("kinetic energy", "fastest"),
    "greatest tension": ("tension", "fastest"),
    "greatest rod force": ("rod force", "fastest"),
    "greatest axle force": ("axle force", "fastest"),
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


def turns_back(setting: Setting, noun: str) -> str:
    """Return the words before the law of the turning point of a `noun`, such as *The arm turns back where ...:*."""
    moment, highest = setting.query.moment, ""
    if isinstance(moment, HighestPoint):
        body = setting.called(moment.name)
        highest = " at its highest point," if capital(body) == noun else f", with {body} at its highest point,"
    return f"{noun} turns back{highest} where all kinetic energy has become potential energy:"


def straight(setting: Setting, *, below: bool) -> str:
    """Return a clause about an arm when one of its bodies is at its highest or lowest point, or at another moment."""
    if isinstance(setting.query.moment, LowestPoint | HighestPoint):
        return f"with the centre of mass straight {'below' if below else 'above'} the axle"
    return "at that moment"


def by_energy(setting: Setting, noun: str, name: Symbol, *, extreme: bool, where: str = "") -> str:
    """Return the beginning of a sentence that gives how fast something is at the moment, by conservation of energy.

    With `extreme` it is said before where that is; `where` something else than a single small body is at the moment.
    """
    if extreme and quantity_of(setting) not in PLACES:
        return f"There the {noun} ${name.latex()}$ is given by"
    at, moment = where or "at that moment", setting.query.moment
    if not where and isinstance(moment, LowestPoint | HighestPoint):
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
