"""Why quantities of a swing are extreme at the lowest point, at the highest one or at the turning points."""

from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression
from sim2reason.solutions.algebra.functions import Call, Power, Root
from sim2reason.solutions.writing.comparing import exceeds
from sim2reason.solutions.writing.steps import Book
from sim2reason.solutions.writing.unit_latex import ACCELERATION

Ends = tuple[Expression, Expression, Expression]
"""The tangential acceleration at 90°, the angle at the start from the lowest place, and v²/2gℓ or what is like it."""
FORCES = {"tension": "string", "rod force": "rod"}  # along what each acts
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
    """Return the sentence that a quantity has its greatest or least value somewhere, with the reason.

    A body that `loops` never turns back. For one that does, a comparison shows later at which end its acceleration is
    greatest; in symbols both ends are possible, so that `free` has it assumed.
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


def tell_other_end(book: Book, found: Expression, ends: Ends) -> None:
    """Write the acceleration at the other end of a swing, which is less than the one that was found."""
    pull, first, excess = ends
    cosine = Call("cos", first) if first != ZERO else ONE
    sine = Call("sin", first) if excess == ZERO else Root(ONE - Power(cosine - excess, 2))
    lowest, turning = 2.0 * pull * (ONE - cosine + excess), pull * sine
    less = min(lowest, turning, key=book.value)
    where = "At the lowest point" if less is lowest else "At a turning point"
    step, name = book.open("verify"), book.fresh("a", r"\text{end}")
    exceeds(book, step, found, less)
    step.say(f"{where} the acceleration is {step.verified(name, less, ACCELERATION)}, less than ${found.latex()}$.")
    step.close()
