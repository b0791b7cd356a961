"""Why a body that bounces on the ground was not as far from its starting point before its last bounce."""

from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.functions import Absolute, Power, Root, squares
from sim2reason.solutions.collisions.impacts import Impacts
from sim2reason.solutions.collisions.legs import Leg
from sim2reason.solutions.writing.comparing import exceeds
from sim2reason.solutions.writing.unit_latex import METRES

BOUNDS = (("s", r"\text{top}"), ("d", r"\text{max}"))  # names of the highest point and of the greatest distance


def tell_nearer(flights: Impacts, body: str, leg: Leg, distance: Symbol) -> None:
    """Write that a body was nearer than a distance until a flight began: within a box whose corner is too near.

    Nothing rests on it, and nothing is said where the corner is too far, or where numbers are not known.
    """
    impact, begins, book = leg.after, flights.begins(leg), flights.book
    if impact is None or begins is None or impact.bodies != (body,):
        return
    k, _ = flights.ways(flights.mechanism.meetings[impact.meeting])[body]
    level = [j for j in flights.coordinates(body) if j != k]
    if not flights.acceleration(k) or len(level) != 1 or flights.acceleration(level[0]):
        return
    along = flights.place(body, flights.count(body, impact) + 1, level[0], begins).expression()
    drop = flights.gap(impact.meeting).expression()
    top = _top(flights, body, k)
    height = drop if top is None or book.value(top) <= book.value(drop) else top
    corner = Root(squares([along, height]))
    if book.is_hidden(corner) or book.value(corner) >= book.value(distance):
        return
    step, names = book.open("verify"), [book.fresh(base, mark) for base, mark in BOUNDS]
    exceeds(book, step, distance, corner)
    rise = "it never rises above its starting point"
    if top is not None:
        exceeds(book, step, height, ZERO if top == height else top)
        rise = f"it rises to {step.verified(names[0], top, METRES)} above its starting point"
    size = Absolute(along) if book.value(along) < 0.0 else along
    step.say(f"Until ${begins.name}$ the horizontal displacement of {flights.setting.called(body)} is at most")
    step.say(
        f"${size.latex()}$ and, as {rise}, the vertical one at most ${height.latex()}$; so its distance from there"
    )
    step.say(f"is at most {step.verified(names[1], corner, METRES)}, less than ${distance.name}$.")
    step.close()


def _top(flights: Impacts, body: str, k: int) -> Expression | None:
    """Return how far a body first rises; None if it does not."""
    speed, fall = flights.leg(body, 0).speeds[k], flights.acceleration(k).scaled(-2.0)
    rises = bool(speed) and flights.book.value(speed.expression()) > 0.0
    return Power(speed.expression(), 2) / fall.expression() if rises else None
