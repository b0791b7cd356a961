"""Collisions before the moment that have no influence on the answer, so that the text needs none of their numbers."""

from collections.abc import Set as AbstractSet

from sim2reason.solutions.collisions.impacts import Impacts
from sim2reason.solutions.collisions.legs import Impact
from sim2reason.solutions.setting import capital

SAME = 1e-9  # relative: an impact that comes with the moment itself


def tell_uninvolved(flights: Impacts, bodies: AbstractSet[str]) -> None:
    """Write which earlier collisions the solution omits because they do not affect the given bodies."""
    setting = flights.setting
    early = [impact for impact in flights.impacts if impact.time < setting.time * (1.0 - SAME)]
    left = [held for held in early if held.number not in flights.times and held.number not in flights.struck]
    for impact in left:
        if bodies and bodies.isdisjoint(_affected(impact, early)):
            step = flights.book.open("verify")
            who = setting.listed(sorted(bodies))
            step.say(f"{capital(flights.collision(impact))} does not affect {who} before the moment in question.")
            step.close()


def _affected(first: Impact, impacts: list[Impact]) -> set[str]:
    """Return the bodies whose motion hangs on an impact, by way of those that come later."""
    found = {*first.bodies}
    for impact in impacts:
        if impact.number > first.number and not found.isdisjoint(impact.bodies):
            found |= {*impact.bodies}
    return found
