"""Quantities and moments in questions about swings, and the positions of extreme values."""

from collections.abc import Collection

from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.angles import Deflected, TurnedThrough
from sim2reason.questions.moments.strings import WentSlack
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.questions.moments.turning_points import HighestPoint, LowestPoint, Stopped
from sim2reason.simulation.quantities.positions import HeightAboveStart
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Symbol
from sim2reason.solutions.algebra.functions import Call, Power, Root
from sim2reason.solutions.setting import ProblemContext, capitalized
from sim2reason.solutions.writing.notation import ACCELERATION
from sim2reason.solutions.writing.steps import SolutionBuilder, record_inequality

MOMENTS = (AtStart, AtTime, Deflected, HighestPoint, LowestPoint, Stopped, TurnedThrough, WentSlack)
EXTREMES = {  # by functional: the quantity, and whether it is extreme where the motion is fastest or slowest
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
PLACES = frozenset({"deflection", "height", "displacement"})  # quantities whose greatest value needs no reason


def quantity_of(setting: ProblemContext) -> str:
    """Return the quantity that is asked for, or whose extreme value is asked for."""
    query = setting.query
    if isinstance(query, StretchQuery):
        return EXTREMES[query.functional][0] if query.functional in EXTREMES else query.functional
    named = query.target.quantity if query.target is not None else ""
    return "height" if named == HeightAboveStart.name else named


def turns_back(setting: ProblemContext, noun: str) -> str:
    """Return the words before the law of the turning point of a `noun`, such as *The arm turns back where ...:*."""
    moment, highest = setting.query.moment, ""
    if isinstance(moment, HighestPoint):
        body = setting.display_name(moment.name)
        highest = " at its highest point," if capitalized(body) == noun else f", with {body} at its highest point,"
    return f"{noun} turns back{highest} where all kinetic energy has become potential energy:"


def straight_clause(setting: ProblemContext, *, below: bool) -> str:
    """Return a clause on an arm's position: centre of mass straight below or above the axle, or *at that moment*."""
    if isinstance(setting.query.moment, LowestPoint | HighestPoint):
        return f"with the centre of mass straight {'below' if below else 'above'} the axle"
    return "at that moment"


def by_energy(setting: ProblemContext, noun: str, name: Symbol, *, extreme: bool, where: str = "") -> str:
    """Return the beginning of a sentence that gives a speed at the moment by conservation of energy.

    With `extreme`, an earlier sentence gives the position; `where` is the position of a body that is not a point mass.
    """
    if extreme and quantity_of(setting) not in PLACES:
        return f"There the {noun} ${name.latex()}$ is given by"
    at, moment = where or "at that moment", setting.query.moment
    if not where and isinstance(moment, LowestPoint | HighestPoint):
        at = f"at the {'lowest' if isinstance(moment, LowestPoint) else 'highest'} point"
    return f"By conservation of energy, the {noun} ${name.latex()}$ {at} is given by"


def unsupported_reason(setting: ProblemContext, quantities: Collection[str]) -> str:
    """Return which quantity or moment of a query has no formula, in words; empty if all have one."""
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


COMPONENT_LEADS = {
    "acceleration": "From the centripetal and tangential components, the acceleration is",
    "net force": "By Newton's second law, with centripetal and tangential acceleration,",
}
AT_START, TURNING = "Just after release", "At a turning point"
VERTICAL = "With the centre of mass straight below or above the axis of rotation"


def of_components(quantity: str, inward: Expression, along: Expression, *, begins: bool) -> str:
    """Return the words before an acceleration or net force, which name its components; empty for other quantities.

    `inward` is the centripetal and `along` the tangential acceleration; `begins` is true at the start of the motion.
    """
    if quantity not in COMPONENT_LEADS or ZERO not in (inward, along) or inward == along:
        return COMPONENT_LEADS.get(quantity, "")
    if inward == ZERO:
        when = AT_START if begins else TURNING
        why = f"{when} the angular velocity is zero, so the acceleration is only tangential"
    else:
        why = f"{VERTICAL}, gravity has no tangential component, so the acceleration is only centripetal"
    return f"{why}:" if quantity == "acceleration" else f"{why}; by Newton's second law,"


Ends = tuple[Expression, Expression, Expression]
"""The tangential acceleration at 90°, the initial angle from the lowest position, and v²/2gℓ or its analogue."""
FORCES = {"tension": "string", "rod force": "rod"}  # the connection along which each force acts
QUADRATIC = (
    "By conservation of energy the centripetal acceleration is linear in $\\cos\\varphi$, where $\\varphi$ is the "
    "angle from the lowest position, and the tangential one is proportional to $\\sin\\varphi$. The square of the "
    "acceleration is then quadratic in $\\cos\\varphi$ with a positive leading coefficient, so its greatest value is "
    "at one end of the range"
)
AXLE_FORCE = (
    "By conservation of energy, the component of the force along the line to the centre of mass is linear in "
    "$\\cos\\varphi$, where $\\varphi$ is the angle from the lowest position, and the one perpendicular to it is "
    "proportional to $\\sin\\varphi$ and at most $\\sin\\varphi$ times the weight. The square of the force is then "
    "quadratic in $\\cos\\varphi$ with a positive leading coefficient, so its greatest value is at one end of the "
    "range. In the lowest position the force is at least the weight;"
)
AXLE_TURNS = "at the turning points, without angular velocity, it is at most the weight"
AXLE_LOOPS = "in the highest position the angular velocity is less and the weight acts towards the axle"


def where_extreme(
    quantity: str, noun: str, superlative: str, where: str, *, loops: bool = False, free: bool = False
) -> str:
    """Return the sentence that a quantity is extreme at the position `where`, with the reason.

    A body that `loops` never turns back. Otherwise a later comparison shows at which end the acceleration is greatest;
    in symbols, both ends are possible, and with `free` one is assumed.
    """
    if quantity in FORCES:
        along = f"the component of the weight along the {FORCES[quantity]}, away from the fixed point,"
        thrust = " Where the rod pushes, its thrust is at most the weight, and so no greater."
        thrust = thrust if (quantity, superlative) == ("rod force", "greatest") else ""
        return f"The {noun} is {superlative} {where}, because the speed and {along} are {superlative} there.{thrust}"
    if quantity == "axle force":
        return f"{AXLE_FORCE} {AXLE_LOOPS if loops else AXLE_TURNS}, so it is greatest {where}."
    if quantity == "acceleration":
        if loops:
            return f"{QUADRATIC}. At both ends it is only centripetal, so it is greatest {where}."
        return f"{QUADRATIC}: {'it is assumed to be' if free else 'as the comparison below shows,'} {where}."
    return f"By conservation of energy, the {noun} is {superlative} {where}."


def write_other_end(book: SolutionBuilder, greatest: Expression, ends: Ends) -> None:
    """Write the acceleration at the other end of a swing, which is smaller than the greatest one."""
    pull, first, excess = ends
    cosine = Call("cos", first) if first != ZERO else ONE
    sine = Call("sin", first) if excess == ZERO else Root(ONE - Power(cosine - excess, 2))
    lowest, turning = 2.0 * pull * (ONE - cosine + excess), pull * sine
    less = min(lowest, turning, key=book.value)
    where = "At the lowest point" if less is lowest else "At a turning point"
    step, name = book.begin_step("verify"), book.fresh("a", r"\text{end}")
    record_inequality(book, step, greatest, less)
    step.add_text(
        f"{where} the acceleration is {step.verified(name, less, ACCELERATION)}, less than ${greatest.latex()}$."
    )
    step.close()
