"""Sentences about the centripetal and tangential components of an acceleration."""

from sim2reason.solutions.algebra.expressions import ZERO, Expression

BOTH = {
    "acceleration": "From the centripetal and tangential components, the acceleration is",
    "net force": "By Newton's second law, with centripetal and tangential acceleration,",
}
AT_START, TURNING = "Just after release", "At a turning point"
VERTICAL = "With the centre of mass straight below or above the axis of rotation"


def of_components(quantity: str, inward: Expression, along: Expression, *, begins: bool) -> str:
    """Return the words before an acceleration or a net force; empty for another quantity.

    `inward` is the centripetal and `along` the tangential acceleration; `begins` says that the motion begins now.
    """
    if quantity not in BOTH or ZERO not in (inward, along) or inward == along:
        return BOTH.get(quantity, "")
    if inward == ZERO:
        when = AT_START if begins else TURNING
        why = f"{when} the angular velocity is zero, so the acceleration is only tangential"
    else:
        why = f"{VERTICAL}, gravity has no tangential component, so the acceleration is only centripetal"
    return f"{why}:" if quantity == "acceleration" else f"{why}; by Newton's second law,"
