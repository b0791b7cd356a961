"""Where a motion to and fro turns back, and what its greatest values are of."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.functionals.parts.extreme import Extreme
from sim2reason.questions.kinds.parts.stretch_kind import StretchQuery
from sim2reason.questions.targets import Target
from sim2reason.solutions.book import UnsolvedError
from sim2reason.solutions.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.linear_way import LinearWay
from sim2reason.solutions.polynomials import Polynomial
from sim2reason.solutions.setting import Setting

FINE, LEVELS = 64, 4  # parts of what is searched for a greatest value, and how often
EARLY = 1e-6  # of the stretch: what turns back at its end does not count


def extreme_target(setting: Setting) -> Target | None:
    """The quantity whose greatest value is asked for."""
    query = setting.query
    if not isinstance(query, StretchQuery):
        return None
    held = FUNCTIONALS[query.functional]
    return Target(held.quantity.name, query.name) if isinstance(held, Extreme) else None


def time_of_greatest(setting: Setting) -> float:
    """When the motion takes the greatest value that is asked for, s, near enough for Newton's method."""
    query, trace, low, high = setting.query, setting.study.trace, 0.0, setting.time
    assert isinstance(query, StretchQuery)
    functional, best = FUNCTIONALS[query.functional], high
    assert isinstance(functional, Extreme)
    for level in range(LEVELS):
        times = np.linspace(low, high, FINE * (8 if level == 0 else 1) + 1)
        best = float(times[int(np.argmax(functional.height(trace.sample(times), query.name)))])
        width = 2.0 * (times[1] - times[0])
        low, high = max(0.0, best - width), min(setting.time, best + width)
    return best


@dataclass(frozen=True, slots=True)
class Travelled:
    """A motion to and fro between places of a free coordinate, whatever acts on the way."""

    way: LinearWay
    places: Sequence[Expression]

    @property
    def time(self) -> Symbol:
        """It changes nothing."""
        raise UnsolvedError("no force that is constant")

    def force(self, kind: str, name: str) -> Polynomial:
        """None that is constant."""
        raise UnsolvedError(f"no {kind} of {name} that is constant")

    def moved(self, body: str, line: str) -> Polynomial:
        """Along a line."""
        raise UnsolvedError(f"no way of {body} along {line}")

    def slipped(self, body: str) -> Polynomial:
        """On a face."""
        raise UnsolvedError(f"no slip of {body}")

    def drawn(self, line: str) -> Polynomial:
        """Of a line."""
        raise UnsolvedError(f"no change of {line}")

    def path(self, body: str) -> Expression:
        """The sum of all ways without their signs."""
        own, book, found = self.way.moving([body]), self.way.book, ZERO
        if len(own) != 1 or len(self.way.motion.ratios[own[0]]) != 1:
            raise UnsolvedError("its path is no line of its own")
        (part,) = self.way.motion.ratios[own[0]].values()
        for one, other in pairwise(self.places):
            apart = other - one if one != ZERO else other
            found = found + (apart if book.value(apart) >= 0.0 else -apart)
        return found * abs(part) if abs(part) != 1.0 else found
