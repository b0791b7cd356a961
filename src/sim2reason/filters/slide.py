"""Drops a question for which something slides so far along what carries it that no such board is likely."""

from collections.abc import Iterator

import numpy as np

from sim2reason.filters import FILTERS, Candidate, Filter

FARTHEST = 4.0  # m along a board, a box or a wedge that moves itself


class Slide(Filter):
    """By the time that is asked about something has slid farther than `FARTHEST` on a body that can move.

    Planes that are fixed have no end.
    """

    order = 1

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if a body slides too far along another one before the moment asked about."""
        far = {name: way for name, way in _slides(candidate).items() if way > FARTHEST}
        return next((f"{name} slides {way:.2g} m on what carries it" for name, way in far.items()), "")

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield the sliding distance of each body that slides on another one."""
        yield from (f"{name} slides {way:.3g} m on what carries it" for name, way in _slides(candidate).items())


def _slides(candidate: Candidate) -> dict[str, float]:
    """Return the greatest displacement, in m, of each body relative to the movable body on which it slides."""
    mechanism, trace, until = candidate.study.mechanism, candidate.study.trace, candidate.time
    if until is None:
        return {}
    moving = {body.name for body in mechanism.bodies if body.coordinates}
    riding = [mechanism.body[face.subject] for face in mechanism.faces if not face.turning]
    scan = trace.scan
    within = np.append(np.flatnonzero(scan.times <= until), np.argmin(np.abs(scan.times - until)))
    found: dict[str, float] = {}
    for body in riding:
        slides = [mechanism.number[c.name] for c in body.coordinates if c.kind == "slide"]
        if body.parent in moving and slides:
            ways = scan.q[:, slides] - scan.q[:1, slides]
            found[body.name] = float(np.abs(ways[within]).max(initial=0.0))
    return found


FILTERS.add("slide", Slide())
